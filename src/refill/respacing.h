// Other vertices on the parts of a window's loop that lie on the boundary of the mesh.
#pragma once

#include <optional>
#include <vector>

#include "patch/window.h"
#include "reference/boundary.h"

namespace alphamst::refill {

class Respacing {
public:
    // All but the last must outlive it. tolerance: of the distance between curve and edges, in wanted edges.
    // held: vertices that stay.
    Respacing(const mesh::QuadMesh &mesh, const patch::Window &window, const reference::Boundary &boundary,
              const reference::EdgeLength &edge_length, double tolerance, std::span<const int> held = {});

    using Counts = std::vector<int>; // [run] edges

    double present_error() const; // rms of log2(length / wanted length) of the edges that are there

    bool empty() const { return runs_.empty(); }
    // Those that are there with one edge or two more or less in one run or in two, the loop having an even
    // number; the best first by what is wanted, and only such as are not far from that, or nearer to it than
    // what is there. wished: lengths are those that a caller asks for.
    std::vector<Counts> near(bool wished) const;
    // What is wanted everywhere, then parts of the way there; only such as are far better than what is there.
    std::vector<Counts> towards() const;

    // The window with other vertices where counts differ from those that are there, or wherever lengths are
    // not fine. Nothing
    // where the curve would be missed, or another part of the boundary met.
    std::optional<patch::Window> window(const Counts &counts, bool everywhere) const;

private:
    // A part of the loop between two vertices that stay.
    struct Run {
        std::size_t first = 0; // place in the loop
        int edges = 0;
        surface::CurvePlace from;
        double length = 0, wanted = 0;   // wanted: edges
        std::vector<double> wanted_till; // [sample] edges from the first vertex on
        double error = 0, worst = 0;     // of what is there, of all edges and of one
        bool fine = false;               // it may stay as it is
    };
    // New vertices of a run, strictly between its ends.
    using Places = std::vector<surface::CurvePlace>;

    void find_runs(std::span<const int> held);
    void measure(Run &run) const;
    double error(const Run &run, int edges) const;
    double error(const Counts &counts) const;
    bool changes(std::size_t run, const Counts &counts, bool everywhere) const {
        return counts[run] != runs_[run].edges || (everywhere && !runs_[run].fine);
    }
    int parity(const Counts &counts) const;
    void make_even(Counts &counts) const;
    std::vector<double> lengths(const Run &run, int edges) const; // from its start to each vertex
    std::optional<Places> places(const Run &run, int edges) const;
    void keep(std::size_t i, int parent, patch::Window &changed) const;
    int parent(const Run &run, double along) const;
    bool add(const Run &run, int edges, patch::Window &changed) const;
    void set_angles(patch::Window &window) const;

    const mesh::QuadMesh &mesh_;
    const patch::Window &window_;
    const reference::Boundary &boundary_;
    const reference::EdgeLength &edge_length_;
    const double tolerance_;
    std::vector<Run> runs_;
};

// Points of the loop of a window, new ones included.
std::vector<Eigen::Vector3d> loop_points(const mesh::QuadMesh &mesh, const patch::Window &window);

} // namespace alphamst::refill
