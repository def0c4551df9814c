#include "geometry/unfold.h"

#include <algorithm>

namespace alphamst::geometry {

void unfold(std::span<const Sector> star, std::span<const Eigen::Vector3d> points, int vertex,
            const FeatureLine &feature_line, std::vector<Sector> &sectors, Points &flat) {
    const auto at = [&](int v) -> const Eigen::Vector3d & { return points[static_cast<std::size_t>(v)]; };
    const auto [behind, ahead] = feature_line.between;
    const Eigen::Vector3d along = (at(ahead) - at(behind)).normalized();
    sectors.clear();
    flat.assign(1, Eigen::Vector2d::Zero());
    int from = ahead;
    bool left = true; // counter-clockwise from the vertex ahead to the one behind
    for (std::size_t i = 0; i < star.size(); ++i) {
        const auto s =
            std::find_if(star.begin(), star.end(), [&](auto &other) { return other.next == from; });
        if (s == star.end())
            break;
        const int first = static_cast<int>(flat.size());
        for (const int w : {s->next, s->opposite, s->previous}) {
            const Eigen::Vector3d away = at(w) - at(vertex);
            const double x = away.dot(along), y = (away - x * along).norm();
            flat.emplace_back(x, left ? y : -y);
        }
        sectors.push_back({first, first + 1, first + 2, s->quad});
        from = s->previous;
        left = left && from != behind;
    }
    if (sectors.size() != star.size() || from != ahead || left)
        sectors.clear();
}

} // namespace alphamst::geometry
