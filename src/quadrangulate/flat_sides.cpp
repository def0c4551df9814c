#include "quadrangulate/flat_sides.h"

#include <queue>
#include <tuple>
#include <unordered_map>

#include "disjoint_sets.h"
#include "index.h"

namespace alphamst::quadrangulate {
namespace {

constexpr double even_neighbour = 0.2; // of 1 less a cosine: so much blunter must its edge be

// Where the only other side with an odd number cannot be reached, being sharper than any quad may be, a large
// one would swallow all its neighbours in vain.
constexpr int most_tries = 32;

class FlatSides {
public:
    FlatSides(mesh::Coordinates points, mesh::Faces faces, TriangleSides &sides)
        : points_(points), faces_(faces), sides_(sides), groups_(faces.size() / 4) {
        for (std::size_t c = 0; c < faces.size(); ++c)
            if (sides.across[c] > static_cast<std::int32_t>(c) && sides.bars[c] < Bar::sharp)
                groups_.unite(static_cast<std::int32_t>(c / 4), sides.across[c] / 4);
        for (std::size_t c = 0; c < faces.size(); ++c)
            if (sides.across[c] >= 0 && sides.bars[c] == Bar::sharp && can_cross(sides, points, faces, c))
                edges_[group_of(c)].push_back(static_cast<std::int32_t>(c));
        odd_.assign(faces.size() / 4, false);
        for (std::size_t f = 0; f < odd_.size(); ++f)
            if (mesh::is_triangle(faces, f))
                odd_[at(groups_.find(static_cast<std::int32_t>(f)))].flip();
    }

    void run() {
        excuse_one_at_the_boundary();
        for (std::size_t g = 0; g < odd_.size(); ++g)
            if (odd_[g])
                push(static_cast<std::int32_t>(g));
        while (!due_.empty()) {
            const auto [size, stamp, group] = due_.top();
            due_.pop();
            if (stamp != stamps_[group] || ++tries_[group] > most_tries)
                continue; // united since, or without hope
            const std::int32_t edge = bluntest(group);
            if (edge < 0)
                continue;
            const std::int32_t united = unite(group, group_of(at(sides_.across[at(edge)])));
            if (odd_[at(united)])
                push(united);
        }
    }

private:
    std::int32_t group_of(std::size_t corner) { return groups_.find(static_cast<std::int32_t>(corner / 4)); }

    void push(std::int32_t group) { due_.push({edges_[group].size(), ++stamps_[group], group}); }

    void excuse_one_at_the_boundary() {
        DisjointSets components(odd_.size());
        for (std::size_t c = 0; c < faces_.size(); ++c)
            if (sides_.across[c] > static_cast<std::int32_t>(c))
                components.unite(static_cast<std::int32_t>(c / 4), sides_.across[c] / 4);
        std::vector<bool> odd(odd_.size());
        for (std::size_t f = 0; f < odd.size(); ++f)
            if (mesh::is_triangle(faces_, f))
                odd[at(components.find(static_cast<std::int32_t>(f)))].flip();
        for (std::size_t c = 0; c < faces_.size(); ++c) {
            if (faces_[c] < 0 || sides_.across[c] >= 0 || !odd_[at(group_of(c))])
                continue;
            if (auto due = odd[at(components.find(static_cast<std::int32_t>(c / 4)))]; due)
                due = odd_[at(group_of(c))] = false;
        }
    }

    // Its place in this group, or -1.
    std::int32_t bluntest(std::int32_t group) {
        std::vector<std::int32_t> &edges = edges_[group];
        std::erase_if(edges, [&](std::int32_t c) { return group_of(at(sides_.across[at(c)])) == group; });
        std::int32_t best = -1;
        double least = 0;
        for (const std::int32_t c : edges) {
            const double bent = bend_over(sides_, points_, faces_, at(c)) +
                                (odd_[at(group_of(at(sides_.across[at(c)])))] ? 0 : even_neighbour);
            if (best < 0 || bent < least) {
                best = c;
                least = bent;
            }
        }
        return best;
    }

    std::int32_t unite(std::int32_t group, std::int32_t other) {
        if (edges_[group].size() < edges_[other].size())
            std::swap(group, other);
        std::vector<std::int32_t> fewer = std::move(edges_[other]);
        edges_.erase(other);
        for (const std::int32_t c : fewer)
            if (const std::int32_t beyond = sides_.across[at(c)]; group_of(at(beyond)) == group)
                sides_.bars[at(c)] = sides_.bars[at(beyond)] = Bar::crease;
        edges_[group].insert(edges_[group].end(), fewer.begin(), fewer.end());
        const bool is_odd = odd_[at(group)] != odd_[at(other)];
        groups_.unite(group, other);
        ++stamps_[group];
        ++stamps_[other];
        odd_[at(group)] = is_odd;
        return group;
    }

    mesh::Coordinates points_;
    mesh::Faces faces_;
    TriangleSides &sides_;
    DisjointSets groups_;
    std::vector<bool> odd_; // of the face that stands for a group
    std::unordered_map<std::int32_t, std::vector<std::int32_t>>
        edges_;                                            // corners in the group whose side is sharp
    std::unordered_map<std::int32_t, int> stamps_, tries_; // changes of groups; neighbours looked for
    using Entry = std::tuple<std::size_t, int, std::int32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> due_; // few edges first
};

} // namespace

void unite_odd_sides(mesh::Coordinates points, mesh::Faces faces, TriangleSides &sides) {
    FlatSides(points, faces, sides).run();
}

} // namespace alphamst::quadrangulate
