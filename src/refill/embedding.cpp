// Places for the fillings of a cavity, with the sizes that are wanted.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/match_areas.h"
#include "index.h"
#include "reference/sizing_field.h"
#include "refill/cavity.h"
#include "smooth/shaping.h"

namespace alphamst::refill {
namespace {

std::vector<char> fixed_in(const fill::Filling &filling) {
    std::vector<char> fixed(at(filling.vertices), 0);
    std::fill_n(fixed.begin(), filling.boundary, char(1));
    return fixed;
}

// Of a corner, over the wanted area of its face, that the smallest angles may cost. With .005, which does
// where nothing is said of sizes, faces shrink to 2^-7.6 of what is wanted; with .3 the time step at alpha =
// 1 to .63, with .4 to .8, with .5 to .9 of what it was, but then a third more singular vertices are needed.
constexpr double least_area = 0.4;

// In a chart sizes count and shapes are distorted: they come right on the surface. There wanted areas are
// asked for anew once vertices have moved.
constexpr int surface_rounds = 2;

// Of areas against shapes on a surface, where vertices move one by one: with .6, patches refined by 4 have an
// error of sizes of .75 instead of .61.
constexpr double surface_size_weight = 0.9;

geometry::EmbedOptions sized_shaping(const Settings &settings) {
    geometry::EmbedOptions options = smooth::shaping(settings);
    options.least_area = least_area;
    options.size_weight = surface_size_weight;
    return options;
}

std::vector<geometry::Quad> quads_of(const fill::Filling &filling,
                                     const std::vector<Eigen::Vector3d> &places) {
    std::vector<geometry::Quad> quads;
    for (const auto &q : filling.quads)
        quads.push_back({places[at(q[0])], places[at(q[1])], places[at(q[2])], places[at(q[3])]});
    return quads;
}

} // namespace

geometry::Embedding Cavity::embed_flat(const PlacedFilling &shape,
                                       const geometry::EmbedOptions &options) const {
    const fill::Filling &filling = shape.filling;
    if (!shape.positions.empty()) {
        geometry::Embedding kept =
            geometry::improve(filling.quads, fixed_in(filling), shape.positions, options);
        if (kept.valid)
            return kept;
    }
    return geometry::embed(filling.quads, filling.boundary, filling.vertices, loop_positions(), options);
}

CavityEmbedding Cavity::start(const PlacedFilling &shape, std::optional<double> size_weight) const {
    const fill::Filling &filling = shape.filling;
    CavityEmbedding laid;
    geometry::Points positions = shape.positions;
    if (positions.empty()) {
        geometry::EmbedOptions options = smooth::shaping(settings_);
        if (sized())
            options.steps = 0; // shapes come with sizes
        geometry::Embedding embedding = chart_->place(filling, options);
        laid.stuck = embedding.stuck;
        if (!embedding.valid)
            return laid;
        if (sized())
            embedding = with_areas(filling, std::move(embedding.positions),
                                   size_weight.value_or(settings_.size_weight));
        positions = std::move(embedding.positions);
    }
    for (int v = 0; v < filling.vertices; ++v) {
        const auto i = static_cast<std::size_t>(v);
        if (v < filling.boundary)
            laid.on_surface.add({old_on_surface_.surface_triangles[i], old_on_surface_.points[i],
                                 old_on_surface_.normals[i], 0});
        else
            laid.on_surface.add(chart_->lift(surface(), positions[i]));
    }
    return laid;
}

CavityEmbedding Cavity::smooth(const fill::Filling &filling, CavityEmbedding laid) const {
    if (laid.on_surface.points.empty())
        return laid;
    geometry::EmbedOptions options = sized() ? sized_shaping(settings_) : smooth::shaping(settings_);
    for (int round = 0; round < (sized() ? surface_rounds : 1); ++round) {
        const std::vector<double> wanted = areas(filling, laid.on_surface);
        options.area = wanted;
        static_cast<geometry::Judgement &>(laid) =
            geometry::improve(surface(), filling.quads, fixed_in(filling), laid.on_surface, options);
    }
    return laid;
}

CavityEmbedding Cavity::embed(const PlacedFilling &shape, std::optional<double> size_weight) const {
    if (curved())
        return smooth(shape.filling, start(shape, size_weight));
    geometry::EmbedOptions options = smooth::shaping(settings_);
    if (!sized())
        return flat_embedding(embed_flat(shape, options));
    options.steps = 0; // shapes come with sizes
    geometry::Embedding laid = embed_flat(shape, options);
    if (laid.valid)
        laid =
            with_areas(shape.filling, std::move(laid.positions), size_weight.value_or(settings_.size_weight));
    return flat_embedding(std::move(laid));
}

geometry::Embedding Cavity::with_areas(const fill::Filling &filling, geometry::Points positions,
                                       double weight) const {
    return geometry::match_areas(
        filling.quads, fixed_in(filling), std::move(positions),
        [&](const geometry::Points &now) { return wanted_areas(filling, now); }, weight,
        sized_shaping(settings_));
}

std::vector<double> Cavity::areas(const fill::Filling &filling,
                                  const geometry::SurfacePositions &on_surface) const {
    if (!sized())
        return reference_.areas(filling.quads, on_surface);
    std::vector<double> areas;
    double sum = 0;
    for (const geometry::Quad &q : quads_of(filling, on_surface.points)) {
        areas.push_back(sizes_->at(geometry::centre(q)));
        sum += areas.back();
    }
    const double total = geometry::total_area(filling.quads, on_surface);
    for (double &area : areas)
        area *= total / sum;
    return areas;
}

CavityEmbedding Cavity::flat_embedding(geometry::Embedding &&laid) {
    CavityEmbedding embedding;
    static_cast<geometry::Judgement &>(embedding) = laid;
    embedding.flat = std::move(laid.positions);
    embedding.stuck = laid.stuck;
    return embedding;
}

void Cavity::want_sizes() {
    std::vector<Eigen::Vector3d> places = old_on_surface_.points;
    for (std::size_t v = 0; !curved() && v < old_positions_.size(); ++v)
        places.emplace_back(old_positions_[v].x(), old_positions_[v].y(), 0);
    std::vector<double> areas;
    for (const int f : window.faces) {
        if (reference_.region_sizes != nullptr) {
            const geometry::Quad q = reference::quad_of(mesh_, f);
            areas.push_back(reference_.region_sizes->at(geometry::centre(q)));
        } else if (reference_.sizes != nullptr) {
            areas.push_back(1 / reference_.sizes->of_face(mesh_, f));
        }
    }
    std::vector<char> stays;
    for (std::size_t i = 0; reference_.boundary && !curved() && i < window.loop.size(); ++i)
        stays.push_back(!reference_.boundary->may_change(mesh_, window.loop[i],
                                                         window.loop[(i + 1) % window.loop.size()]));
    sizes_.emplace(old, places, static_cast<double>(goal_.faces), settings_.transition, std::move(areas),
                   stays);
    old_size_error_ =
        sizes_->error(curved() ? quads_of(old, old_on_surface_.points) : in_space(old, old_positions_));
}

std::vector<geometry::Quad> Cavity::in_space(const fill::Filling &filling,
                                             const geometry::Points &positions) const {
    std::vector<Eigen::Vector3d> places;
    for (const Eigen::Vector2d &p : positions)
        places.push_back(curved() ? chart_->lift(surface(), p).point : Eigen::Vector3d(p.x(), p.y(), 0));
    return quads_of(filling, places);
}

std::vector<double> Cavity::wanted_areas(const fill::Filling &filling,
                                         const geometry::Points &positions) const {
    const std::vector<geometry::Quad> quads = in_space(filling, positions);
    std::vector<double> areas;
    for (std::size_t f = 0; f < quads.size(); ++f) {
        const geometry::Quad &q = quads[f];
        areas.push_back(sizes_->at(geometry::centre(q)));
        // The chart stretches areas.
        if (curved())
            areas.back() *=
                geometry::signed_area(filling.quads[f], positions) / geometry::area_vector(q).norm();
    }
    return areas;
}

double Cavity::most_quality(const fill::Filling &filling) const {
    std::vector<int> faces(at(filling.boundary), 0);
    for (const auto &q : filling.quads)
        for (const int v : q)
            if (v < filling.boundary)
                ++faces[at(v)];
    double most = 1;
    for (std::size_t v = 0; v < faces.size(); ++v) {
        const double share = window.angles[v] / faces[v];
        // Some face gets no more than its share of a small angle, and some no less of a large one.
        most = std::min(most, share < 180 ? std::sin(share * std::numbers::pi / 180) : -1);
    }
    return most;
}

double Cavity::predicted_size_error(const PlacedFilling &shape) const {
    const fill::Filling &filling = shape.filling;
    if (!shape.positions.empty())
        return sizes_->error(in_space(filling, shape.positions)).rms;
    geometry::Points positions = geometry::embed_in_loop(filling.quads, filling.vertices, loop_positions());
    return sizes_->error(in_space(filling, positions)).rms;
}

SizeError Cavity::size_error(const fill::Filling &filling, const CavityEmbedding &embedding) const {
    if (!curved())
        return sizes_->error(in_space(filling, embedding.flat));
    return sizes_->error(quads_of(filling, embedding.on_surface.points));
}

} // namespace alphamst::refill
