#include "transfer/conserve.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "disjoint_sets.h"
#include "index.h"

namespace alphamst::transfer {
namespace {

// Part of the area of a region that rounding changes.
constexpr double rounding_of_area = 1e-11;
// Part of the sum that averages miss in the plane by rounding; it is not worth another bit.
constexpr double rounding = 1e-13;

struct Sum {
    double value = 0, size = 0, area = 0; // of value * area, |value| * area, area
};

} // namespace

Regions::Regions(const Cells &before, const Cells &after, const Changed &changed) {
    const std::size_t n_before = at(before.mesh().n_vertices());
    const auto old_vertex = [](int v) { return at(v); };
    const auto new_vertex = [&](int v) {
        const std::int32_t origin = after.mesh().vertex_origin[at(v)];
        return origin >= 0 ? at(origin) : n_before + at(v);
    };
    // Vertices that faces join, by the number of a vertex before the operation, or behind those, after it.
    DisjointSets sets(n_before + at(after.mesh().n_vertices()));
    const auto join = [&](const mesh::QuadMesh &mesh, const std::vector<int> &faces, const auto &vertex) {
        for (const int f : faces)
            for (const int v : mesh.corners(f))
                sets.unite(vertex(mesh.corners(f)[0]), vertex(v));
    };
    join(before.mesh(), changed.before, old_vertex);
    join(after.mesh(), changed.after, new_vertex);
    const auto list = [&](const Cells &cells, const std::vector<int> &faces, const auto &vertex) {
        std::vector<Part> parts;
        for (const int cell : cells.of(faces)) {
            const int v = cells.entity() == Entity::face ? cells.mesh().corners(cell)[0] : cell;
            parts.push_back({cell, sets.find(vertex(v)), cells.area(cell)});
        }
        return parts;
    };
    before_ = list(before, changed.before, old_vertex);
    after_ = list(after, changed.after, new_vertex);

    // 0 for the sets of one mesh only, 1, 2, ... for the others.
    std::vector<std::size_t> olds, news, both;
    for (const Part &part : before_)
        olds.push_back(part.region);
    for (const Part &part : after_)
        news.push_back(part.region);
    for (std::vector<std::size_t> *regions : {&olds, &news}) {
        std::sort(regions->begin(), regions->end());
        regions->erase(std::unique(regions->begin(), regions->end()), regions->end());
    }
    std::set_intersection(olds.begin(), olds.end(), news.begin(), news.end(), std::back_inserter(both));
    for (std::vector<Part> *parts : {&before_, &after_})
        for (Part &part : *parts) {
            const auto place = std::lower_bound(both.begin(), both.end(), part.region);
            const bool found = place != both.end() && *place == part.region;
            part.region = found ? 1 + static_cast<std::size_t>(place - both.begin()) : 0;
        }
    count_ = 1 + both.size();
    may_gain_ = after.mesh().boundary != nullptr && after.mesh().surface == nullptr;
}

void Regions::conserve(std::span<const double> old_values, std::span<double> values, int components) const {
    const std::size_t width = at(components);
    for (std::size_t c = 0; c < width; ++c) {
        const auto sums = [&](const std::vector<Part> &parts, std::span<const double> from) {
            std::vector<Sum> result(count_);
            for (const auto &[cell, region, area] : parts) {
                const double value = from[at(cell) * width + c];
                result[region].value += value * area;
                result[region].size += std::abs(value * area);
                result[region].area += area;
            }
            return result;
        };
        const std::vector<Sum> wanted = sums(before_, old_values), found = sums(after_, values);
        for (const auto &[cell, region, area] : after_) {
            const double ratio = found[region].area / wanted[region].area;
            const bool changed = may_gain_ && std::abs(ratio - 1) > rounding_of_area && std::isfinite(ratio);
            const double missing = wanted[region].value * (changed ? ratio : 1) - found[region].value;
            if (std::abs(missing) <= rounding * wanted[region].size)
                continue;
            double &value = values[at(cell) * width + c];
            if (found[region].size > 0)
                value += std::copysign(value, area) * (missing / found[region].size);
            else if (found[region].area > 0)
                value += missing / found[region].area;
        }
    }
}

} // namespace alphamst::transfer
