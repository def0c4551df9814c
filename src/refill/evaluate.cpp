#include "refill/evaluate.h"

#include <algorithm>

#include "geometry/fit.h"
#include "reference/cross_field.h"
#include "reference/locate.h"
#include "smooth/shaping.h"

namespace alphamst::refill {
namespace {

// What moving the buffer has hardly ever mended (8 of 1,300 tries on two meshes).
constexpr double hopeless_poor = 20, hopeless_shape = 0.4;
// Part of the tolerance by which the surface is missed before vertices move, where it hardly ever is not
// missed afterwards (4 of 4,255 tries).
constexpr double hopeless_distance = 1.25;

// A scaled Jacobian down to which corners may be opened or closed to come nearer to the surface (that of
// whole meshes, see smooth/relax).
constexpr double spared = 0.3;

// Vertices of the window as its filling numbers them.
std::vector<int> all_of(const patch::Window &window) {
    std::vector<int> vertices = window.loop;
    vertices.insert(vertices.end(), window.interior.begin(), window.interior.end());
    return vertices;
}

// Forgets the places of the buffer.
void cut(CavityEmbedding &embedding, const fill::Filling &filling) {
    const auto n = static_cast<std::size_t>(filling.vertices);
    embedding.flat.resize(std::min(embedding.flat.size(), n));
    auto &on_surface = embedding.on_surface;
    on_surface.points.resize(std::min(on_surface.points.size(), n));
    on_surface.surface_triangles.resize(std::min(on_surface.surface_triangles.size(), n));
}

} // namespace

Evaluator::Evaluator(const mesh::QuadMesh &mesh, const Cavity &cavity, const BufferRing &buffer,
                     const Settings &settings, Trace &trace)
    : mesh_(mesh), cavity_(cavity), buffer_(buffer), settings_(settings),
      surface_distance_(cavity.reference().surface_distance),
      before_(both(shape_of(cavity.old_shape), buffer.shape())),
      features_(mesh.curves != nullptr && cavity.curved()), trace_(trace) {
    if (features_)
        most_inverted_ = inverted_ = buffer.inverted(cavity.old, cavity.on_surface(all_of(cavity.window)));
    if (!surface_distance_)
        return;
    most_distance_ = surface_distance_->tolerance();
    // The border of a patch stays, and may itself be far from the surface.
    for (std::size_t i = 0; cavity.curved() && buffer.stays() && i < cavity.window.faces.size(); ++i) {
        const int face = cavity.window.faces[i];
        const int triangle =
            cavity.reference().surface_triangles[static_cast<std::size_t>(mesh.corners(face)[0])];
        most_distance_ = std::max(most_distance_, distance_of(reference::quad_of(mesh, face), triangle));
    }
}

double Evaluator::distance_of(const geometry::Quad &quad, int surface_triangle) const {
    return cavity_.surface().follow(geometry::centre(quad), surface_triangle).distance;
}

bool Evaluator::fits(const fill::Filling &filling) {
    if (!cavity_.fits(filling))
        return trace_.refuse(Refused::edge);
    return !obstacles_.met_by(filling) || trace_.refuse(Refused::obstacle);
}

// Without points where the surface would be missed by far.
CavityEmbedding Evaluator::embed(const PlacedFilling &candidate, std::optional<double> size_weight,
                                 Refused &reason) {
    if (!cavity_.curved())
        return cavity_.embed(candidate, size_weight);
    CavityEmbedding start = cavity_.start(candidate, size_weight);
    if (surface_distance_ && !start.on_surface.points.empty() &&
        !surface_distance_->covers(cavity_.window.faces, buffer_.quads(candidate.filling, start),
                                   hopeless_distance)) {
        reason = Refused::distance;
        return {};
    }
    return cavity_.smooth(candidate.filling, std::move(start));
}

// A patch comes nearer to its surface between its vertices, as a whole mesh does at last.
void Evaluator::fit(const fill::Filling &filling, CavityEmbedding &embedding) const {
    std::vector<Eigen::Vector3d> middles;
    for (const geometry::Quad &q : buffer_.quads(filling, embedding))
        middles.push_back(geometry::centre(q));
    middles.resize(filling.quads.size());
    const reference::PointTree tree(std::move(middles));
    std::vector<geometry::Sample> samples;
    for (const int f : cavity_.window.faces)
        for (const int s : surface_distance_->samples(f)) {
            const Eigen::Vector3d &point = surface_distance_->point(s);
            samples.push_back({point, static_cast<int>(tree.nearest(point))});
        }
    std::vector<char> fixed(static_cast<std::size_t>(filling.vertices), 0);
    std::fill_n(fixed.begin(), filling.boundary, char(1));
    geometry::EmbedOptions options = smooth::shaping(settings_);
    const std::vector<double> areas = cavity_.areas(filling, embedding.on_surface);
    options.area = areas;
    CavityEmbedding fitted = embedding;
    geometry::fit(cavity_.surface(), filling.quads, fixed, fitted.on_surface, options, samples);
    static_cast<geometry::Judgement &>(fitted) = geometry::judge(filling.quads, fitted.on_surface);
    if (fitted.valid && fitted.min_scaled_jacobian >= std::min(embedding.min_scaled_jacobian, spared))
        embedding = std::move(fitted);
}

// The buffer moves only where the filling alone does not reach the bounds.
bool Evaluator::into_shape(const fill::Filling &filling, const ShapeBounds &bounds,
                           CavityEmbedding &embedding, Evaluation &evaluation) {
    evaluation.shape = both(shape_of(embedding), buffer_.shape());
    if (reaches(evaluation.shape, bounds))
        return true;
    if (buffer_.stays() || evaluation.shape.poor > bounds.poor + hopeless_poor ||
        (embedding.valid && evaluation.shape.shape < hopeless_shape * bounds.shape))
        return false;
    embedding = buffer_.improve(filling, std::move(embedding), smooth::shaping(settings_));
    evaluation.shape = shape_of(embedding);
    if (!reaches(evaluation.shape, bounds))
        return false;
    evaluation.replacement.moved = buffer_.moved(filling, embedding);
    return true;
}

// Whether filling and buffer stay near the surface, and the surface near them.
bool Evaluator::stays_near(const fill::Filling &filling, const CavityEmbedding &embedding,
                           Replacement &replacement) {
    const std::vector<geometry::Quad> quads = buffer_.quads(filling, embedding);
    for (std::size_t q = 0; cavity_.curved() && q < filling.quads.size(); ++q) {
        const auto first = static_cast<std::size_t>(filling.quads[q][0]);
        if (distance_of(quads[q], embedding.on_surface.surface_triangles[first]) > most_distance_)
            return false;
    }
    std::vector<int> faces = cavity_.window.faces;
    if (!replacement.moved.vertices.empty())
        faces.insert(faces.end(), buffer_.faces().begin(), buffer_.faces().end());
    auto owners = surface_distance_->cover(faces, quads);
    if (owners)
        replacement.owners = std::move(*owners);
    return owners.has_value();
}

std::optional<Evaluation> Evaluator::evaluate(const PlacedFilling &candidate, const ShapeBounds &bounds,
                                              std::optional<double> size_weight) {
    const fill::Filling &filling = candidate.filling;
    ++trace_.candidates;
    Refused reason = Refused::embedding;
    CavityEmbedding embedding = embed(candidate, size_weight, reason);
    if (embedding.stuck >= 0)
        obstacles_.learn(filling, embedding.stuck);
    // In space the faces around may be what keeps a corner inverted.
    if (!embedding.valid && (embedding.on_surface.points.empty() || buffer_.stays())) {
        trace_.refuse(reason);
        return std::nullopt;
    }
    if (cavity_.curved() && buffer_.stays() && surface_distance_)
        fit(filling, embedding);
    Evaluation evaluation;
    Replacement &replacement = evaluation.replacement;
    if (!into_shape(filling, bounds, embedding, evaluation)) {
        trace_.refuse(Refused::shape);
        return std::nullopt;
    }
    // Where the buffer moves as well, quads that stay inverted have come nearer to being repaired.
    if (features_ && buffer_.inverted(filling, embedding.on_surface) >
                         (replacement.moved.vertices.empty() ? most_inverted_ : inverted_)) {
        trace_.refuse(Refused::feature);
        return std::nullopt;
    }
    if (surface_distance_ && !stays_near(filling, embedding, replacement)) {
        trace_.refuse(Refused::distance);
        return std::nullopt;
    }
    if (const reference::CrossField *cross_field = cavity_.reference().cross_field) {
        const std::vector<geometry::Quad> quads = buffer_.quads(filling, embedding);
        replacement.alignment_error =
            cross_field->alignment_error(std::span(quads).first(filling.quads.size()));
    }
    cut(embedding, filling);
    if (cavity_.sized())
        evaluation.size_error = cavity_.size_error(filling, embedding);
    replacement.window = cavity_.window;
    replacement.filling = filling;
    replacement.points = cavity_.lift(embedding);
    if (!cavity_.curved())
        evaluation.flat = embedding.flat;
    if (cavity_.curved())
        replacement.surface_triangles.assign(embedding.on_surface.surface_triangles.begin() +
                                                 filling.boundary,
                                             embedding.on_surface.surface_triangles.end());
    replacement.singular_change = cavity_.singular_all(filling) - cavity_.old_singular_all;
    return evaluation;
}

} // namespace alphamst::refill
