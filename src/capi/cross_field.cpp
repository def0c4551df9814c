#include "mesh/cross_field.h"

#include <memory>
#include <utility>
#include <vector>

#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/options.h"
#include "capi/under_way.h"

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_compute_cross_field(amst_mesh *mesh, const amst_options *options) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        const UnderWay under_way(target.context);
        const Pace pace(under_way.progress(), "cross field");
        const int sweeps = options_of(options).smooth_steps;
        auto field = std::make_shared<mesh::Field>();
        field->entity = Entity::face;
        field->name = "cross";
        field->components = 3;
        field->carry = mesh::Carry::inherit;
        field->values = mesh::cross_field(*target.current, sweeps, pace);
        pace.reach(1);
        target.writable().fields.set(std::move(field));
    });
}

amst_status amst_mesh_get_alignment(const amst_mesh *mesh, double *mean_degrees) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = *required(mesh, "mesh").impl->current;
        double &told = required(mean_degrees, "mean_degrees");
        const std::vector<double> *crosses = asked.field(Entity::face, "cross");
        if (crosses == nullptr)
            throw Failure(Fault::not_found, "there is no field \"cross\" on faces; set one, or have it "
                                            "computed by amst_mesh_compute_cross_field");
        told = mesh::alignment(asked, *crosses);
    });
}
