// Many chords at once: each is judged where it lies, the mesh is smoothed once, at the end.
#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <queue>
#include <string>
#include <unordered_map>

#include "chords/edit.h"
#include "chords/faces.h"
#include "disjoint_sets.h"
#include "index.h"
#include "reference/locate.h"
#include "reference/reference.h"
#include "refill/patch.h"
#include "smooth/smooth.h"

namespace alphamst::chords {
namespace {

// Edges by numbers that stay while edges are removed, glued and renumbered.
class Names {
public:
    explicit Names(int edges) : heirs_(at(edges)), edge_(at(edges)), name_(at(edges)) {
        for (std::vector<int> *numbers : {&edge_, &name_})
            std::iota(numbers->begin(), numbers->end(), 0);
    }

    // -1: it went.
    int edge(int name) { return edge_[at(heirs_.find(name))]; }
    int name(int edge) const { return name_[at(edge)]; }

    void follow(const chord::Chord &chord, const mesh::QuadMesh::Collapsed &collapsed) {
        for (const int side : chord.sides)
            edge_[at(name_[at(side / 2)])] = -1;
        for (const auto &[gone, kept] : collapsed.glued)
            heirs_.unite(name_[at(kept)], name_[at(gone)]);
        for (const auto &[from, to] : collapsed.moved_edges) {
            name_[at(to)] = name_[at(from)];
            edge_[at(name_[at(to)])] = to;
        }
    }

private:
    DisjointSets heirs_; // names of edges that were glued
    std::vector<int> edge_, name_;
};

// Whether a face beside the chord would invert that is upright now.
bool turns_over(const mesh::QuadMesh &mesh, const chord::Chord &chord, const chord::Collapse &verdict,
                const std::optional<geometry::Plane> &plane) {
    std::unordered_map<int, OpenMesh::Vec3d> moved;
    std::vector<int> vertices, passed = chord.faces;
    for (const chord::Group &group : verdict.groups) {
        const OpenMesh::Vec3d place = place_of(mesh, group);
        moved[group.survivor] = place;
        vertices.push_back(group.survivor);
        for (const int v : group.others) {
            moved[v] = place;
            vertices.push_back(v);
        }
    }
    std::sort(passed.begin(), passed.end());
    for (const int f : faces_around(mesh, std::move(vertices), 0)) {
        if (std::binary_search(passed.begin(), passed.end(), f))
            continue;
        const geometry::Quad before = reference::quad_of(mesh, f);
        geometry::Quad after = before;
        const auto corners = mesh.corners(f);
        for (std::size_t k = 0; k < 4; ++k)
            if (const auto found = moved.find(corners[k]); found != moved.end())
                after[k] = {found->second[0], found->second[1], found->second[2]};
        if (upright(before, plane) &&
            (!upright(after, plane) || geometry::area_vector(before).dot(geometry::area_vector(after)) <= 0))
            return true;
    }
    return false;
}

// Chords by number while others are removed: where each is, and how long.
class Chords {
public:
    explicit Chords(const mesh::QuadMesh &mesh)
        : mesh_(mesh), names_(mesh.n_edges()), labels_(chord::label(mesh)), length_(labels_.first.size(), 0) {
        for (std::size_t number = 0; number < length_.size(); ++number)
            length_[number] = chord::trace(mesh, labels_.first[number]).length();
    }

    std::size_t count() const { return length_.size(); }
    std::size_t length(std::size_t number) const { return length_[number]; }
    chord::Chord trace(std::size_t number) { return chord::trace(mesh_, names_.edge(labels_.first[number])); }

    // The chords that the faces of this one are on, besides: they get shorter without it.
    std::vector<std::size_t> across(const chord::Chord &chord) const {
        std::vector<std::size_t> numbers;
        for (std::size_t i = 0; i < chord.length(); ++i) {
            const auto h = mesh::Kernel::HalfedgeHandle(chord.sides[i]);
            const int rail = mesh_.kernel().next_halfedge_handle(h).idx() / 2;
            numbers.push_back(at(labels_.of_edge[at(names_.name(rail))]));
        }
        return numbers;
    }

    void follow(const chord::Chord &chord, const mesh::QuadMesh::Collapsed &collapsed, std::size_t number,
                const std::vector<std::size_t> &across) {
        names_.follow(chord, collapsed);
        length_[number] = 0;
        for (const std::size_t other : across)
            --length_[other];
    }

private:
    const mesh::QuadMesh &mesh_;
    Names names_;
    const chord::Labels labels_;
    std::vector<std::size_t> length_;
};

// Mean of its edges.
double width_of(const mesh::QuadMesh &mesh, const chord::Chord &chord) {
    double sum = 0;
    for (const int side : chord.sides) {
        const auto ends = mesh.edge_vertices(side / 2);
        sum += (reference::point_of(mesh, ends[1]) - reference::point_of(mesh, ends[0])).norm();
    }
    return sum / static_cast<double>(chord.sides.size());
}

// Chords that wait to be removed, the shortest or narrowest first. What one was when it came is looked at
// again when its turn has come.
class Waiting {
public:
    explicit Waiting(std::size_t chords) : rank_(chords) {}

