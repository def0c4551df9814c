#include <random>

#include "patch/decompose.h"
#include "patch/flood.h"

namespace alphamst::patch {
namespace {

// Mean length of the links at every node.
std::vector<double> spacing(const FaceDual &dual) {
    std::vector<double> result(dual.size(), 1);
    for (std::size_t i = 0; i < dual.size(); ++i) {
        double sum = 0;
        for (const std::int32_t next : dual.neighbours(i))
            sum += dual.length(i, static_cast<std::size_t>(next));
        if (sum > 0)
            result[i] = sum / static_cast<double>(dual.neighbours(i).size());
    }
    return result;
}

// Centres: from a random node on, always the one that is farthest from those before (Eldar,
// Lindenbaum, Porat and Zeevi 1997; on meshes Peyre and Cohen 2006). Far is measured in faces,
// so that a cell has about as many where the mesh is fine as where it is coarse.
std::vector<Flood::Start> centres(const FaceDual &dual, std::size_t n, std::uint64_t seed, const Pace &pace) {
    std::mt19937_64 random(seed);
    const std::vector<double> size = spacing(dual);
    Flood flood(dual, pace);
    const auto in_faces = [&](std::size_t node, std::size_t next, std::size_t) {
        return flood.distance(node) + 2 * dual.length(node, next) / (size[node] + size[next]);
    };
    std::vector<Flood::Start> result;
    std::optional<std::size_t> node = static_cast<std::size_t>(random() % dual.size());
    for (std::size_t source = 0; source < n && node; ++source) {
        result.push_back({0, *node, source});
        flood.add(std::span(result).last(1), in_faces);
        node = flood.farthest();
    }
    return result;
}

std::vector<std::size_t> cells(const FaceDual &dual, std::size_t n, std::uint64_t seed, const Pace &pace) {
    Flood flood(dual, pace);
    flood.add(centres(dual, n, seed, pace), [&](std::size_t node, std::size_t next, std::size_t) {
        return flood.distance(node) + dual.length(node, next);
    });
    std::vector<std::size_t> group(dual.size());
    for (std::size_t i = 0; i < dual.size(); ++i)
        group[i] = flood.source(i);
    return group;
}

} // namespace

Groups voronoi_cells(const mesh::QuadMesh &mesh, double size, std::uint64_t seed, Taken taken,
                     const Pace &pace) {
    return decompose(
        mesh, size, taken,
        [&](const FaceDual &dual, std::size_t n, const Pace &part) { return cells(dual, n, seed, part); },
        pace);
}

} // namespace alphamst::patch
