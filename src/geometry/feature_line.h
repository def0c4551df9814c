// FeatureLine: the line that a vertex on a surface may slide along, straight or bent.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "surface/curve.h"

namespace alphamst::geometry {

struct FeatureLine {
    std::vector<surface::Line> lines; // from the first neighbour to the other, if there is more than one
    std::array<int, 2> between = {
        -1, -1};          // its neighbours on the line, not to be passed; -1: there is no feature line
    double tolerance = 0; // that bends may be off the edges to the neighbours, in lengths of these

    explicit operator bool() const { return between[0] >= 0; }

    // The number of the line, and how far on it the point is that is nearest.
    double place(const Eigen::Vector3d &p) const {
        if (lines.size() == 1)
            return lines[0].place(p);
        double nearest = std::numeric_limits<double>::infinity(), found = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double on_line = std::clamp(lines[i].place(p), 0.0, 1.0);
            if (const double distance = (lines[i].at(on_line) - p).squaredNorm(); distance < nearest) {
                nearest = distance;
                found = static_cast<double>(i) + on_line;
            }
        }
        return found;
    }
    Eigen::Vector3d at(double place) const {
        const auto last = static_cast<double>(lines.size() - 1);
        const double i = std::clamp(std::floor(place), 0.0, last);
        return lines[static_cast<std::size_t>(i)].at(place - i);
    }

    // Where lines may bend: nearer to one of the two than it was, and than is good. Angles alone often gain
    // so, one edge after the other, until their lengths are nothing.
    bool squeezes(const Eigen::Vector3d &before, const Eigen::Vector3d &now,
                  std::span<const Eigen::Vector3d> points) const {
        constexpr double least_part = 0.25; // of the way between the two
        const Eigen::Vector3d &one = points[static_cast<std::size_t>(between[0])],
                              &other = points[static_cast<std::size_t>(between[1])];
        const auto nearest = [&](const Eigen::Vector3d &p) {
            return std::min((p - one).norm(), (p - other).norm());
        };
        return tolerance > 0 && nearest(now) < least_part * (other - one).norm() &&
               nearest(now) < nearest(before);
    }

    // Strictly between the two, whichever of them comes first, and not too far from the bends there.
    bool holds(const Eigen::Vector3d &p, std::span<const Eigen::Vector3d> points) const {
        const Eigen::Vector3d &one = points[static_cast<std::size_t>(between[0])],
                              &other = points[static_cast<std::size_t>(between[1])];
        const double here = place(p), from = place(one), to = place(other);
        if (!(std::min(from, to) < here && here < std::max(from, to)))
            return false;
        for (std::size_t i = 1; i < lines.size(); ++i)
            if (const auto bend = static_cast<double>(i); from < bend && bend < to) {
                const surface::Line edge{p, bend < here ? one : other};
                if (edge.distance(lines[i].start) > tolerance * (edge.end - edge.start).norm())
                    return false;
            }
        return true;
    }
};

} // namespace alphamst::geometry
