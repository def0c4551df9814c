#include "transfer/carry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "index.h"
#include "transfer/conserve.h"
#include "transfer/reconstruct.h"

namespace alphamst::transfer {
namespace {

using Eigen::Vector3d;
using mesh::Field;
using mesh::QuadMesh;

const std::vector<std::int32_t> &origins(const QuadMesh &mesh, Entity entity) {
    return entity == Entity::vertex ? mesh.vertex_origin
           : entity == Entity::edge ? mesh.edge_origin
                                    : mesh.face_origin;
}

bool same_point(const QuadMesh &before, const QuadMesh &after, int v) {
    const std::int32_t origin = after.vertex_origin[at(v)];
    return origin >= 0 && before.point(origin) == after.point(v);
}

// Whether the corners are the same vertices where they were.
bool same_place(const QuadMesh &before, const QuadMesh &after, int face) {
    const std::array<int, 4> corners = after.corners(face);
    return std::all_of(corners.begin(), corners.end(), [&](int v) { return same_point(before, after, v); });
}

bool on_boundary(const QuadMesh &mesh, int edge) {
    const std::array<int, 2> faces = mesh.edge_faces(edge);
    return faces[0] < 0 || faces[1] < 0;
}

// Of an edge whether it is on the boundary, and its number: values of one kind do not go to another.
using Kind = std::pair<bool, std::optional<std::int32_t>>;

Kind kind_of(const QuadMesh &mesh, Entity entity, int i) {
    if (entity != Entity::edge)
        return {false, 0};
    return {on_boundary(mesh, i), mesh.edge_marker.empty() ? 0 : mesh.edge_marker[at(i)]};
}

// Of which the nearest is wanted.
class Candidates {
public:
    void add(int entity, const Vector3d &place) {
        entities_.push_back(entity);
        places_.push_back(place);
    }
    int nearest(const Vector3d &place) {
        if (!tree_)
            tree_.emplace(places_);
        return entities_[tree_->nearest(place)];
    }

private:
    std::vector<int> entities_;
    std::vector<Vector3d> places_;
    std::optional<reference::PointTree> tree_;
};

bool is_conserved(const Field &field) {
    return field.carry == mesh::Carry::conserve || field.carry == mesh::Carry::average;
}

Changed changed_faces(const QuadMesh &before, const QuadMesh &after) {
    Changed changed;
    std::vector<char> same(at(before.n_faces()), 0);
    for (int f = 0; f < after.n_faces(); ++f) {
        const std::int32_t origin = after.face_origin[at(f)];
        if (origin >= 0 && same_place(before, after, f))
            same[at(origin)] = 1;
        else
            changed.after.push_back(f);
    }
    for (int f = 0; f < before.n_faces(); ++f)
        if (!same[at(f)])
            changed.before.push_back(f);
    return changed;
}

// Entities of the mesh after the operation, and of which ones before it their values are averages.
struct Averages {
    struct Term {
        int from;
        double weight;
    };
    std::vector<int> entities;
    std::vector<std::size_t> begin{0}; // [entities + 1] in terms
    std::vector<Term> terms;

    void end(int entity) {
        entities.push_back(entity);
        begin.push_back(terms.size());
    }
};

class Carrier {
public:
    Carrier(const QuadMesh &before, const QuadMesh &after)
        : before_(before), after_(after), changed_(changed_faces(before, after)) {}

    bool nothing_changed() const { return changed_.before.empty() && changed_.after.empty(); }

    // The field of the mesh after the operation.
    std::shared_ptr<const Field> carried(const Field &field) {
        auto result = std::make_shared<Field>(field);
        const std::size_t width = at(field.components);
        const std::vector<std::int32_t> &origin = origins(after_, field.entity);
        result->values.assign(origin.size() * width, 0);
        for (std::size_t i = 0; i < origin.size(); ++i)
            if (origin[i] >= 0)
                std::copy_n(&field.values[at(origin[i]) * width], width, &result->values[i * width]);
        if (changed_.before.empty())
            return result;
        if (is_conserved(field)) {
            conserve(field, result->values);
        } else {
            // Values of "size" have to stay above 0.
            average(rule(field), field.values, result->values, width, field.name == "size");
        }
        return result;
    }

private:
    const Averages &rule(const Field &field) {
        if (field.carry == mesh::Carry::linear)
            return linear_ ? *linear_ : linear_.emplace(interpolated());
        std::optional<Averages> &inherit = inherit_[at(static_cast<int>(field.entity))];
        return inherit ? *inherit : inherit.emplace(inherited(field.entity));
    }

