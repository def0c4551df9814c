#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "disjoint_sets.h"
#include "index.h"
#include "patch/decompose.h"
#include "patch/region.h"

namespace alphamst::patch {
namespace {

// Balls of faces around singular vertices, all grown one layer at a time. Two that meet become
// one while they have no more faces than wanted, those with the fewest first.
class Balls {
public:
    Balls(const mesh::QuadMesh &mesh, const FaceDual &dual, double size, const Pace &pace)
        : mesh_(mesh), dual_(dual), pace_(pace), size_(std::max(size, 1.0)), owner_(dual.size(), none) {}

    Groups around(std::span<const int> vertices) {
        balls_.resize(vertices.size());
        united_ = DisjointSets(vertices.size());
        std::vector<int> fresh;
        for (int b = 0; b < n_balls(); ++b)
            for (const int face : mesh_.faces_around(vertices[at(b)]))
                if (claim(node_of(face), b))
                    fresh.push_back(node_of(face));
        while (!fresh.empty()) {
            unite(fresh);
            fresh = grow();
        }
        Groups groups;
        for (int b = 0; b < n_balls(); ++b)
            if (united_.find(b) == b && !balls_[at(b)].nodes.empty())
                groups.push_back(convexified(b));
        return groups;
    }

private:
    struct Ball {
        std::vector<int> nodes, front; // all, those of the last layer
    };
    static constexpr int none = -1;

    int n_balls() const { return static_cast<int>(balls_.size()); }
    std::size_t count(int ball) const { return balls_[at(ball)].nodes.size(); }

    int node_of(int face) const {
        const auto it = std::lower_bound(dual_.faces.begin(), dual_.faces.end(), face);
        return it != dual_.faces.end() && *it == face ? static_cast<int>(it - dual_.faces.begin()) : none;
    }

    bool claim(int node, int ball) {
        if (node == none || owner_[at(node)] != none)
            return false;
        owner_[at(node)] = ball;
        balls_[at(ball)].nodes.push_back(node);
        balls_[at(ball)].front.push_back(node);
        return true;
    }

    // The free nodes around a node of a ball, by its corners too, as far as no barrier and no
    // other ball is in between.
    void layer(int ball, int node, std::vector<int> &found) {
        const Kernel &kernel = mesh_.kernel();
        const auto visit = [&](Halfedge across) {
            const int next = barrier(mesh_, across) ? none : node_of(right(mesh_, across));
            if (next == none || next == node)
                return false;
            if (owner_[at(next)] != none)
                return united_.find(owner_[at(next)]) == ball;
            found.push_back(next);
            return true;
        };
        for (const Halfedge h : halfedges_of(mesh_, dual_.faces[at(node)])) {
            if (held(mesh_, from(mesh_, h)))
                continue;
            for (Halfedge g = h; visit(g);)
                g = kernel.next_halfedge_handle(kernel.opposite_halfedge_handle(g));
            for (Halfedge g = kernel.prev_halfedge_handle(h); visit(g);)
                g = kernel.prev_halfedge_handle(kernel.opposite_halfedge_handle(g));
        }
    }

    // Another layer for every ball that comes nearer to the wanted number by it.
    std::vector<int> grow() {
        std::vector<int> fresh;
        for (int b = 0; b < n_balls(); ++b) {
            Ball &ball = balls_[at(b)];
            pace_.step(ball.front.size() + 1);
            std::vector<int> found;
            for (const int node : ball.front)
                layer(b, node, found);
            found = sorted_unique(found);
            ball.front.clear();
            if (static_cast<double>(ball.nodes.size()) + static_cast<double>(found.size()) / 2 > size_)
                continue;
            for (const int node : found)
                claim(node, b);
            fresh.insert(fresh.end(), found.begin(), found.end());
        }
        return fresh;
    }

