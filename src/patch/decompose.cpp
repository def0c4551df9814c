#include "patch/patches.h"
#include "patch/region.h"

#include <cmath>
#include <limits>
#include <metis.h>
#include <mutex>
#include <queue>
#include <random>
#include <tuple>

namespace alphamst::patch {
namespace {

// The dual graph of an edge-connected set of faces: a node is a face, by its place in
// `faces`, a link an edge that is no barrier.
struct Dual {
    std::vector<int> faces;
    std::vector<idx_t> start, links; // those of node i: links[start[i]] .. links[start[i + 1] - 1]

    Dual(const mesh::QuadMesh &mesh, std::vector<int> part) : faces(std::move(part)), start{0} {
        for (const int face : faces) {
            for (const Halfedge h : halfedges_of(mesh, face)) {
                const int next = right(mesh, h);
                const auto it = std::lower_bound(faces.begin(), faces.end(), next);
                if (it != faces.end() && *it == next && !barrier(mesh, h))
                    links.push_back(static_cast<idx_t>(it - faces.begin()));
            }
            start.push_back(static_cast<idx_t>(links.size()));
        }
    }

    std::size_t size() const { return faces.size(); }
    std::span<const idx_t> neighbours(std::size_t node) const {
        const auto first = static_cast<std::size_t>(start[node]),
                   last = static_cast<std::size_t>(start[node + 1]);
        return std::span(links).subspan(first, last - first);
    }
};

std::vector<Dual> duals(const mesh::QuadMesh &mesh, Taken taken) {
    std::vector<int> free;
    for (int face = 0; face < mesh.n_faces(); ++face)
        if (taken.empty() || !taken[static_cast<std::size_t>(face)])
            free.push_back(face);
    std::vector<Dual> result;
    for (auto &part : parts(mesh, free, false))
        result.emplace_back(mesh, std::move(part));
    return result;
}

std::size_t n_groups(const Dual &dual, double size) {
    const double wanted = std::round(static_cast<double>(dual.size()) / std::max(size, 1.0));
    return static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(dual.size())));
}

struct Centre {
    std::size_t node = 0;
    OpenMesh::Vec3d mean{0, 0, 0}; // of the group's centroids
    double spacing = 1;            // of the faces there
};

// Group of every node: floods from all centres at once, the node nearest to its centre
// first (Cohen-Steiner, Alliez and Desbrun 2004), so that groups are connected and, where
// the mesh is flat, nearly Voronoi cells. Measured in faces rather than in lengths.
std::vector<std::size_t> flood(const Dual &dual, const std::vector<OpenMesh::Vec3d> &centroids,
                               const std::vector<Centre> &centres) {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    using Step = std::tuple<double, std::size_t, std::size_t>; // distance, node, group
    std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
    std::vector<std::size_t> group(dual.size(), none);
    for (std::size_t g = 0; g < centres.size(); ++g)
        front.push({0, centres[g].node, g});
    while (!front.empty()) {
        const auto [distance, node, g] = front.top();
        front.pop();
        if (group[node] != none)
            continue;
        group[node] = g;
        for (const idx_t link : dual.neighbours(node)) {
            const auto next = static_cast<std::size_t>(link);
            if (group[next] != none)
                continue;
            front.push({(centroids[next] - centres[g].mean).norm() / centres[g].spacing, next, g});
        }
    }
    return group;
}

