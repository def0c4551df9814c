// Curves: the polylines that the features of a mesh keep to, as the straight lines they consist of.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <span>
#include <vector>

namespace alphamst::surface {

struct Line {
    Eigen::Vector3d start = Eigen::Vector3d::Zero(), end = Eigen::Vector3d::Zero();

    // Of the point of the infinite line that is nearest: 0 at the start, 1 at the end; 0 without length.
    double place(const Eigen::Vector3d &p) const;
    Eigen::Vector3d at(double place) const { return start + place * (end - start); }
    double distance(const Eigen::Vector3d &p) const; // from the line between start and end
    Line reversed() const { return {end, start}; }
};

// Const and safe for any number of threads once made. Who moves on them asks for a line that holds the point
// and its neighbours, and stays between these: so there is no way from one curve to another.
class Curves {
public:
    // Edges, by the ids of their points, are joined where two of them meet and nothing bends: all points on
    // the way are within the tolerance of the line, which is there for rounding. Given lines come first.
    Curves(std::span<const Eigen::Vector3d> points, std::span<const std::array<int, 2>> edges,
           double tolerance, std::vector<Line> given = {});
    Curves(const Curves &) = delete;
    Curves &operator=(const Curves &) = delete;
    ~Curves();

    // The first line with all the points within the tolerance, -1 if there is none.
    int find(std::span<const Eigen::Vector3d> points) const;
    const std::vector<Line> &lines() const { return lines_; }
    double tolerance() const { return tolerance_; } // with the lines as given ones it makes equal curves

    // The numbers of the lines that lead from one point to another: one that holds both, or those of a way.
    std::vector<int> lines_between(const Eigen::Vector3d &from, const Eigen::Vector3d &to) const;
    // The lines that lead from one point to the other, each from its start to its end, which bend by no more
    // than 30 degrees where one ends and one other starts; the fewest of them. Empty if there are none, or if
    // that is a detour.
    std::vector<Line> way(const Eigen::Vector3d &from, const Eigen::Vector3d &to) const;
    // As well, by way of a point between the two, and beyond them as far as it is from there to them.
    std::vector<Line> way_through(const Eigen::Vector3d &from, const Eigen::Vector3d &between,
                                  const Eigen::Vector3d &to) const;

private:
    struct Tree;
    struct Step { // a line and whether it is passed from its end to its start
        int line = -1;
        bool back = false;
    };

    void add_straight(std::span<const Eigen::Vector3d> way);
    void join();
    Line passed(Step step) const;
    Step after(Step step) const; // line -1: none
    std::vector<Step> steps(const Eigen::Vector3d &from, const Eigen::Vector3d &to) const;
    void go_on(std::vector<Step> &steps, double length) const;
    template <class Look> void at_point(const Eigen::Vector3d &p, Look &&look) const;

    double tolerance_;
    std::vector<Line> lines_;
    std::vector<std::array<Step, 2>> joined_; // [line][at its end, at its start] the next one from there
    std::unique_ptr<const Tree> tree_;
};

} // namespace alphamst::surface
