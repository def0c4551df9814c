#include "adapt/respace.h"

#include <gtest/gtest.h>

#include "../mesh/grids.h"

namespace alphamst::adapt {
namespace {

TEST(Respace, LengthsFollowTheFacesOrTheField) {
    mesh::QuadMesh mesh = mesh::plane(10, 10).build();
    for (const bool wished : {false, true}) {
        if (wished) {
            auto size = std::make_shared<mesh::Field>();
            size->name = "size";
            size->entity = Entity::vertex;
            size->components = 1;
            for (int v = 0; v < mesh.n_vertices(); ++v)
                size->values.push_back(mesh.point(v)[0] < 5 ? 1 : 2);
            mesh.fields.set(size);
        }
        reference::Reference reference = reference::reference_of(mesh);
        const auto sizing = reference::SizingField::of(mesh, reference, 400);
        reference.face_weight = sizing->total(mesh) / 400;
        want_boundary(mesh, reference, *sizing, 400);
        ASSERT_TRUE(reference.boundary);
        const double left = reference.edge_length(reference.boundary->places[2]),
                     right = reference.edge_length(reference.boundary->places[8]);
        if (wished) {
            EXPECT_NEAR(right / left, 2, 1e-9);
        } else {
            EXPECT_NEAR(left, 0.5, 1e-9);
        }
    }
}

TEST(Respace, PassesAllowLessShapeInTheEnd) {
    const refill::ShapeBounds shape{0.3, 0.1, 3};
    const Pass pass = pass_of(respacings(false).front(), shape);
    EXPECT_EQ(pass.purpose, Purpose::respace);
    EXPECT_EQ(pass.size, respacings(false).front().size);
    EXPECT_EQ(pass.shape.scaled_jacobian, 0.3);
    EXPECT_LT(respacings(true).back().shape, respacings(true).front().shape);
}

} // namespace
} // namespace alphamst::adapt
