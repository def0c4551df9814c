#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "patch/decompose.h"
#include "patch/flood.h"
#include "patch/region.h"

namespace alphamst::patch {
namespace {

using Point = OpenMesh::Vec3d;

// A piece of what bounds the free faces: an edge, or a vertex that no patch may have inside.
struct BufferRing {
    Point from, to;
};

double distance(const Point &p, const BufferRing &rim) {
    const Point along = rim.to - rim.from, away = p - rim.from;
    const double length = along.sqrnorm();
    return (away - along * (length > 0 ? std::clamp((away | along) / length, 0.0, 1.0) : 0)).norm();
}

// The discs of Verma and Suresh for the alpha-MST: the faces in a circle around a point of the
// medial axis, the largest circle first, each bounded by those before. What bounds the free
// faces is carried inwards from face to face, each face keeping the nearest piece it hears of
// (Danielsson 1980), so that lengths are straight and not along edges. A face may not hear of
// the nearest of all: the circle of a disc is searched before it is taken. Discs that the size
// cuts down leave room for others around them.
class Discs {
public:
    Discs(const mesh::QuadMesh &mesh, const FaceDual &dual, double size, const Pace &pace)
        : mesh_(mesh), dual_(dual), pace_(pace),
          most_(static_cast<std::size_t>(std::max(1.0, std::round(size)))), flood_(dual, pace),
          state_(dual.size(), State::free), seen_(dual.size(), 0) {
        least_ = std::max<std::size_t>(1, most_ / 4);
    }

    Groups all(std::uint64_t seed) {
        std::vector<std::size_t> nodes(dual_.size());
        std::iota(nodes.begin(), nodes.end(), 0);
        bound(nodes);
        std::optional<std::size_t> centre = flood_.farthest();
        if (!centre) // nothing bounds them: a closed surface
            centre = static_cast<std::size_t>(std::mt19937_64(seed)() % dual_.size());
        for (; centre; centre = flood_.farthest())
            if (state_[*centre] == State::free)
                try_around(*centre);
        return std::move(groups_);
    }

private:
    enum class State : char { free, passed, taken };

    void add(BufferRing rim, std::size_t node) {
        starts_.push_back({distance(dual_.centroids[node], rim), node, rims_.size()});
        rims_.push_back(rim);
    }

    void flood() {
        flood_.add(starts_, [&](std::size_t, std::size_t next, std::size_t rim) {
            return distance(dual_.centroids[next], rims_[rim]);
        });
        starts_.clear();
    }

    // What bounds a free face itself: sides that lead to no other, and held vertices.
    template <class Use> void rims_of(std::size_t node, Use use) const {
        for (const Halfedge h : halfedges_of(mesh_, dual_.faces[node])) {
            const Point &p = mesh_.point(from(mesh_, h));
            const auto next = std::lower_bound(dual_.faces.begin(), dual_.faces.end(), right(mesh_, h));
            if (next == dual_.faces.end() || *next != right(mesh_, h) || barrier(mesh_, h) ||
                state_[static_cast<std::size_t>(next - dual_.faces.begin())] == State::taken)
                use(BufferRing{p, mesh_.point(to(mesh_, h))});
            if (held(mesh_, from(mesh_, h)))
                use(BufferRing{p, p});
        }
    }

    // Floods from what bounds these nodes.
    void bound(std::span<const std::size_t> nodes) {
        for (const std::size_t node : nodes)
            rims_of(node, [&](const BufferRing &rim) { add(rim, node); });
        flood();
    }

    // Takes the disc around a node if it is large enough; puts it back if its circle is not
    // empty. A circle within a disc that is not large enough has hardly more faces, so its
    // faces are passed over as centres.
    void try_around(std::size_t centre) {
        const std::vector<std::size_t> disc = around(centre);
        const bool enough = disc.size() >= std::min(least_, dual_.size());
        if (const auto rim = enough ? intruder(centre, disc) : std::nullopt) {
            add(*rim, centre);
            return flood();
        }
        state_[centre] = State::passed;
        for (const std::size_t node : disc)
            state_[node] = enough ? State::taken : std::max(state_[node], State::passed);
        if (!enough)
            return;
        Groups::value_type faces;
        for (const std::size_t node : disc) {
            flood_.close(node);
            faces.push_back(dual_.faces[node]);
        }
        groups_.push_back(std::move(faces));
        std::vector<std::size_t> beside;
        for (const std::size_t node : disc)
            for (const std::int32_t next : dual_.neighbours(node))
                if (state_[static_cast<std::size_t>(next)] != State::taken)
                    beside.push_back(static_cast<std::size_t>(next));
        bound(beside);
    }

