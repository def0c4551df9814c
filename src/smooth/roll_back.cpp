#include "smooth/roll_back.h"

#include "geometry/star.h"
#include "index.h"

namespace alphamst::smooth {
namespace {

bool passed(const geometry::SurfacePositions &on_surface,
            std::span<const geometry::FeatureLine> feature_lines, int v) {
    return feature_lines[at(v)] && !feature_lines[at(v)].holds(on_surface.points[at(v)], on_surface.points);
}

} // namespace

bool roll_back(geometry::Quads quads, const geometry::SurfacePositions &start,
               geometry::SurfacePositions &on_surface, std::span<const geometry::FeatureLine> feature_lines,
               const std::function<std::vector<int>()> &spoiled) {
    // At last 29 layers around a spoiled quad are as they were: if it still is spoiled, it stays so.
    constexpr int most_rounds = 8;
    const std::size_t vertices = start.points.size();
    const geometry::Stars stars(quads, static_cast<int>(vertices));
    const std::vector<char> none(vertices, 0); // what is fixed is on the way, too
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<int> back;
        std::vector<char> member(vertices, 0);
        const auto add = [&](int v) {
            if (!member[at(v)])
                back.push_back(v);
            member[at(v)] = 1;
        };
        for (const int q : spoiled())
            for (const int v : quads[at(q)])
                add(v);
        for (int v = 0; v < static_cast<int>(feature_lines.size()); ++v)
            if (passed(on_surface, feature_lines, v))
                for (const geometry::Sector &s : stars.at(v))
                    for (const int w : quads[at(s.quad)])
                        add(w);
        if (back.empty())
            return true;
        geometry::grow(stars, none, 1 + round * (round + 1) / 2, back, member);
        for (const int v : back)
            on_surface.put(v, {start.surface_triangles[at(v)], start.points[at(v)], start.normals[at(v)], 0});
    }
    return false;
}

} // namespace alphamst::smooth
