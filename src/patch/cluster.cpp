#include <algorithm>
#include <limits>
#include <queue>
#include <random>
#include <tuple>

#include "patch/decompose.h"

namespace alphamst::patch {
namespace {

struct Centre {
    std::size_t node = 0;
    OpenMesh::Vec3d mean{0, 0, 0}; // of the group's centroids
    double spacing = 1;            // of the faces there
};

// Group of every node: floods from all centres at once, the node nearest to its centre
// first (Cohen-Steiner, Alliez and Desbrun 2004), so that groups are connected and, where
// the mesh is flat, nearly Voronoi cells. Measured in faces rather than in lengths.
std::vector<std::size_t> flood(const FaceDual &dual, const std::vector<Centre> &centres, const Pace &pace) {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    using Step = std::tuple<double, std::size_t, std::size_t>; // distance, node, group
    std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
    std::vector<std::size_t> group(dual.size(), none);
    for (std::size_t g = 0; g < centres.size(); ++g)
        front.push({0, centres[g].node, g});
    while (!front.empty()) {
        const auto [distance, node, g] = front.top();
        front.pop();
        pace.step();
        if (group[node] != none)
            continue;
        group[node] = g;
        for (const std::int32_t link : dual.neighbours(node)) {
            const auto next = static_cast<std::size_t>(link);
            if (group[next] != none)
                continue;
            front.push({(dual.centroids[next] - centres[g].mean).norm() / centres[g].spacing, next, g});
        }
    }
    return group;
}

// In each group the node nearest to the mean of its centroids.
std::vector<Centre> recentre(const FaceDual &dual, const std::vector<std::size_t> &group, std::size_t n) {
    std::vector<Centre> centres(n);
    std::vector<double> count(n, 0), links(n, 0), lengths(n, 0);
    for (std::size_t i = 0; i < dual.size(); ++i) {
        const std::size_t g = group[i];
        centres[g].mean += dual.centroids[i];
        count[g] += 1;
        for (const std::int32_t next : dual.neighbours(i)) {
            lengths[g] += dual.length(i, static_cast<std::size_t>(next));
            links[g] += 1;
        }
    }
    for (std::size_t g = 0; g < n; ++g) {
        centres[g].mean /= count[g];
        if (lengths[g] > 0)
            centres[g].spacing = lengths[g] / links[g];
    }
    std::vector<double> least(n, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < dual.size(); ++i) {
        const double distance = (dual.centroids[i] - centres[group[i]].mean).sqrnorm();
        if (distance < least[group[i]]) {
            least[group[i]] = distance;
            centres[group[i]].node = i;
        }
    }
    return centres;
}

} // namespace

std::vector<std::size_t> lloyd(const FaceDual &dual, std::size_t n, std::uint64_t seed, const Pace &pace) {
    constexpr int rounds = 20;
    std::mt19937_64 random(seed);
    // A part of a Fisher-Yates shuffle; the distributions of the standard library differ
    // between platforms.
    std::vector<std::size_t> seeds(dual.size());
    for (std::size_t i = 0; i < seeds.size(); ++i)
        seeds[i] = i;
    for (std::size_t i = 0; i < n; ++i)
        std::swap(seeds[i], seeds[i + static_cast<std::size_t>(random() % (seeds.size() - i))]);

    std::vector<Centre> centres(n);
    for (std::size_t g = 0; g < n; ++g)
        centres[g] = {seeds[g], dual.centroids[seeds[g]], 1};

    std::vector<std::size_t> group = flood(dual, centres, pace);
    for (int round = 0; round < rounds; ++round) {
        pace.reach(static_cast<double>(round) / rounds);
        const std::vector<Centre> moved = recentre(dual, group, n);
        const bool still = std::equal(moved.begin(), moved.end(), centres.begin(),
                                      [](const Centre &a, const Centre &b) { return a.node == b.node; });
        centres = moved;
        group = flood(dual, centres, pace);
        if (still)
            break;
    }
    return group;
}

Groups clusters(const mesh::QuadMesh &mesh, double size, std::uint64_t seed, Taken taken, const Pace &pace) {
    return decompose(
        mesh, size, taken,
        [&](const FaceDual &dual, std::size_t n, const Pace &part) { return lloyd(dual, n, seed, part); },
        pace);
}

} // namespace alphamst::patch
