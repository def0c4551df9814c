#include "reference/cross_field.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>

#include "adapt/meshes.h"
#include "mesh/cross_field.h"
#include "mesh/curved.h"

namespace alphamst::reference {
namespace {

using Eigen::Vector3d;

Vector3d direction(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle), 0};
}

// A grid of squares whose faces have this direction, by column.
template <class Degrees> mesh::QuadMesh with_field(const Degrees &degrees) {
    mesh::QuadMesh mesh = adapt::samples::grid(4, 4, 3);
    std::vector<double> values;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const Vector3d cross = direction(degrees(f % 4));
        values.insert(values.end(), cross.data(), cross.data() + 3);
    }
    mesh.fields.set(std::make_shared<const mesh::Field>(
        mesh::Field{Entity::face, "cross", 3, mesh::Carry::drop, std::move(values)}));
    return mesh;
}

geometry::Quad square(double degrees) {
    const Vector3d u = direction(degrees), v = direction(degrees + 90), p(2, 2, 0);
    return {p, p + u, p + u + v, p + v};
}

TEST(ReferenceCrossField, IsTheFieldOfTheMeshAtTheNearestFace) {
    mesh::QuadMesh mesh = with_field([](int column) { return 10.0 * column; });
    const CrossField cross_field(mesh);
    mesh.fields.remove(Entity::face, "cross"); // the field is that of the mesh as it was
    for (int column = 0; column < 4; ++column)
        EXPECT_EQ(cross_field.at({column + 0.5, 1.3, 0.2}), direction(10.0 * column));
    EXPECT_EQ(cross_field.at({9, 2.5, 0}), direction(30));
}

TEST(ReferenceCrossField, IsComputedWhereTheMeshHasNone) {
    const mesh::QuadMesh mesh = mesh::sphere(5);
    const CrossField cross_field(mesh);
    const std::vector<double> expected = mesh::cross_field(mesh, 20);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const geometry::Quad quad = quad_of(mesh, f);
        const Vector3d found = cross_field.at((quad[0] + quad[1] + quad[2] + quad[3]) / 4);
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(found[k], expected[static_cast<std::size_t>(3 * f + k)]);
    }
}

TEST(ReferenceCrossField, TheErrorIsTheAngleToTheNearestOfFourDirections) {
    const CrossField cross_field(with_field([](int) { return 0.0; }));
    for (const auto &[turn, error] : {std::pair(0.0, 0.0), std::pair(20.0, 20.0), std::pair(45.0, 45.0),
                                      std::pair(70.0, 20.0), std::pair(-20.0, 20.0), std::pair(180.0, 0.0)}) {
        const std::vector<geometry::Quad> one{square(turn)};
        EXPECT_NEAR(cross_field.alignment_error(one), error, 1e-9);
        const std::vector<geometry::Quad> two{square(turn), square(0)};
        EXPECT_NEAR(cross_field.alignment_error(two), error / 2, 1e-9);
    }
    EXPECT_EQ(cross_field.alignment_error({}), 0);
}

} // namespace
} // namespace alphamst::reference
