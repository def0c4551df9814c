// Undoing: savepoints share the mesh they remember until it changes.
#include <algorithm>
#include <string>

#include "capi/guard.h"
#include "capi/handles.h"

namespace alphamst::capi {
namespace {

// The innermost savepoint of that name.
std::vector<Mesh::Savepoint>::iterator find(Mesh &mesh, std::int64_t revision) {
    const auto named = [&](const Mesh::Savepoint &savepoint) { return savepoint.revision == revision; };
    const auto found = std::find_if(mesh.savepoints.rbegin(), mesh.savepoints.rend(), named);
    if (found == mesh.savepoints.rend())
        throw Failure(Fault::not_found, "there is no savepoint of revision " + std::to_string(revision));
    return std::prev(found.base());
}

Mesh &idle(amst_mesh *handle) {
    Mesh &mesh = *required(handle, "mesh").impl;
    mesh.context->require_idle();
    return mesh;
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_mark(amst_mesh *mesh, std::int64_t *revision) {
    return guarded(index_base(mesh), [&] {
        Mesh &marked = idle(mesh);
        std::int64_t &told = required(revision, "revision");
        marked.savepoints.push_back({marked.revision, marked.current});
        told = marked.revision;
    });
}

amst_status amst_mesh_rollback(amst_mesh *mesh, std::int64_t revision) {
    return guarded(index_base(mesh), [&] {
        Mesh &restored = idle(mesh);
        const auto savepoint = find(restored, revision);
        restored.current = savepoint->mesh;
        restored.revision = revision;
        restored.savepoints.erase(std::next(savepoint), restored.savepoints.end());
    });
}

amst_status amst_mesh_forget(amst_mesh *mesh, std::int64_t revision) {
    return guarded(index_base(mesh), [&] {
        Mesh &kept = idle(mesh);
        kept.savepoints.erase(find(kept, revision));
    });
}
