// The boundary as the caller knows it.
#include "capi/guard.h"
#include "capi/handles.h"

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_set_projection(amst_mesh *mesh, amst_projection_fn fn, void *user) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        target.context->require_idle();
        target.projection = fn;
        target.projection_user = user;
        target.writable().boundary.reset();
    });
}