    // How far the farthest corner of a node is from the centroid of another.
    double reach(std::size_t centre, std::size_t node) const {
        double most = 0;
        for (const int v : mesh_.corners(dual_.faces[node]))
            most = std::max(most, (mesh_.point(v) - dual_.centroids[centre]).norm());
        return most;
    }

    // Whether a side of a node comes nearer than that to the centroid of another.
    bool meets(std::size_t centre, double radius, std::size_t node) const {
        const auto sides = halfedges_of(mesh_, dual_.faces[node]);
        return std::any_of(sides.begin(), sides.end(), [&](Halfedge h) {
            const BufferRing side{mesh_.point(from(mesh_, h)), mesh_.point(to(mesh_, h))};
            return distance(dual_.centroids[centre], side) < radius;
        });
    }

    // The free faces with all corners in the circle around a node that touches the nearest
    // rim, connected with it, the nearest ones if they are too many.
    std::vector<std::size_t> around(std::size_t centre) {
        using Step = std::pair<double, std::size_t>; // distance, node
        std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
        std::vector<std::size_t> disc;
        ++round_;
        const auto offer = [&](std::size_t node) {
            const double away = reach(centre, node);
            if (fresh(node) && away <= flood_.distance(centre))
                front.push({away, node});
        };
        offer(centre);
        while (!front.empty() && disc.size() < most_) {
            const std::size_t node = front.top().second;
            front.pop();
            pace_.step();
            disc.push_back(node);
            for (const std::int32_t next : dual_.neighbours(node))
                offer(static_cast<std::size_t>(next));
        }
        return disc;
    }

    // The nearest rim inside the smallest circle around a node that holds its disc. Searched is
    // all that the circle meets, also behind faces that are not in the disc.
    std::optional<BufferRing> intruder(std::size_t centre, const std::vector<std::size_t> &disc) {
        double radius = 0;
        for (const std::size_t node : disc)
            radius = std::max(radius, reach(centre, node));
        radius *= 1 - 1e-12; // a corner of the disc may lie on the circle
        std::optional<BufferRing> nearest;
        std::vector<std::size_t> front = {centre};
        ++round_;
        fresh(centre);
        for (std::size_t i = 0; i < front.size(); ++i) {
            pace_.step();
            rims_of(front[i], [&](const BufferRing &rim) {
                const double away = distance(dual_.centroids[centre], rim);
                if (away < radius) {
                    radius = away;
                    nearest = rim;
                }
            });
            for (const std::int32_t next : dual_.neighbours(front[i])) {
                const auto node = static_cast<std::size_t>(next);
                if (fresh(node) && meets(centre, radius, node))
                    front.push_back(node);
            }
        }
        return nearest;
    }

    // Whether a node is free and was not seen in this round; now it was.
    bool fresh(std::size_t node) {
        if (state_[node] == State::taken || seen_[node] == round_)
            return false;
        seen_[node] = round_;
        return true;
    }

    const mesh::QuadMesh &mesh_;
    const FaceDual &dual_;
    const Pace &pace_;
    std::size_t most_, least_;
    Flood flood_;
    std::vector<BufferRing> rims_;
    std::vector<Flood::Start> starts_;
    std::vector<State> state_;
    std::vector<int> seen_; // [node] round it was last seen in
    int round_ = 0;
    Groups groups_;
};

} // namespace

Groups medial_discs(const mesh::QuadMesh &mesh, double size, std::uint64_t seed, Taken taken,
                    const Pace &pace) {
    Groups groups;
    const Pace first = pace.part(0, 0.8); // of the time, about
    for (const FaceDual &dual : duals(mesh, taken, first))
        for (auto &disc : Discs(mesh, dual, size, first).all(seed))
            groups.push_back(std::move(disc));
    return disks(mesh, groups, taken, pace.part(0.8, 1));
}

} // namespace alphamst::patch
