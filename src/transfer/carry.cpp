#include "transfer/carry.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "index.h"
#include "reference/locate.h"
#include "transfer/conserve.h"

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

// Whether the corners are the same vertices where they were.
bool same_place(const QuadMesh &before, const QuadMesh &after, int face) {
    for (const int v : after.corners(face)) {
        const std::int32_t origin = after.vertex_origin[at(v)];
        if (origin < 0 || before.point(origin) != after.point(v))
            return false;
    }
    return true;
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

    // The field of the mesh after the operation.
    std::shared_ptr<const Field> carried(const Field &field) {
        auto result = std::make_shared<Field>(field);
        const std::size_t width = at(field.components);
        const std::vector<std::int32_t> &origin = origins(after_, field.entity);
        result->values.assign(origin.size() * width, 0);
        for (std::size_t i = 0; i < origin.size(); ++i)
            if (origin[i] >= 0)
                std::copy_n(&field.values[at(origin[i]) * width], width, &result->values[i * width]);
        average(rule(field), field.values, result->values, width);
        if (field.carry == mesh::Carry::conserve) {
            if (!regions_)
                regions_.emplace(before_, after_, changed_);
            regions_->conserve(field.values, result->values, field.components);
        }
        return result;
    }

private:
    const Averages &rule(const Field &field) {
        if (field.carry == mesh::Carry::linear)
            return linear_ ? *linear_ : linear_.emplace(interpolated());
        if (field.carry == mesh::Carry::conserve)
            return conserve_ ? *conserve_ : conserve_.emplace(overlapped());
        std::optional<Averages> &inherit = inherit_[at(static_cast<int>(field.entity))];
        return inherit ? *inherit : inherit.emplace(inherited(field.entity));
    }

    static void average(const Averages &averages, std::span<const double> from, std::span<double> to,
                        std::size_t width) {
        for (std::size_t i = 0; i < averages.entities.size(); ++i)
            for (std::size_t c = 0; c < width; ++c) {
                double sum = 0, least = 0, largest = 0;
                for (std::size_t t = averages.begin[i]; t < averages.begin[i + 1]; ++t) {
                    const double value = from[at(averages.terms[t].from) * width + c];
                    const bool first = t == averages.begin[i];
                    sum += averages.terms[t].weight * value;
                    least = first ? value : std::min(least, value);
                    largest = first ? value : std::max(largest, value);
                }
                to[at(averages.entities[i]) * width + c] = std::clamp(sum, least, largest);
            }
    }

    template <class Visit> void each_new(Entity entity, Visit visit) const {
        const std::vector<std::int32_t> &origin = origins(after_, entity);
        for (std::size_t i = 0; i < origin.size(); ++i)
            if (origin[i] < 0)
                visit(static_cast<int>(i));
    }

    Averages inherited(Entity entity) const {
        const std::vector<int> candidates = entities_of(entity);
        std::vector<Vector3d> places;
        for (const int i : candidates)
            places.push_back(place(before_, entity, i));
        std::optional<reference::PointTree> points;
        Averages averages;
        each_new(entity, [&](int i) {
            if (!points)
                points.emplace(std::move(places));
            averages.terms.push_back({candidates[points->nearest(place(after_, entity, i))], 1});
            averages.end(i);
        });
        return averages;
    }

    Averages interpolated() {
        Averages averages;
        each_new(Entity::vertex, [&](int v) {
            const auto [face, spot] = faces().nearest(reference::point_of(after_, v));
            for (std::size_t i = 0; i < 4; ++i)
                if (spot.weights[i] > 0)
                    averages.terms.push_back({before_.corners(face)[i], spot.weights[i]});
            averages.end(v);
        });
        return averages;
    }

    Averages overlapped() {
        Averages averages;
        std::vector<int> others;
        for (const int f : changed_.after) {
            const geometry::Quad quad = reference::quad_of(after_, f);
            faces().around(quad, others);
            const std::size_t first = averages.terms.size();
            double sum = 0;
            for (const int other : others)
                if (const double area = geometry::overlap(quad, reference::quad_of(before_, other));
                    area > 0) {
                    averages.terms.push_back({other, area});
                    sum += area;
                }
            for (std::size_t t = first; t < averages.terms.size(); ++t)
                averages.terms[t].weight /= sum;
            if (averages.terms.size() == first) // flat, or beside what was there
                averages.terms.push_back({faces().nearest(place(after_, Entity::face, f)).face, 1});
            averages.end(f);
        }
        return averages;
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
    std::optional<Averages> inherit_[3], linear_, conserve_;
    std::optional<Regions> regions_;
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
    if (before.fields.empty())
        return;
    const bool connectivity = reconnected(before, after);
    std::optional<Carrier> carrier;
    mesh::Fields fields;
    for (const std::shared_ptr<const Field> &field : before.fields) {
        if (field->carry == mesh::Carry::drop && connectivity)
            continue;
        progress(1, "carry");
        if (!connectivity && field->carry != mesh::Carry::conserve) {
            fields.set(field);
            continue;
        }
        if (!carrier)
            carrier.emplace(before, after);
        fields.set(carrier->carried(*field));
    }
    after.fields = std::move(fields);
}

} // namespace alphamst::transfer