    void push(std::size_t number, double rank) {
        rank_[number] = rank;
        queue_.push({rank, number});
    }
    bool empty() const { return queue_.empty(); }
    // Nothing if it came again meanwhile.
    std::optional<std::size_t> pop() {
        const auto [rank, number] = queue_.top();
        queue_.pop();
        return rank == rank_[number] ? std::optional(number) : std::nullopt;
    }
    double rank(std::size_t number) const { return rank_[number]; }

private:
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
    std::vector<double> rank_; // [chord]
};

class Removal {
public:
    Removal(mesh::QuadMesh &mesh, std::int64_t least_faces, const chord::Rules &rules, Order order)
        : mesh_(mesh), least_faces_(least_faces), order_(order), plane_(reference::plane_of(mesh)),
          chords_(mesh), judge_(mesh, rules), waiting_(chords_.count()) {
        for (std::size_t number = 0; number < chords_.count(); ++number)
            waiting_.push(number, rank(number));
    }

    // What is refused is tried again after others went.
    void run(const Progress &progress) {
        const double start = mesh_.n_faces();
        std::vector<std::size_t> refused;
        bool changed = false;
        while (!waiting_.empty()) {
            const std::optional<std::size_t> next = waiting_.pop();
            if (next && chords_.length(*next) > 0) {
                if (const double now = rank(*next); now > waiting_.rank(*next)) {
                    waiting_.push(*next, now);
                } else if (remove_chord(*next)) {
                    changed = true;
                    progress(std::min(0.9, 0.9 * (start - mesh_.n_faces()) / start), "chords");
                } else {
                    refused.push_back(*next);
                }
            }
            if (waiting_.empty() && changed) {
                for (const std::size_t number : refused)
                    if (chords_.length(number) > 0)
                        waiting_.push(number, rank(number));
                refused.clear();
                changed = false;
            }
        }
    }

private:
    double rank(std::size_t number) {
        return order_ == Order::shortest ? static_cast<double>(chords_.length(number))
                                         : width_of(mesh_, chords_.trace(number));
    }

    bool remove_chord(std::size_t number) {
        if (mesh_.n_faces() - static_cast<std::int64_t>(chords_.length(number)) < least_faces_)
            return false;
        const chord::Chord chord = chords_.trace(number);
        const chord::Collapse verdict = judge_(chord);
        if (verdict.reasons != 0 || turns_over(mesh_, chord, verdict, plane_))
            return false;
        const std::vector<std::size_t> across = chords_.across(chord);
        std::vector<int> survivors;
        chords_.follow(chord, remove(mesh_, chord, verdict, survivors), number, across);
        for (const std::size_t other : across)
            if (order_ == Order::shortest && chords_.length(other) > 0)
                waiting_.push(other, rank(other));
        return true;
    }

    mesh::QuadMesh &mesh_;
    const std::int64_t least_faces_;
    const Order order_;
    const std::optional<geometry::Plane> plane_;
    Chords chords_;
    chord::Judge judge_;
    Waiting waiting_;
};

// The widest closed chord that fits goes first; it is split no more than once more than others.
void split_chords(mesh::QuadMesh &mesh, std::int64_t most_faces, const chord::Rules &rules,
                  const Progress &progress) {
    const double start = mesh.n_faces();
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<std::pair<double, int>> fitting; // width, edge
        for (const int edge : chord::label(mesh).first) {
            const chord::Chord chord = chord::trace(mesh, edge);
            if (chord::judge_split(mesh, chord, rules).reasons == 0)
                fitting.push_back({width_of(mesh, chord), edge});
        }
        std::sort(fitting.begin(), fitting.end(), std::greater<>());
        for (const auto &[width, edge] : fitting) {
            const chord::Chord chord = chord::trace(mesh, edge); // longer, if one that it crosses was split
            if (mesh.n_faces() + chord::faces_added(chord, 1) > most_faces)
                continue;
            mesh.split_chord(chord.sides, 1);
            changed = true;
            progress(std::min(0.9, start / mesh.n_faces()), "chords");
        }
    }
}

void smooth_or_leave(mesh::QuadMesh &mesh, const Settings &settings) {
    std::vector<int> all(at(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    std::vector<OpenMesh::Vec3d> points;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        points.push_back(mesh.point(v));
    const std::int64_t before = inverted(mesh, all);
    smooth::smooth(mesh, nullptr, settings, [](double, const char *) {});
    if (inverted(mesh, all) > before)
        for (int v = 0; v < mesh.n_vertices(); ++v)
            mesh.set_point(v, points[at(v)]);
}

} // namespace

void approach_by_chords(mesh::QuadMesh &mesh, std::int64_t wanted, const chord::Rules &rules, Order order,
                        const Progress &progress) {
    if (wanted > mesh.n_faces())
        split_chords(mesh, wanted, rules, progress);
    else
        Removal(mesh, wanted, rules, order).run(progress);
}

Outcome adapt_chords(mesh::QuadMesh &mesh, double alpha, std::int64_t most_faces, const chord::Rules &rules,
                     const Settings &settings, const Progress &progress) {
    Account account(mesh);
    const std::int64_t wanted = refill::wanted_faces(alpha, at(mesh.n_faces()));
    keep_surface(mesh);
    approach_by_chords(mesh, std::min(wanted, most_faces), rules, Order::shortest, progress);
    progress(0.9, "smooth");
    smooth_or_leave(mesh, settings);
    progress(1, "smooth");
    Outcome outcome = account.close(mesh, wanted);
    if (outcome.faces_after != wanted)
        outcome.text = "by whole chords it came to " + std::to_string(outcome.faces_after) + " of " +
                       std::to_string(wanted) +
                       " faces; those that are left would pass that number, or are held by boundary, "
                       "features or markers";
    return outcome;
}

} // namespace alphamst::chords
