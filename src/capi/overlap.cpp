#include "transfer/overlap.h"

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/ids.h"

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_get_overlap(const amst_mesh *before, const amst_mesh *after, amst_id *before_faces,
                                  amst_id *after_faces, double *areas, std::int64_t capacity,
                                  std::int64_t *needed) {
    return guarded(index_base(after), [&] {
        const mesh::QuadMesh &from = *required(before, "before").impl->current,
                             &to = *required(after, "after").impl->current;
        if (from.dim() != to.dim())
            throw Failure(Fault::argument, "before has dim " + std::to_string(from.dim()) +
                                               ", after has dim " + std::to_string(to.dim()) +
                                               "; give two meshes of one domain");
        require_array(before_faces, capacity, "before_faces", "capacity");
        require_array(after_faces, capacity, "after_faces", "capacity");
        require_array(areas, capacity, "areas", "capacity");
        const std::vector<transfer::Overlap> rows = transfer::overlaps(from, to);
        if (!answer(areas, capacity, needed, static_cast<std::int64_t>(rows.size())))
            return;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            before_faces[i] = out(index_base(before), rows[i].before);
            after_faces[i] = out(index_base(after), rows[i].after);
            areas[i] = rows[i].area;
        }
    });
}
