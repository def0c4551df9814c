// From where a mesh is drawn, and where its vertices come to lie in the picture.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/arrays.h"

namespace alphamst::draw {

using Vector3 = std::array<double, 3>;

Vector3 cross_product(const Vector3 &a, const Vector3 &b);
double dot_product(const Vector3 &a, const Vector3 &b);
Vector3 difference(const Vector3 &a, const Vector3 &b);
Vector3 unit_vector(const Vector3 &a); // a itself where it has no length

// At right angles to the face, twice its area long.
Vector3 normal(const io::Arrays &mesh, const std::vector<Vector3> &points, std::size_t face);

struct Pixel {
    std::int64_t x, y; // y downwards
};

struct Drawing {
    std::vector<Vector3> points; // per vertex: to the right, up and to the eye, in units of the picture
    std::vector<Pixel> pixels;   // per vertex
    std::int64_t width = 0, height = 0;
    double edge = 0;     // mean length
    bool curved = false; // faces hide one another: not all in one plane
};

// The longer side of a drawing.
constexpr double longer_side = 10000;

// Along z when dim is 2, else along the mean normal. Where there is none, as on a closed surface, from
// the side and a little from above, so that as much of the picture is covered as can be.
Drawing project(const io::Arrays &mesh);

} // namespace alphamst::draw