// In each group the node nearest to the mean of its centroids.
std::vector<Centre> recentre(const Dual &dual, const std::vector<OpenMesh::Vec3d> &centroids,
                             const std::vector<std::size_t> &group, std::size_t n) {
    std::vector<Centre> centres(n);
    std::vector<double> count(n, 0), links(n, 0), lengths(n, 0);
    for (std::size_t i = 0; i < dual.size(); ++i) {
        const std::size_t g = group[i];
        centres[g].mean += centroids[i];
        count[g] += 1;
        for (const idx_t next : dual.neighbours(i)) {
            lengths[g] += (centroids[static_cast<std::size_t>(next)] - centroids[i]).norm();
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
        const double distance = (centroids[i] - centres[group[i]].mean).sqrnorm();
        if (distance < least[group[i]]) {
            least[group[i]] = distance;
            centres[group[i]].node = i;
        }
    }
    return centres;
}

// Lloyd (1982) on the graph, from random nodes.
std::vector<std::size_t> lloyd(const mesh::QuadMesh &mesh, const Dual &dual, std::size_t n,
                               std::uint64_t seed) {
    constexpr int rounds = 20;
    std::mt19937_64 random(seed);
    std::vector<OpenMesh::Vec3d> centroids;
    for (const int face : dual.faces)
        centroids.push_back(centroid(mesh, face));

    // A part of a Fisher-Yates shuffle; the distributions of the standard library differ
    // between platforms.
    std::vector<std::size_t> seeds(dual.size());
    for (std::size_t i = 0; i < seeds.size(); ++i)
        seeds[i] = i;
    for (std::size_t i = 0; i < n; ++i)
        std::swap(seeds[i], seeds[i + static_cast<std::size_t>(random() % (seeds.size() - i))]);

    std::vector<Centre> centres(n);
    for (std::size_t g = 0; g < n; ++g)
        centres[g] = {seeds[g], centroids[seeds[g]], 1};

    std::vector<std::size_t> group = flood(dual, centroids, centres);
    for (int round = 0; round < rounds; ++round) {
        const std::vector<Centre> moved = recentre(dual, centroids, group, n);
        const bool still = std::equal(moved.begin(), moved.end(), centres.begin(),
                                      [](const Centre &a, const Centre &b) { return a.node == b.node; });
        centres = moved;
        group = flood(dual, centroids, centres);
        if (still)
            break;
    }
    return group;
}

std::vector<std::size_t> metis(Dual &dual, std::size_t n, std::uint64_t seed) {
    if (n == 1)
        return std::vector<std::size_t>(dual.size(), 0);
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = static_cast<idx_t>(seed & 0x7fffffff);
    options[METIS_OPTION_CONTIG] = 1;
    idx_t nodes = static_cast<idx_t>(dual.size()), constraints = 1, wanted = static_cast<idx_t>(n), cut = 0;
    std::vector<idx_t> group(dual.size());
    static std::mutex alone; // METIS draws from the random numbers of the C library
    const std::lock_guard lock(alone);
    if (METIS_PartGraphKway(&nodes, &constraints, dual.start.data(), dual.links.data(), nullptr, nullptr,
                            nullptr, &wanted, nullptr, nullptr, options, &cut, group.data()) != METIS_OK)
        throw Failure(Fault::internal, "METIS could not partition the mesh");
    return std::vector<std::size_t>(group.begin(), group.end());
}

// A disk of each group. Faces of other groups are taken; those that were dropped are not.
std::vector<std::vector<int>> disks(const mesh::QuadMesh &mesh, const std::vector<std::vector<int>> &groups,
                                    Taken taken) {
    std::vector<char> used(static_cast<std::size_t>(mesh.n_faces()), 0);
    std::copy(taken.begin(), taken.end(), used.begin());
    const auto mark = [&](const std::vector<int> &faces, char value) {
        for (const int face : faces)
            used[static_cast<std::size_t>(face)] = value;
    };
    for (const auto &group : groups)
        mark(group, 1);
    std::vector<std::vector<int>> result;
    for (const auto &group : groups) {
        mark(group, 0);
        std::vector<int> disk = repair(mesh, group, used);
        mark(disk, 1);
        if (!disk.empty())
            result.push_back(std::move(disk));
    }
    return result;
}

template <class Divide>
std::vector<std::vector<int>> decompose(const mesh::QuadMesh &mesh, double size, Taken taken, Divide divide) {
    std::vector<std::vector<int>> groups;
    for (Dual &dual : duals(mesh, taken)) {
        const std::size_t n = n_groups(dual, size), first = groups.size();
        const std::vector<std::size_t> group = divide(dual, n);
        groups.resize(first + n);
        for (std::size_t i = 0; i < dual.size(); ++i)
            groups[first + group[i]].push_back(dual.faces[i]);
    }
    return disks(mesh, groups, taken);
}

} // namespace

std::vector<std::vector<int>> clusters(const mesh::QuadMesh &mesh, double size, std::uint64_t seed,
                                       Taken taken) {
    return decompose(mesh, size, taken,
                     [&](Dual &dual, std::size_t n) { return lloyd(mesh, dual, n, seed); });
}

std::vector<std::vector<int>> partition(const mesh::QuadMesh &mesh, double size, std::uint64_t seed,
                                        Taken taken) {
    // METIS makes empty parts, and prints that it does, where parts are of a few nodes.
    return decompose(mesh, size, taken, [&](Dual &dual, std::size_t n) {
        return dual.size() < 8 * n ? lloyd(mesh, dual, n, seed) : metis(dual, n, seed);
    });
}

} // namespace alphamst::patch
