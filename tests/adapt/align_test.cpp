#include "adapt/align.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include "eared.h"
#include "mesh/cross_field.h"
#include "mesh/reference.h"
#include "run.h"

namespace alphamst::adapt::samples {
namespace {

// Mean angle in degrees between the sides of the faces and the field there.
double angle(const mesh::QuadMesh &mesh, const Crosses &crosses) {
    std::vector<double> values;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const Quad corners = quad_of(mesh, f);
        const Eigen::Vector3d cross = crosses.at((corners[0] + corners[1] + corners[2] + corners[3]) / 4);
        values.insert(values.end(), cross.data(), cross.data() + 3);
    }
    return mesh::alignment(mesh, values);
}

mesh::QuadMesh adapted(mesh::QuadMesh mesh, bool align) {
    Settings settings;
    settings.align = align;
    const Outcome outcome = adapt_whole(mesh, 0.7, settings, silent);
    EXPECT_EQ(outcome.faces_after, outcome.faces_wanted);
    EXPECT_GT(outcome.quality_after, 0.1);
    return mesh;
}

TEST(Align, WholeMeshesFollowTheFieldOfTheirCurvature) {
    const mesh::QuadMesh before = eared(4);
    const Crosses crosses(before);
    const mesh::QuadMesh plain = adapted(before, false), aligned = adapted(before, true);
    EXPECT_LT(angle(aligned, crosses), 0.9 * angle(plain, crosses));
    EXPECT_EQ(plain.n_faces(), aligned.n_faces());
}

TEST(Align, OrTheFieldThatTheCallerSets) {
    mesh::QuadMesh mesh = eared(3);
    auto field = std::make_shared<mesh::Field>();
    field->entity = Entity::face;
    field->name = "cross";
    field->components = 3;
    for (int f = 0; f < mesh.n_faces(); ++f)
        field->values.insert(field->values.end(), {0.0, 0.0, f + 1.0});
    mesh.fields.set(field);
    const Crosses crosses(mesh);
    for (int f = 0; f < mesh.n_faces(); f += 7) {
        const Quad corners = quad_of(mesh, f);
        const Eigen::Vector3d near = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
        EXPECT_EQ(crosses.at(near).z(), f + 1.0);
    }
}

// In wanted edges; nothing is missing here, so nothing may be farther.
TEST(Tolerance, KeepsTheSurfaceNearTheMesh) {
    const mesh::QuadMesh before = eared(4);
    std::vector<double> most;
    for (const double tolerance : {0.2, 0.5, 20.0}) {
        mesh::QuadMesh mesh = before;
        Settings settings;
        settings.tolerance = tolerance;
        reduce_whole(mesh, settings, silent);
        std::vector<int> all(static_cast<std::size_t>(mesh.n_faces()));
        std::iota(all.begin(), all.end(), 0);
        const Faces faces(mesh, all);
        double far = 0;
        for (int v = 0; v < before.n_vertices(); ++v)
            far = std::max(far, faces.nearest(point_of(before, v)).spot.distance);
        const double edge = std::sqrt(mesh::surface_of(before)->area() / before.n_faces());
        most.push_back(std::sqrt(far) / edge);
    }
    EXPECT_LE(most[0], 0.2);
    EXPECT_LE(most[1], 0.5);
    EXPECT_GT(most[2], 2 * 0.2); // the tolerance does something: of an ear part went
}

} // namespace
} // namespace alphamst::adapt::samples
