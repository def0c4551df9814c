#include <bit>

#include "patch/bisection.h"
#include "patch/decompose.h"

namespace alphamst::patch {
namespace {

// Cuts a dual graph in two, and each side again, until every part is one of n.
class Partition {
public:
    Partition(const FaceDual &dual, std::size_t n, std::uint64_t seed, const Pace &pace)
        : dual_(dual), random_(seed), pace_(pace), levels_(static_cast<std::size_t>(std::bit_width(n - 1))),
          place_(dual.size(), -1), group_(dual.size(), 0) {
        std::vector<std::int32_t> nodes(dual.size());
        for (std::size_t i = 0; i < nodes.size(); ++i)
            nodes[i] = static_cast<std::int32_t>(i);
        divide(nodes, 0, n);
    }

    std::vector<std::size_t> groups() && { return std::move(group_); }

private:
    // nodes, ascending, become the groups first .. first + n - 1.
    void divide(const std::vector<std::int32_t> &nodes, std::size_t first, std::size_t n) {
        if (n == 1) {
            for (const std::int32_t node : nodes)
                group_[static_cast<std::size_t>(node)] = first;
            done_ += nodes.size();
            pace_.reach(static_cast<double>(done_) / static_cast<double>(dual_.size()));
            return;
        }
        const std::size_t left = n / 2, wanted = (nodes.size() * left + n / 2) / n;
        // Deviations add up over the levels, so that parts differ by a few percent in the end.
        const double fraction = 0.02 / static_cast<double>(levels_);
        const auto slack = static_cast<std::size_t>(fraction * static_cast<double>(wanted));
        const std::vector<char> side = bisect(graph_of(nodes), wanted, slack, random_, pace_);
        std::vector<std::int32_t> sides[2];
        for (std::size_t i = 0; i < nodes.size(); ++i)
            sides[side[i] == 0 ? 0 : 1].push_back(nodes[i]);
        divide(sides[0], first, left);
        divide(sides[1], first + left, n - left);
    }

    Graph graph_of(const std::vector<std::int32_t> &nodes) {
        Graph graph;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            place_[static_cast<std::size_t>(nodes[i])] = static_cast<std::int32_t>(i);
        for (const std::int32_t node : nodes) {
            for (const std::int32_t next : dual_.neighbours(static_cast<std::size_t>(node)))
                if (const std::int32_t place = place_[static_cast<std::size_t>(next)]; place >= 0)
                    graph.links.push_back(place);
            graph.start.push_back(static_cast<std::int32_t>(graph.links.size()));
            const OpenMesh::Vec3d &centroid = dual_.centroids[static_cast<std::size_t>(node)];
            graph.places.emplace_back(centroid[0], centroid[1], centroid[2]);
        }
        for (const std::int32_t node : nodes)
            place_[static_cast<std::size_t>(node)] = -1;
        return graph;
    }

    const FaceDual &dual_;
    Random random_;
    const Pace &pace_;
    std::size_t done_ = 0; // nodes that have their group
    std::size_t levels_;
    std::vector<std::int32_t> place_; // [node of the dual] its node in the graph, -1: none
    std::vector<std::size_t> group_;
};

} // namespace

Groups partition(const mesh::QuadMesh &mesh, double size, std::uint64_t seed, Taken taken, const Pace &pace) {
    // Parts of a few faces could often not be connected and of one size.
    return decompose(
        mesh, size, taken,
        [&](const FaceDual &dual, std::size_t n, const Pace &part) {
            return dual.size() < 8 * n ? lloyd(dual, n, seed, part) : Partition(dual, n, seed, part).groups();
        },
        pace);
}

} // namespace alphamst::patch