    // What is continued beyond the old mesh, by negative weights, may leave the range of its terms, unless
    // `bounded`.
    static void average(const Averages &averages, std::span<const double> from, std::span<double> to,
                        std::size_t width, bool bounded) {
        for (std::size_t i = 0; i < averages.entities.size(); ++i)
            for (std::size_t c = 0; c < width; ++c) {
                double sum = 0, least = 0, largest = 0;
                bool inside = true;
                for (std::size_t t = averages.begin[i]; t < averages.begin[i + 1]; ++t) {
                    const auto &[term, weight] = averages.terms[t];
                    const double value = from[at(term) * width + c];
                    const bool first = t == averages.begin[i];
                    sum += weight * value;
                    least = first ? value : std::min(least, value);
                    largest = first ? value : std::max(largest, value);
                    inside = inside && weight > 0;
                }
                to[at(averages.entities[i]) * width + c] =
                    inside || bounded ? std::clamp(sum, least, largest) : sum;
            }
    }

    Averages inherited(Entity entity) const {
        std::map<Kind, Candidates> kinds;
        for (const int i : entities_of(entity)) {
            const Kind kind = kind_of(before_, entity, i);
            kinds[kind].add(i, place(before_, entity, i));
            kinds[{kind.first, std::nullopt}].add(i, place(before_, entity, i));
        }
        Averages averages;
        for (int i = 0; i < static_cast<int>(origins(after_, entity).size()); ++i) {
            if (!is_new(entity, i))
                continue;
            const Kind kind = kind_of(after_, entity, i);
            auto found = kinds.find(kind);
            if (found == kinds.end())
                found = kinds.find({kind.first, std::nullopt});
            if (found != kinds.end())
                averages.terms.push_back({found->second.nearest(place(after_, entity, i)), 1});
            averages.end(i);
        }
        return averages;
    }

    bool is_new(Entity entity, int i) const {
        const std::int32_t origin = origins(after_, entity)[at(i)];
        return origin < 0 ||
               (entity == Entity::edge && on_boundary(before_, origin) != on_boundary(after_, i));
    }

    // On a surface nothing is continued: beyond a bend is no beyond.
    Averages interpolated() {
        const bool flat = after_.dim() == 2 || after_.surface == nullptr;
        Averages averages;
        for (int v = 0; v < after_.n_vertices(); ++v) {
            if (same_point(before_, after_, v))
                continue;
            const Vector3d point = reference::point_of(after_, v);
            const auto [face, spot] = faces().nearest(point);
            const geometry::QuadPoint place =
                flat ? geometry::continued_point(reference::quad_of(before_, face), point) : spot;
            for (std::size_t i = 0; i < 4; ++i)
                if (place.weights[i] != 0)
                    averages.terms.push_back({before_.corners(face)[i], place.weights[i]});
            averages.end(v);
        }
        return averages;
    }

    struct Conserved {
        Reconstruction means;
        Regions regions;
    };

    void conserve(const Field &field, std::vector<double> &values) {
        std::optional<Conserved> &found = conserved_[at(static_cast<int>(field.entity))];
        if (!found) {
            const Cells before(before_, field.entity), after(after_, field.entity);
            found.emplace(
                Conserved{Reconstruction(before, covered(before, after)), Regions(before, after, changed_)});
        }
        found->means.average(field.values, values, field.components, field.carry == mesh::Carry::conserve);
        found->regions.conserve(field.values, values, field.components);
    }

