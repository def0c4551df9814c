// Ids cross the border here and nowhere else: base + index outside, index inside.
#pragma once

#include <cstdint>

#include "alphamst/alphamst.h"
#include "failure.h"
#include "mesh/quad_mesh.h"

namespace alphamst::capi {

// The caller's number of an index; -1 becomes "none".
inline amst_id out(int index_base, int index) noexcept { return index + index_base; }

// The index behind a caller's id. Failure (range) naming the id unless it is one of
// count; entity none stands for a patch.
int in(int index_base, std::int64_t id, std::int64_t count, Entity entity);

// Failure (range) for a negative number of ids.
void require_number(std::int64_t n);
// Failure (range) unless each of the n ids, if they are not null, is one of count.
void require_ids(int index_base, const amst_id *ids, std::int64_t n, int count, Entity entity);

// Calls visit(index) for each of the n ids, or of all that there are where ids is null.
template <class Visit>
void visit_ids(int index_base, const amst_id *ids, std::int64_t n, int count, Visit visit) {
    for (std::int64_t i = 0; i < (ids == nullptr ? count : n); ++i)
        visit(static_cast<std::size_t>(ids == nullptr ? i : ids[i] - index_base));
}

// VERTEX, EDGE or FACE; Failure (argument) for another value.
Entity entity_of(std::int32_t value);

int count_of(const mesh::QuadMesh &mesh, Entity entity) noexcept;

} // namespace alphamst::capi
