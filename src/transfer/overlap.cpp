#include "transfer/overlap.h"

#include <algorithm>
#include <numeric>

#include "index.h"

namespace alphamst::transfer {
namespace {

// Around the corners of a part.
struct Ball {
    Eigen::Vector3d centre;
    double radius = 0;

    explicit Ball(const geometry::Quad &quad) : centre(geometry::centre(quad)) {
        for (const Eigen::Vector3d &corner : quad)
            radius = std::max(radius, (corner - centre).norm());
    }
    // A quarter farther than they reach, since on a surface they may be one above the other.
    bool meets(const Ball &other) const {
        return (centre - other.centre).norm() <= 1.25 * (radius + other.radius);
    }
};

} // namespace

std::vector<Overlap> overlaps(const Cells &before, const reference::FaceTree &tree, const Cells &after,
                              const std::vector<int> &faces) {
    std::vector<Overlap> found;
    std::vector<int> near;
    for (const int face : faces) {
        tree.around(reference::quad_of(after.mesh(), face), near);
        const Cells::Parts parts = after.parts(face);
        std::vector<Ball> balls;
        for (const Cells::Part &mine : parts)
            balls.emplace_back(mine.quad);
        for (const int other : near)
            for (const Cells::Part &theirs : before.parts(other)) {
                const Ball ball(theirs.quad);
                for (std::size_t i = 0; i < parts.count; ++i) {
                    if (!ball.meets(balls[i]))
                        continue;
                    const Cells::Part &mine = parts.all[i];
                    const geometry::Intersection shared = geometry::overlap(mine.quad, theirs.quad);
                    if (shared.area > 0)
                        found.push_back({theirs.cell, mine.cell, shared.area, shared.centroid});
                }
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