    void unite(const std::vector<int> &fresh) {
        using Pair = std::tuple<std::size_t, int, int>; // faces together, balls
        std::priority_queue<Pair, std::vector<Pair>, std::greater<>> meeting;
        const auto meet = [&](int a, int b) {
            if (a != b && static_cast<double>(count(a) + count(b)) <= size_)
                meeting.push({count(a) + count(b), std::min(a, b), std::max(a, b)});
        };
        for (const int node : fresh)
            for (const std::int32_t next : dual_.neighbours(at(node)))
                if (owner_[at(next)] != none)
                    meet(united_.find(owner_[at(node)]), united_.find(owner_[at(next)]));
        while (!meeting.empty()) {
            const auto [together, first, second] = meeting.top();
            meeting.pop();
            const int a = united_.find(first), b = united_.find(second);
            if (a == b)
                continue;
            if (count(a) + count(b) == together) {
                join(a, b);
            } else {
                meet(a, b);
            }
        }
    }

    void join(int a, int b) {
        if (count(a) < count(b))
            std::swap(a, b);
        united_.unite(a, b);
        for (auto list : {&Ball::nodes, &Ball::front}) {
            auto &to = balls_[at(a)].*list, &from = balls_[at(b)].*list;
            to.insert(to.end(), from.begin(), from.end());
            from = {};
        }
    }

    // With the free faces that have two sides on it, where corners would turn inwards.
    std::vector<int> convexified(int ball) {
        std::vector<int> &nodes = balls_[at(ball)].nodes, faces;
        const auto most = static_cast<std::size_t>(1.5 * static_cast<double>(nodes.size()));
        for (std::size_t i = 0; i < nodes.size(); ++i)
            for (const std::int32_t next : dual_.neighbours(at(nodes[i]))) {
                const auto around = dual_.neighbours(at(next));
                const auto sides = std::count_if(around.begin(), around.end(), [&](std::int32_t node) {
                    return owner_[at(node)] != none && united_.find(owner_[at(node)]) == ball;
                });
                if (sides >= 2 && nodes.size() < most)
                    claim(next, ball);
            }
        for (const int node : nodes)
            faces.push_back(dual_.faces[at(node)]);
        return faces;
    }

    const mesh::QuadMesh &mesh_;
    const FaceDual &dual_;
    const Pace &pace_;
    double size_;
    std::vector<int> owner_; // [node] ball
    DisjointSets united_{0};
    std::vector<Ball> balls_;
};

// Singular vertices that a patch can have inside.
std::vector<int> loose_singularities(const mesh::QuadMesh &mesh, Taken taken) {
    std::vector<int> vertices = mesh.singularities();
    std::erase_if(vertices, [&](int v) {
        const std::vector<int> faces = mesh.faces_around(v);
        return held(mesh, v) || std::any_of(faces.begin(), faces.end(), [&](int face) {
                   if (!taken.empty() && taken[static_cast<std::size_t>(face)])
                       return true;
                   const auto edges = halfedges_of(mesh, face);
                   return std::any_of(edges.begin(), edges.end(),
                                      [&](Halfedge h) { return from(mesh, h) == v && barrier(mesh, h); });
               });
    });
    return vertices;
}

} // namespace

// What a cluster lost when it was made a disk may hold singular vertices: they are next.
Groups singularity_clusters(const mesh::QuadMesh &mesh, double size, std::uint64_t, Taken taken,
                            const Pace &pace) {
    Groups result;
    std::vector<char> used(static_cast<std::size_t>(mesh.n_faces()), 0);
    std::copy(taken.begin(), taken.end(), used.begin());
    std::vector<int> left = loose_singularities(mesh, taken);
    while (!left.empty()) {
        Groups groups;
        for (const FaceDual &dual : duals(mesh, used, pace)) {
            std::vector<int> here;
            for (const int face : dual.faces) {
                pace.step();
                for (const int v : mesh.corners(face))
                    if (contains(left, v))
                        here.push_back(v);
            }
            for (auto &group : Balls(mesh, dual, size, pace).around(sorted_unique(here)))
                groups.push_back(std::move(group));
        }
        for (auto &disk : disks(mesh, groups, used, pace)) {
            for (const int face : disk)
                used[static_cast<std::size_t>(face)] = 1;
            result.push_back(std::move(disk));
        }
        left = loose_singularities(mesh, used);
    }
    return result;
}

} // namespace alphamst::patch
