#include "quality/metric.h"

#include <string>
#include <vector>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "reference/locate.h"

namespace alphamst::capi {
namespace {

static_assert(AMST_METRIC_AREA == static_cast<int>(quality::Metric::area) &&
              AMST_METRIC_SCALED_JACOBIAN == static_cast<int>(quality::Metric::scaled_jacobian) &&
              AMST_METRIC_WARPAGE == static_cast<int>(quality::Metric::warpage));

quality::Metric metric_of(std::int32_t metric) {
    if (metric < AMST_METRIC_AREA || metric > AMST_METRIC_WARPAGE)
        throw Failure(Fault::argument, "there is no metric " + std::to_string(metric));
    return static_cast<quality::Metric>(metric);
}

double mean_area(const mesh::QuadMesh &mesh) {
    double sum = 0;
    for (int f = 0; f < mesh.n_faces(); ++f)
        sum += quality::measure(quality::Metric::area, reference::quad_of(mesh, f), 1);
    return sum / mesh.n_faces();
}

void measure(const mesh::QuadMesh &mesh, quality::Metric metric, double *out) {
    const bool relative = metric == quality::Metric::relative_size ||
                          metric == quality::Metric::shape_and_size ||
                          metric == quality::Metric::shear_and_size;
    const double mean = relative ? mean_area(mesh) : 1;
    for (int f = 0; f < mesh.n_faces(); ++f)
        out[f] = quality::measure(metric, reference::quad_of(mesh, f), mean);
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_get_quality(const amst_mesh *mesh, std::int32_t metric, double *out,
                                  std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = *required(mesh, "mesh").impl->current;
        const quality::Metric which = metric_of(metric);
        if (answer(out, capacity, needed, asked.n_faces()))
            measure(asked, which, out);
    });
}

amst_status amst_mesh_get_summary(const amst_mesh *mesh, std::int32_t metric, amst_summary *out) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = *required(mesh, "mesh").impl->current;
        const quality::Metric which = metric_of(metric);
        amst_summary &told = required(out, "out");
        std::vector<double> values(static_cast<std::size_t>(asked.n_faces()));
        measure(asked, which, values.data());
        const quality::Summary summary = quality::summarise(which, values);
        told = {summary.count, summary.acceptable, summary.min, summary.max, summary.mean, summary.stddev};
    });
}
