#include "reference/indicator.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "capi/guard.h"
#include "capi/handles.h"

using namespace alphamst;
using namespace alphamst::capi;

namespace {

void require_indicator(std::span<const double> indicator) {
    for (std::size_t f = 0; f < indicator.size(); ++f) {
        const auto face = static_cast<std::int64_t>(f);
        if (!std::isfinite(indicator[f]))
            throw Failure(Fault::not_finite, "face {} has an indicator that is not a finite number",
                          Entity::face, {face});
        if (indicator[f] < 0)
            throw Failure(Fault::range, "face {} has an indicator below 0; give its magnitude", Entity::face,
                          {face});
    }
}

void require_goal(double tolerance, std::int64_t faces, const reference::SizeRules &rules) {
    if (!std::isfinite(tolerance))
        throw Failure(Fault::not_finite, "tolerance is not a finite number");
    if (tolerance < 0 || faces < 0 || (tolerance == 0 && faces == 0))
        throw Failure(Fault::range,
                      "give a tolerance above 0, a number of faces above 0, or both; they are " +
                          std::to_string(tolerance) + " and " + std::to_string(faces));
    if (rules.max_edge > 0 && rules.max_edge < rules.min_edge)
        throw Failure(Fault::argument, "AMST_OPT_MAX_EDGE, " + std::to_string(rules.max_edge) +
                                           ", is below AMST_OPT_MIN_EDGE, " + std::to_string(rules.min_edge));
}

} // namespace

amst_status amst_mesh_size_from_indicator(amst_mesh *mesh, const double *indicator, std::int64_t n,
                                          double tolerance, std::int64_t faces, const amst_options *options,
                                          double *asked_faces) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        target.context->require_idle();
        require_array(indicator, n, "indicator", "n");
        if (n != target.current->n_faces())
            throw Failure(Fault::range, "n is " + std::to_string(n) + ", the mesh has " +
                                            std::to_string(target.current->n_faces()) + " faces");
        const std::span<const double> values(indicator, static_cast<std::size_t>(n));
        require_indicator(values);
        const Options rules = options_of(options);
        require_goal(tolerance, faces, rules);
        reference::Sizes sizes = reference::sizes_from_indicator(*target.current, values, tolerance,
                                                                 static_cast<double>(faces), rules);
        auto field = std::make_shared<mesh::Field>();
        *field = {Entity::vertex, "size", 1, mesh::Carry::linear, std::move(sizes.of_vertex)};
        target.writable().fields.set(std::move(field));
        if (asked_faces != nullptr)
            *asked_faces = sizes.faces;
    });
}
