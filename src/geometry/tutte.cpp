#include "geometry/tutte.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alphamst::geometry {

Tutte::Tutte(const Stars &stars, std::span<const char> fixed)
    : stars_(stars), index_(static_cast<std::size_t>(stars.vertices()), -1) {
    for (int v = 0; v < stars.vertices(); ++v)
        if (!fixed[static_cast<std::size_t>(v)] && !stars.at(v).empty()) {
            index_[static_cast<std::size_t>(v)] = static_cast<int>(free_.size());
            free_.push_back(v);
        }
    // Lower triangle by columns, rows ascending, written straight into compressed form.
    const auto n = static_cast<Eigen::Index>(free_.size());
    std::vector<int> start{0}, rows;
    std::vector<double> values;
    for (std::size_t column = 0; column < free_.size(); ++column) {
        const auto star = stars.at(free_[column]);
        const std::size_t diagonal = rows.size();
        rows.push_back(static_cast<int>(column));
        for (const Sector &s : star)
            if (const int row = index_[static_cast<std::size_t>(s.next)]; row > static_cast<int>(column))
                rows.push_back(row);
        std::sort(rows.begin() + static_cast<std::ptrdiff_t>(diagonal), rows.end());
        values.resize(rows.size(), -1.0);
        values[diagonal] = static_cast<double>(star.size());
        start.push_back(static_cast<int>(rows.size()));
    }
    if (n > 0)
        factor_.compute(Eigen::Map<const Eigen::SparseMatrix<double>>(
            n, n, static_cast<Eigen::Index>(rows.size()), start.data(), rows.data(), values.data()));
}

bool Tutte::solve(Points &points) const {
    if (free_.empty())
        return true;
    if (factor_.info() != Eigen::Success)
        return false;
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(static_cast<Eigen::Index>(free_.size()), 2);
    for (std::size_t i = 0; i < free_.size(); ++i)
        for (const Sector &s : stars_.at(free_[i]))
            if (index_[static_cast<std::size_t>(s.next)] < 0)
                right.row(static_cast<Eigen::Index>(i)) +=
                    points[static_cast<std::size_t>(s.next)].transpose();
    const Eigen::MatrixX2d solution = factor_.solve(right);
    if (!solution.allFinite())
        return false;
    for (std::size_t i = 0; i < free_.size(); ++i)
        points[static_cast<std::size_t>(free_[i])] = solution.row(static_cast<Eigen::Index>(i)).transpose();
    return true;
}

Points loop_on_circle(std::span<const double> lengths) {
    std::vector<double> along;
    double length = 0;
    for (const double edge : lengths) {
        along.push_back(length);
        length += edge;
    }
    Points circle;
    const double radius = length / (2 * std::numbers::pi);
    for (const double s : along)
        circle.emplace_back(radius * std::cos(s / radius), radius * std::sin(s / radius));
    return circle;
}

Points embed_in_loop(Quads quads, int vertices, std::span<const Eigen::Vector2d> loop) {
    const Stars stars(quads, vertices);
    std::vector<char> fixed(static_cast<std::size_t>(vertices), 0);
    std::fill_n(fixed.begin(), loop.size(), char(1));
    Points points(loop.begin(), loop.end());
    points.resize(static_cast<std::size_t>(vertices), Eigen::Vector2d::Zero());
    Tutte(stars, fixed).solve(points);
    return points;
}

Points embed_on_circle(Quads quads, int boundary, int vertices, std::span<const double> lengths) {
    const Points loop = loop_on_circle(lengths.first(static_cast<std::size_t>(boundary)));
    return embed_in_loop(quads, vertices, loop);
}

} // namespace alphamst::geometry
