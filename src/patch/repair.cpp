#include "patch/patches.h"
#include "patch/region.h"
#include "patch/window.h"

#include <limits>
#include <queue>
#include <unordered_set>

namespace alphamst::patch {
namespace {

// A part of the complement of a region, as far as it was looked at.
struct Gap {
    std::vector<int> faces;
    bool open = false;  // reaches the mesh boundary or holds more faces than the region
    bool usable = true; // its faces may join the region
};

// The edge-connected parts of the complement along the boundary of a region. None is followed
// further than there are faces in the region, so that a small region costs little.
class Gaps {
public:
    Gaps(const mesh::QuadMesh &mesh, const Region &region, Taken taken)
        : mesh_(mesh), region_(region), taken_(taken) {
        for (const Halfedge h : region.boundary) {
            const int start = right(mesh, h);
            if (start >= 0 && seen_.insert(start).second)
                follow(start);
        }
    }

    std::vector<Gap> found;

private:
    void follow(int start) {
        Gap gap;
        gap.faces = {start};
        for (std::size_t i = 0; i < gap.faces.size() && !gap.open; ++i) {
            const int face = gap.faces[i];
            if (!taken_.empty() && taken_[static_cast<std::size_t>(face)])
                gap.usable = false;
            for (const Halfedge h : halfedges_of(mesh_, face)) {
                const int next = right(mesh_, h);
                if (barrier(mesh_, h) || held(mesh_, from(mesh_, h)))
                    gap.usable = false;
                if (next < 0 || open_.contains(next)) {
                    gap.open = true;
                } else if (!contains(region_.faces, next) && seen_.insert(next).second) {
                    gap.faces.push_back(next);
                }
            }
            gap.open = gap.open || gap.faces.size() > region_.faces.size();
        }
        if (gap.open)
            open_.insert(gap.faces.begin(), gap.faces.end());
        found.push_back(std::move(gap));
    }

    const mesh::QuadMesh &mesh_;
    const Region &region_;
    Taken taken_;
    std::unordered_set<int> seen_, open_;
};

// The region with its enclosed holes of so many faces at most. The largest gap of a closed surface is its
// outside.
std::vector<int> fill_holes(const mesh::QuadMesh &mesh, const Region &region, Taken taken,
                            std::size_t largest = std::numeric_limits<std::size_t>::max()) {
    std::vector<Gap> gaps = Gaps(mesh, region, taken).found;
    bool bounded = std::any_of(region.boundary.begin(), region.boundary.end(),
                               [&](Halfedge h) { return right(mesh, h) < 0; });
    for (const Gap &gap : gaps)
        bounded = bounded || gap.open;
    if (!bounded && !gaps.empty())
        std::max_element(gaps.begin(), gaps.end(), [](const Gap &a, const Gap &b) {
            return a.faces.size() < b.faces.size();
        })->open = true;
    std::vector<int> faces = region.faces;
    for (const Gap &gap : gaps)
        if (!gap.open && gap.usable && gap.faces.size() <= largest)
            faces.insert(faces.end(), gap.faces.begin(), gap.faces.end());
    return sorted_unique(faces);
}

// Grows a disk within a set of faces, face by face; every stage is a disk, so the end is.
class Disk {
public:
    Disk(const mesh::QuadMesh &mesh, std::span<const int> within) : mesh_(mesh), within_(within) {}

    // Takes faces in the order of their distance from the seed, then of their ids; one that
    // does not fit is tried again when another of its neighbours has come in.
    std::vector<int> grow(int seed) {
        using Step = std::pair<int, int>; // distance, face
        std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
        front.push({0, seed});
        while (!front.empty()) {
            const auto [distance, face] = front.top();
            front.pop();
            if (faces_.contains(face) || !fits(face))
                continue;
            faces_.insert(face);
            for (const Halfedge h : halfedges_of(mesh_, face)) {
                vertices_.insert(from(mesh_, h));
                const int next = right(mesh_, h);
                if (contains(within_, next) && !faces_.contains(next))
                    front.push({distance + 1, next});
            }
        }
        std::vector<int> result(faces_.begin(), faces_.end());
        std::sort(result.begin(), result.end());
        return result;
    }

private:
    // A disk and a face make a disk if they meet in one path of 1 to 3 edges and nowhere else.
    // The vertices within the path come to lie inside.
    bool fits(int face) const {
        if (faces_.empty())
            return true;
        const auto edges = halfedges_of(mesh_, face);
        int shared = 0, starts = 0, touched = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const bool here = faces_.contains(right(mesh_, edges[k]));
            const bool before = faces_.contains(right(mesh_, edges[(k + 3) % 4]));
            const int corner = from(mesh_, edges[k]);
            if (here && barrier(mesh_, edges[k]))
                return false;
            if (here && before && held(mesh_, corner))
                return false;
            shared += here;
            starts += here && !before;
            touched += vertices_.contains(corner);
        }
        return starts == 1 && touched == shared + 1;
    }

    const mesh::QuadMesh &mesh_;
    std::span<const int> within_;
    std::unordered_set<int> faces_, vertices_;
};

// The face farthest from the boundary, the first of equals.
int deepest(const mesh::QuadMesh &mesh, const Region &region) {
    std::unordered_set<int> seen;
    std::vector<int> layer;
    for (const Halfedge h : region.boundary)
        if (seen.insert(left(mesh, h)).second)
            layer.push_back(left(mesh, h));
    if (layer.empty())
        return region.faces.front();
    for (;;) {
        std::vector<int> next;
        for (const int face : layer)
            for (const Halfedge h : halfedges_of(mesh, face))
                if (contains(region.faces, right(mesh, h)) && seen.insert(right(mesh, h)).second)
                    next.push_back(right(mesh, h));
        if (next.empty())
            return *std::min_element(layer.begin(), layer.end());
        layer = std::move(next);
    }
}

std::vector<int> largest_free_part(const mesh::QuadMesh &mesh, std::vector<int> faces, Taken taken) {
    std::erase_if(faces, [&](int face) { return !taken.empty() && taken[static_cast<std::size_t>(face)]; });
    return largest_part(mesh, sorted_unique(faces), false);
}

} // namespace

std::vector<int> repair(const mesh::QuadMesh &mesh, std::vector<int> faces, Taken taken) {
    faces = largest_free_part(mesh, std::move(faces), taken);
    if (faces.empty() || defects(mesh, faces) == 0)
        return faces;

    faces = fill_holes(mesh, Region(mesh, faces), taken);
    // What is left encloses something, meets itself, or a barrier ends inside: cut it open.
    if (defects(mesh, faces) != 0)
        faces = Disk(mesh, faces).grow(deepest(mesh, Region(mesh, faces)));
    return faces;
}

std::vector<int> repair_but_rings(const mesh::QuadMesh &mesh, std::vector<int> faces, Taken taken) {
    constexpr std::size_t part = 10;
    faces = largest_free_part(mesh, std::move(faces), taken);
    if (faces.empty() || defects(mesh, faces) == 0)
        return faces;
    const std::vector<int> filled =
        fill_holes(mesh, Region(mesh, faces), taken, std::max<std::size_t>(1, faces.size() / part));
    if ((defects(mesh, filled) & ~not_disk) == 0)
        return filled;
    return repair(mesh, std::move(faces), taken);
}

} // namespace alphamst::patch
