#include "quadrangulate/fields.h"

#include <gtest/gtest.h>

#include <memory>

namespace alphamst::quadrangulate {
namespace {

std::shared_ptr<mesh::Field> field(Entity entity, const char *name, mesh::Carry carry,
                                   std::vector<double> values) {
    return std::make_shared<mesh::Field>(mesh::Field{entity, name, 1, carry, std::move(values)});
}

// A square of two triangles, and beside it a triangle; the value is x + 2 y.
const std::vector<double> points{0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0, 3, 0, 0};
const std::vector<std::int32_t> faces{0, 1, 2, -1, 0, 2, 3, -1, 1, 4, 2, -1};

mesh::Fields given() {
    mesh::Fields fields;
    fields.set(field(Entity::vertex, "linear", mesh::Carry::linear, {0, 2, 4, 2, 3}));
    fields.set(field(Entity::vertex, "label", mesh::Carry::inherit, {10, 20, 30, 40, 50}));
    fields.set(field(Entity::face, "mean", mesh::Carry::conserve, {1, 2, 4}));
    fields.set(field(Entity::face, "label", mesh::Carry::inherit, {1, 2, 4}));
    return fields;
}

void expect_sound(const QuadArrays &quads) {
    const mesh::Fields fields = fields_of({points, faces, {}, {}}, given(), quads);
    const auto &linear = fields.find(Entity::vertex, "linear")->values;
    ASSERT_EQ(linear.size(), quads.points.size() / 3);
    for (std::size_t v = 0; v < linear.size(); ++v)
        EXPECT_NEAR(linear[v], quads.points[3 * v] + 2 * quads.points[3 * v + 1], 1e-12) << v;
    for (const double value : fields.find(Entity::vertex, "label")->values)
        EXPECT_TRUE(value == 10 || value == 20 || value == 30 || value == 40 || value == 50);
    double sum = 0; // of value * area, as before
    const auto &mean = fields.find(Entity::face, "mean")->values;
    ASSERT_EQ(mean.size(), quads.origin.size());
    for (std::size_t q = 0; q < mean.size(); ++q) {
        const auto x = [&](std::size_t k) {
            return quads.points[3 * static_cast<std::size_t>(quads.faces[4 * q + k])];
        };
        const auto y = [&](std::size_t k) {
            return quads.points[3 * static_cast<std::size_t>(quads.faces[4 * q + k]) + 1];
        };
        sum += mean[q] * ((x(2) - x(0)) * (y(3) - y(1)) - (x(3) - x(1)) * (y(2) - y(0))) / 2;
        EXPECT_EQ(fields.find(Entity::face, "label")->values[q],
                  std::vector<double>({1, 2, 4})[static_cast<std::size_t>(quads.origin[q])]);
    }
    EXPECT_NEAR(sum, 1 * 1 + 2 * 1 + 4 * 0.5, 1e-12);
}

TEST(QuadrangulateFields, OfSplitTriangles) {
    expect_sound(quadrangulate({points, faces, {}, {}}, Quadrangulation::split));
}

TEST(QuadrangulateFields, OfPairs) {
    const std::vector<std::int32_t> two(faces.begin(), faces.begin() + 8);
    const Polygons square{points, two, {}, {}};
    mesh::Fields fields;
    fields.set(field(Entity::face, "mean", mesh::Carry::conserve, {1, 2}));
    const QuadArrays quads = quadrangulate(square, Quadrangulation::pair);
    ASSERT_EQ(quads.origin.size(), 1u);
    EXPECT_EQ(fields_of(square, fields, quads).find(Entity::face, "mean")->values, std::vector<double>{1.5});
}

} // namespace
} // namespace alphamst::quadrangulate
