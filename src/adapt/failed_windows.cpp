#include "adapt/failed_windows.h"

#include "digest.h"
#include "index.h"

namespace alphamst::adapt {
namespace {

void add(const refill::Goal &goal, Digest &digest) {
    for (const std::int64_t number : {goal.faces, goal.fewest, goal.most})
        digest.add(static_cast<std::uint64_t>(number));
    std::int32_t flags = 0;
    for (const bool flag : {goal.respace, goal.any_count, goal.keep_quality, goal.sizes, goal.forbid_old,
                            goal.turn, goal.collapse})
        flags = 2 * flags + static_cast<int>(flag);
    digest.add(flags, goal.most_added);
}

} // namespace

std::uint64_t fingerprint(const mesh::QuadMesh &mesh, const refill::Place &place, const refill::Goal &goal,
                          const refill::ShapeBounds &wanted, double tolerance) {
    Digest digest;
    digest.add(at(place.faces.size()));
    for (const auto *faces : {&place.faces, &place.buffer})
        for (const int f : *faces) {
            digest.add(f, 0);
            for (const int v : mesh.corners(f)) {
                digest.add(v, mesh.valence(v));
                for (const double x : mesh.point(v))
                    digest.add_real(x);
            }
        }
    add(goal, digest);
    for (const double x : {wanted.scaled_jacobian, wanted.shape, wanted.poor, tolerance})
        digest.add_real(x);
    digest.add(wanted.inverted, 0);
    return digest.value();
}

} // namespace alphamst::adapt
