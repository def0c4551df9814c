#include "capi/ids.h"

#include <string>

namespace alphamst::capi {
namespace {

std::string counted(std::int64_t count, const char *one, const char *many) {
    return count == 1 ? std::string("1 ") + one : std::to_string(count) + ' ' + many;
}

} // namespace

int in(int index_base, std::int64_t id, std::int64_t count, Entity entity) {
    const std::int64_t index = id - index_base;
    if (index >= 0 && index < count)
        return static_cast<int>(index);
    switch (entity) {
    case Entity::vertex:
        throw Failure(Fault::range,
                      "vertex {} does not exist: the mesh has " + counted(count, "vertex", "vertices"),
                      entity, {index});
    case Entity::edge:
        throw Failure(Fault::range, "edge {} does not exist: the mesh has " + counted(count, "edge", "edges"),
                      entity, {index});
    case Entity::face:
        throw Failure(Fault::range, "face {} does not exist: the mesh has " + counted(count, "face", "faces"),
                      entity, {index});
    case Entity::none:
        break;
    }
    Failure failure(Fault::range, "patch {} does not exist: there are " + counted(count, "patch", "patches"),
                    Entity::none, {index});
    failure.patch = index;
    throw failure;
}

void require_number(std::int64_t n) {
    if (n < 0)
        throw Failure(Fault::range, "n is negative: " + std::to_string(n));
}

void require_ids(int index_base, const amst_id *ids, std::int64_t n, int count, Entity entity) {
    if (ids != nullptr)
        for (std::int64_t i = 0; i < n; ++i)
            in(index_base, ids[i], count, entity);
}

Entity entity_of(std::int32_t value) {
    switch (value) {
    case AMST_VERTEX:
        return Entity::vertex;
    case AMST_EDGE:
        return Entity::edge;
    case AMST_FACE:
        return Entity::face;
    default:
        throw Failure(Fault::argument,
                      "entity must be AMST_VERTEX, AMST_EDGE or AMST_FACE, it is " + std::to_string(value));
    }
}

int count_of(const mesh::QuadMesh &mesh, Entity entity) noexcept {
    switch (entity) {
    case Entity::vertex:
        return mesh.n_vertices();
    case Entity::edge:
        return mesh.n_edges();
    case Entity::face:
        return mesh.n_faces();
    case Entity::none:
        break;
    }
    return 0;
}

} // namespace alphamst::capi
