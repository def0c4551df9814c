#include "io/inp_sets.h"

#include <algorithm>
#include <utility>

#include "index.h"
#include "io/markers.h"
#include "io/scanner.h"
#include "mesh/sides.h"

namespace alphamst::io {
namespace {

using Edge = std::array<std::int32_t, 2>;

Edge sorted(std::int32_t v, std::int32_t w) { return {std::min(v, w), std::max(v, w)}; }

// Ascending: those of one face.
std::vector<Edge> boundary_of(mesh::Faces faces) {
    std::vector<Edge> edges, boundary;
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (faces[c] >= 0)
            edges.push_back(sorted(faces[c], faces[mesh::next_corner(faces, c)]));
    std::ranges::sort(edges);
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        for (end = i; end < edges.size() && edges[end] == edges[i];)
            ++end;
        if (end == i + 1)
            boundary.push_back(edges[i]);
    }
    return boundary;
}

} // namespace

class InputSets::Adder {
public:
    Adder(const InputSets &sets, const Tags &nodes, const Tags &elements,
          const std::vector<Element> &of_elements, Arrays &mesh)
        : sets_(sets), nodes_(nodes), elements_(elements), of_elements_(of_elements), mesh_(mesh) {
        mesh.face_marker.assign(mesh.faces.size() / 4, 0);
    }

    void add() {
        for (const Set &set : sets_.sets_) {
            ++number_;
            set_ = &set;
            if (set.kind == Kind::nodes)
                add_nodes();
            else if (set.kind == Kind::elements)
                add_elements(sets_.members(set, elements_, missing_), -1);
            else
                for (const Side &side : set.sides)
                    add_side(side);
        }
        for (const auto &[edge, marker] : edges_)
            mesh_.marked_edges.push_back({edge, marker});
        say(several_, " faces, edges and vertices are in several sets, of which the first counts");
        say(missing_, " numbers and names in sets are not in the file");
        if (!unmarked_.empty())
            mesh_.remarks.push_back("sets of nodes that are no part of the boundary are left out: " +
                                    unmarked_);
    }

private:
    void say(std::int64_t n, const char *text) {
        if (n > 0)
            mesh_.remarks.push_back(std::to_string(n) + text);
    }

    void name(Entity entity) { mesh_.names[{entity, number_}] = clean_name(set_->name); }

    void mark_edge(std::int32_t v, std::int32_t w) {
        const auto [place, is_new] = edges_.try_emplace(sorted(v, w), number_);
        several_ += place->second != number_;
        if (is_new)
            name(Entity::edge);
    }

    void mark_face(std::int32_t face) {
        std::int32_t &marker = mesh_.face_marker[at(face)];
        several_ += marker != 0 && marker != number_;
        if (marker != 0)
            return;
        marker = number_;
        name(Entity::face);
    }

    void mark(const Element &element, int side) {
        const std::array<std::int32_t, 4> &v = element.vertices;
        const int n = element.face < 0 ? 2 : v[3] < 0 ? 3 : 4;
        if (n > 2 && side < 0)
            mark_face(element.face);
        else if (n == 2)
            mark_edge(v[0], v[1]);
        else if (side < n)
            mark_edge(v[at(side)], v[at((side + 1) % n)]);
        else
            ++missing_;
    }

    void add_elements(const std::vector<bool> &members, int side) {
        for (std::size_t e = 0; e < members.size(); ++e)
            if (members[e])
                mark(of_elements_[e], side);
    }

    void add_side(const Side &side) {
        if (!side.set.empty()) {
            const Set *of = sets_.find(side.set, Kind::elements);
            if (of == nullptr)
                ++missing_;
            else
                add_elements(sets_.members(*of, elements_, missing_), side.side);
        } else if (const std::int32_t element = elements_.find(side.tag); element >= 0) {
            mark(of_elements_[at(element)], side.side);
        } else {
            ++missing_;
        }
    }

    void add_nodes() {
        const std::vector<bool> members = sets_.members(*set_, nodes_, missing_);
        const auto n = std::ranges::count(members, true);
        if (n == 1) {
            const auto vertex = static_cast<std::int32_t>(std::ranges::find(members, true) - members.begin());
            several_ += std::ranges::find(mesh_.marked_points, vertex, &Arrays::MarkedPoint::vertex) !=
                        mesh_.marked_points.end();
            mesh_.marked_points.push_back({vertex, number_}); // the smallest counts
            name(Entity::vertex);
        } else if (n > 1 && (n == std::ssize(members) || !mark_boundary(members))) {
            unmarked_ += (unmarked_.empty() ? "" : ", ") + io::quoted(set_->name);
        }
    }

    bool mark_boundary(const std::vector<bool> &members) {
        if (!boundary_known_)
            boundary_ = boundary_of(mesh_.faces);
        boundary_known_ = true;
        bool any = false;
        for (const auto &[v, w] : boundary_)
            if (members[at(v)] && members[at(w)]) {
                mark_edge(v, w);
                any = true;
            }
        return any;
    }

    const InputSets &sets_;
    const Tags &nodes_, &elements_;
    const std::vector<Element> &of_elements_;
    Arrays &mesh_;
    const Set *set_ = nullptr; // this one, of this number
    std::int32_t number_ = 0;
    std::map<Edge, std::int32_t> edges_;
    std::vector<Edge> boundary_;
    bool boundary_known_ = false;
    std::int64_t several_ = 0, missing_ = 0;
    std::string unmarked_;
};

const InputSets::Set *InputSets::find(std::string_view name, Kind kind) const {
    const auto found = std::ranges::find_if(sets_, [&](const Set &set) {
        return set.kind == kind && set.name.size() == name.size() && same_word(set.name, name);
    });
    return found == sets_.end() ? nullptr : &*found;
}

InputSets::Set &InputSets::named(std::string_view name, Kind kind) {
    if (const Set *known = find(name, kind))
        return const_cast<Set &>(*known);
    return sets_.emplace_back(Set{std::string(name), kind, {}, {}, {}});
}

std::vector<bool> InputSets::members(const Set &set, const Tags &tags, std::int64_t &missing) const {
    std::vector<bool> found(tags.size());
    std::vector<const Set *> parts{&set};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (const auto &[first, last, step] : parts[i]->ranges) {
            if (first == last) {
                const std::int32_t number = tags.find(first);
                number < 0 ? void(++missing) : void(found[at(number)] = true);
                continue;
            }
            for (const auto &[tag, number] :
                 tags.between(first, last)) // unsigned: any two numbers of 64 bits
                if ((static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(first)) %
                        static_cast<std::uint64_t>(step) ==
                    0)
                    found[at(number)] = true;
        }
        for (const std::string &name : parts[i]->sets) {
            const Set *part = find(name, set.kind);
            missing += part == nullptr;
            if (part != nullptr && std::ranges::find(parts, part) == parts.end())
                parts.push_back(part);
        }
    }
    return found;
}

void InputSets::add_markers(const Tags &nodes, const Tags &elements, const std::vector<Element> &of_elements,
                            Arrays &mesh) const {
    Adder(*this, nodes, elements, of_elements, mesh).add();
}

} // namespace alphamst::io
