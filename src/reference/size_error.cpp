#include "reference/size_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "index.h"

namespace alphamst::reference {
namespace {

// Faces without area count as this small, so that they have a logarithm.
constexpr double no_area = 1e-300;

double shortest_squared(const geometry::Quad &quad) {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 4; ++k)
        shortest = std::min(shortest, (quad[(k + 1) % 4] - quad[k]).squaredNorm());
    return shortest;
}

} // namespace

SizeError size_error(std::span<const geometry::Quad> quads, std::span<const double> log_wanted) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    SizeError error{0, infinity, infinity, {}};
    error.each.reserve(quads.size());
    for (std::size_t q = 0; q < quads.size(); ++q) {
        const double area = std::max(geometry::area_vector(quads[q]).norm(), no_area);
        const double e = (std::log(area) - log_wanted[q]) / std::numbers::ln2;
        error.each.push_back(e);
        error.rms += e * e;
        error.least = std::min(error.least, e);
        error.shortest_edge =
            std::min(error.shortest_edge, shortest_squared(quads[q]) * std::exp(-log_wanted[q]));
    }
    error.rms = std::sqrt(error.rms / static_cast<double>(quads.size()));
    error.shortest_edge = std::sqrt(error.shortest_edge);
    return error;
}

void tell_sizes_before(const SizeError &error, Outcome &outcome) {
    tell_sizes_after(error, outcome);
    outcome.size_error_before = outcome.size_error_after;
    outcome.least_area_before = outcome.least_area_after;
    outcome.shortest_edge_before = outcome.shortest_edge_after;
}

void tell_sizes_after(const SizeError &error, Outcome &outcome) {
    outcome.size_error_after = error.rms;
    outcome.least_area_after = std::exp2(error.least);
    outcome.shortest_edge_after = error.shortest_edge;
    outcome.size_errors = error.each;
}

WholeSizes::WholeSizes(const mesh::QuadMesh &mesh, Reference reference, std::int64_t wanted)
    : reference_(std::move(reference)), density_(SizingField::of(mesh, reference_, wanted)) {
    log_factor_ = std::log(std::max(density_->total(mesh), no_area) /
                           static_cast<double>(std::max<std::int64_t>(1, wanted)));
}

SizeError WholeSizes::error(const mesh::QuadMesh &mesh) {
    if (reference_.surface)
        reference_.surface_triangles = triangles_under(mesh, *reference_.surface);
    std::vector<geometry::Quad> quads;
    std::vector<double> log_wanted;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        quads.push_back(quad_of(mesh, f));
        log_wanted.push_back(log_factor_ - std::log(density_->of_face(mesh, f)));
    }
    return size_error(quads, log_wanted);
}

} // namespace alphamst::reference
