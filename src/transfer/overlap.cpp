#include "transfer/overlap.h"

#include <numeric>

#include "index.h"

namespace alphamst::transfer {

std::vector<Overlap> overlaps(const Cells &before, const reference::FaceTree &tree, const Cells &after,
                              const std::vector<int> &faces) {
    std::vector<Overlap> found;
    std::vector<int> near;
    for (const int face : faces) {
        tree.around(reference::quad_of(after.mesh(), face), near);
        const Cells::Parts parts = after.parts(face);
        for (const int other : near)
            for (const Cells::Part &theirs : before.parts(other))
                for (const Cells::Part &mine : parts) {
                    const geometry::Overlap shared = geometry::overlap(mine.quad, theirs.quad);
                    if (shared.area > 0)
                        found.push_back({theirs.cell, mine.cell, shared.area, shared.centroid});
                }
    }
    return found;
}

std::vector<Overlap> overlaps(const mesh::QuadMesh &before, const mesh::QuadMesh &after) {
    const auto faces = [](const mesh::QuadMesh &mesh) {
        std::vector<int> all(at(mesh.n_faces()));
        std::iota(all.begin(), all.end(), 0);
        return all;
    };
    if (before.n_faces() == 0)
        return {};
    const reference::FaceTree tree(before, faces(before));
    return overlaps(Cells(before, Entity::face), tree, Cells(after, Entity::face), faces(after));
}

} // namespace alphamst::transfer
