// Numbers of boundaries, regions and points, and what they are called.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/ids.h"

namespace alphamst::capi {
namespace {

using Markers = std::vector<std::int32_t>;

Markers mesh::QuadMesh::*markers_of(Entity entity) {
    return entity == Entity::vertex ? &mesh::QuadMesh::vertex_marker
           : entity == Entity::edge ? &mesh::QuadMesh::edge_marker
                                    : &mesh::QuadMesh::face_marker;
}

// Other characters would break the lines and the quotes of files.
void require_name(std::string_view name) {
    for (const char c : name)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f' || c == '"')
            throw Failure(Fault::argument, "name of a marker: it has a control character or a double quote");
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_set_markers(amst_mesh *mesh, std::int32_t entity, const amst_id *ids, std::int64_t n,
                                  std::int32_t value) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        target.context->require_idle();
        const Entity kind = entity_of(entity);
        const int base = index_base(mesh), count = count_of(*target.current, kind);
        require_number(n);
        require_ids(base, ids, n, count, kind);

        mesh::QuadMesh &marked = target.writable();
        Markers &markers = marked.*markers_of(kind);
        markers.resize(static_cast<std::size_t>(count));
        if (kind == Entity::edge && value != 0)
            marked.curve_numbers = false; // somebody has named them now
        const auto set = [&](std::size_t i) {
            markers[i] = value;
            if (kind == Entity::vertex && value != 0)
                marked.vertex_flags[i] |= mesh::corner;
        };
        visit_ids(base, ids, n, count, set);
        if (std::all_of(markers.begin(), markers.end(), [](std::int32_t marker) { return marker == 0; }))
            markers.clear();
    });
}

amst_status amst_mesh_get_markers(const amst_mesh *mesh, std::int32_t entity, std::int32_t *out,
                                  std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = *required(mesh, "mesh").impl->current;
        const Entity kind = entity_of(entity);
        const int count = count_of(asked, kind);
        if (!answer(out, capacity, needed, count))
            return;
        const Markers &markers = asked.*markers_of(kind);
        if (markers.empty())
            std::fill_n(out, count, 0);
        else
            std::copy(markers.begin(), markers.end(), out);
    });
}

amst_status amst_mesh_get_marker_list(const amst_mesh *mesh, std::int32_t entity, std::int32_t *out,
                                      std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        Markers list = (*required(mesh, "mesh").impl->current).*markers_of(entity_of(entity));
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        list.erase(std::remove(list.begin(), list.end(), 0), list.end());
        if (answer(out, capacity, needed, static_cast<std::int64_t>(list.size())))
            std::copy(list.begin(), list.end(), out);
    });
}

amst_status amst_mesh_set_marker_name(amst_mesh *mesh, std::int32_t entity, std::int32_t marker,
                                      const char *name) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        target.context->require_idle();
        const Entity kind = entity_of(entity);
        if (marker == 0)
            throw Failure(Fault::argument, "marker is 0, which stands for none and has no name");
        std::string given = name == nullptr ? "" : name;
        require_name(given);
        mesh::QuadMesh &named = target.writable();
        if (given.empty())
            named.names.erase({kind, marker});
        else
            named.names[{kind, marker}].swap(given);
        if (kind == Entity::edge)
            named.curve_numbers = false;
    });
}

amst_status amst_mesh_get_marker_name(const amst_mesh *mesh, std::int32_t entity, std::int32_t marker,
                                      char *out, std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const Names &names = required(mesh, "mesh").impl->current->names;
        const auto found = names.find({entity_of(entity), marker});
        const std::string_view name = found == names.end() ? std::string_view() : found->second;
        if (!answer(out, capacity, needed, static_cast<std::int64_t>(name.size()) + 1))
            return;
        std::copy(name.begin(), name.end(), out);
        out[name.size()] = '\0';
    });
}
