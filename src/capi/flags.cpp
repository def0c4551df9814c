#include <cmath>
#include <string>
#include <vector>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/ids.h"
#include "mesh/feature.h"

namespace alphamst::capi {
namespace {

constexpr std::int32_t every_flag = AMST_FLAG_FIXED | AMST_FLAG_FEATURE | AMST_FLAG_CORNER;
static_assert(int{AMST_FLAG_FIXED} == int{mesh::fixed} && int{AMST_FLAG_FEATURE} == int{mesh::feature} &&
              int{AMST_FLAG_CORNER} == int{mesh::corner});

using Flags = std::vector<std::uint8_t>;

Flags mesh::QuadMesh::*flags_of(Entity entity) {
    return entity == Entity::vertex ? &mesh::QuadMesh::vertex_flags
           : entity == Entity::edge ? &mesh::QuadMesh::edge_flags
                                    : &mesh::QuadMesh::face_flags;
}

void require_flags(std::int32_t bits, const char *name) {
    if ((bits & ~every_flag) != 0)
        throw Failure(Fault::range,
                      std::string(name) + " has bits that are no flag: " + std::to_string(bits));
}

void require_angle(double angle) {
    if (!std::isfinite(angle))
        throw Failure(Fault::not_finite, "angle is not a finite number");
    if (angle < 0 || angle > 180)
        throw Failure(Fault::range, "angle is in degrees, 0 to 180; it is " + std::to_string(angle));
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_set_flags(amst_mesh *mesh, std::int32_t entity, const amst_id *ids, std::int64_t n,
                                std::int32_t mask, std::int32_t value) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        target.context->require_idle();
        const Entity kind = entity_of(entity);
        const int base = index_base(mesh);
        const int count = count_of(*target.current, kind);
        require_number(n);
        require_flags(mask, "mask");
        require_flags(value, "value");
        require_ids(base, ids, n, count, kind);

        mesh::QuadMesh &flagged = target.writable();
        Flags &flags = flagged.*flags_of(kind);
        flags.resize(static_cast<std::size_t>(count));
        const bool marked = kind == Entity::vertex && !flagged.vertex_marker.empty();
        const auto set = [&](std::size_t i) {
            flags[i] = static_cast<std::uint8_t>((flags[i] & ~mask) | (value & mask));
            if (marked && flagged.vertex_marker[i] != 0)
                flags[i] |= mesh::corner;
        };
        visit_ids(base, ids, n, count, set);
    });
}

amst_status amst_mesh_get_flags(const amst_mesh *mesh, std::int32_t entity, std::int32_t *out,
                                std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = *required(mesh, "mesh").impl->current;
        const Entity kind = entity_of(entity);
        const int count = count_of(asked, kind);
        if (!answer(out, capacity, needed, count))
            return;
        const Flags &flags = asked.*flags_of(kind);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
            out[i] = i < flags.size() ? flags[i] : 0;
    });
}

amst_status amst_mesh_detect_features(amst_mesh *mesh, double angle, std::int64_t *found) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        target.context->require_idle();
        require_angle(angle);
        const mesh::Features features = mesh::find_features(*target.current, angle);
        mesh::QuadMesh &marked = target.writable();
        marked.edge_flags.resize(static_cast<std::size_t>(marked.n_edges()));
        marked.vertex_flags.resize(static_cast<std::size_t>(marked.n_vertices()));
        for (const int e : features.edges)
            marked.edge_flags[static_cast<std::size_t>(e)] |= mesh::feature;
        for (const int v : features.corners)
            marked.vertex_flags[static_cast<std::size_t>(v)] |= mesh::corner;
        if (found != nullptr)
            *found = static_cast<std::int64_t>(features.edges.size());
    });
}