    // Overlaps of the cells of changed faces. A vertex between these and others has parts that stay.
    std::vector<Overlap> covered(const Cells &before, const Cells &after) {
        std::vector<Overlap> found = overlaps(before, faces(), after, changed_.after);
        std::vector<char> has(at(after.count()), 0);
        for (const Overlap &overlap : found)
            has[at(overlap.after)] = 1;
        for (const int cell : after.of(changed_.after)) {
            if (after.entity() == Entity::vertex)
                for (const int f : after_.faces_around(cell)) {
                    if (std::binary_search(changed_.after.begin(), changed_.after.end(), f))
                        continue;
                    for (const Cells::Part &part : after.parts(f))
                        if (part.cell == cell) {
                            found.push_back({after_.vertex_origin[at(cell)], cell,
                                             geometry::area_vector(part.quad).norm(),
                                             geometry::area_centroid(part.quad)});
                            has[at(cell)] = 1;
                        }
                }
            if (!has[at(cell)]) { // flat, or beside what was there
                const int old = nearest_cell(before, after.place(cell).centroid);
                found.push_back({old, cell, 1, before.place(old).centroid});
            }
        }
        return found;
    }

    int nearest_cell(const Cells &before, const Vector3d &point) {
        std::pair<double, int> best{HUGE_VAL, 0};
        for (const Cells::Part &part : before.parts(faces().nearest(point).face))
            best = std::min(best, {(geometry::centre(part.quad) - point).squaredNorm(), part.cell});
        return best.second;
    }

    // Those of the changed faces before the operation, ascending.
    std::vector<int> entities_of(Entity entity) const {
        if (entity == Entity::face)
            return changed_.before;
        std::vector<int> result;
        for (const int f : changed_.before) {
            const std::array<int, 4> corners = before_.corners(f);
            for (std::size_t i = 0; i < 4; ++i)
                result.push_back(entity == Entity::vertex
                                     ? corners[i]
                                     : before_.find_edge(corners[i], corners[(i + 1) % 4]));
        }
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }

    static Vector3d place(const QuadMesh &mesh, Entity entity, int i) {
        if (entity == Entity::vertex)
            return reference::point_of(mesh, i);
        if (entity == Entity::edge) {
            const auto [v, w] = mesh.edge_vertices(i);
            return (reference::point_of(mesh, v) + reference::point_of(mesh, w)) / 2;
        }
        const geometry::Quad quad = reference::quad_of(mesh, i);
        return geometry::centre(quad);
    }

    const reference::FaceTree &faces() {
        return faces_ ? *faces_ : *(faces_ = std::make_unique<reference::FaceTree>(before_, changed_.before));
    }

    const QuadMesh &before_, &after_;
    const Changed changed_;
    std::unique_ptr<const reference::FaceTree> faces_;
    std::optional<Averages> inherit_[3], linear_;
    std::optional<Conserved> conserved_[3];
};

} // namespace

bool reconnected(const QuadMesh &before, const QuadMesh &after) {
    if (before.n_faces() != after.n_faces() || before.n_edges() != after.n_edges())
        return true;
    for (std::size_t f = 0; f < after.face_origin.size(); ++f)
        if (after.face_origin[f] != static_cast<std::int32_t>(f))
            return true;
    return false;
}

void carry(const QuadMesh &before, QuadMesh &after, const Progress &progress) {
    mesh::Fields old = before.fields;
    for (const std::shared_ptr<const Field> &field : after.fields) // an operation may have set some
        old.set(field);
    if (old.empty())
        return;
    const bool connectivity = reconnected(before, after);
    std::optional<Carrier> carrier;
    mesh::Fields fields;
    for (const std::shared_ptr<const Field> &field : old) {
        if (field->carry == mesh::Carry::drop && connectivity)
            continue;
        progress(1, "carry");
        const bool follows_points = field->carry == mesh::Carry::linear || is_conserved(*field);
        if ((connectivity || follows_points) && !carrier)
            carrier.emplace(before, after);
        const bool stays = !connectivity && (!follows_points || carrier->nothing_changed());
        fields.set(stays ? field : carrier->carried(*field));
    }
    after.fields = std::move(fields);
}

} // namespace alphamst::transfer
