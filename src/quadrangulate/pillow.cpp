#include "quadrangulate/pillow.h"

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <algorithm>
#include <array>

#include "index.h"
#include "quadrangulate/halve.h"
#include "quadrangulate/pairing.h"

namespace alphamst::quadrangulate {
namespace {

using Vector = OpenMesh::Vec3d;
using Points = std::array<Vector, 8>; // the corners of a quad, then those of the smaller one

// The faces in these points: the inner one, then those at its sides.
constexpr std::array<std::array<std::int32_t, 4>, 5> layout{
    {{4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

double worth(const Points &points) {
    std::array<double, 24> flat{};
    for (std::size_t i = 0; i < points.size(); ++i)
        std::copy_n(points[i].data(), 3, flat.begin() + static_cast<std::ptrdiff_t>(3 * i));
    double least = 1;
    for (const auto &quad : layout)
        for (const double sine : sines(flat, quad))
            least = std::min(least, sine);
    return least;
}

// The best of some places: scaled corners, and the one at the flat corner, which is the first, anywhere on
// the diagonal. Then each is moved while that helps.
double place(Points &points) {
    const Points given = points;
    const Vector centre = (given[0] + given[1] + given[2] + given[3]) / 4.0;
    double best = -1;
    for (const double scale : {0.3, 0.4, 0.5, 0.6})
        for (const double along : {0.1, 0.2, 0.3, 0.4, 0.5}) {
            Points trial = given;
            for (std::size_t k = 0; k < 4; ++k)
                trial[4 + k] = centre + scale * (given[k] - centre);
            trial[4] = given[0] + along * (given[2] - given[0]);
            if (const double value = worth(trial); value > best) {
                best = value;
                points = trial;
            }
        }
    const std::array<Vector, 2> directions{given[2] - given[0], given[3] - given[1]};
    constexpr int sweeps = 12; // the step halves where none helps: to 1 / 200 of the diagonals or so
    double step = 0.1;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        bool moved = false;
        for (std::size_t i = 4; i < points.size(); ++i)
            for (const Vector &direction : directions)
                for (const double sign : {1.0, -1.0}) {
                    Points trial = points;
                    trial[i] += sign * step * direction;
                    if (const double value = worth(trial); value > best) {
                        best = value;
                        points = trial;
                        moved = true;
                    }
                }
        if (!moved)
            step /= 2;
    }
    return best;
}

} // namespace

void pillow(QuadArrays &quads, const std::vector<bool> &fixed) {
    for (std::size_t f = 0, n = quads.origin.size(); f < n; ++f) {
        const auto first = quads.faces.begin() + static_cast<std::ptrdiff_t>(4 * f);
        std::array<std::int32_t, 4> corners{};
        std::copy_n(first, 4, corners.begin());
        const std::array<double, 4> sine = sines(quads.points, corners);
        const auto worst = static_cast<std::size_t>(std::ranges::min_element(sine) - sine.begin());
        if (sine[worst] >= flattest || !fixed[at(corners[worst])])
            continue;
        std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(worst), corners.end());
        Points points;
        for (std::size_t k = 0; k < 4; ++k)
            for (unsigned i = 0; i < 3; ++i)
                points[k][i] = quads.points[3 * at(corners[k]) + i];
        if (place(points) < flattest)
            continue;
        std::array<std::int32_t, 8> ids{};
        for (std::size_t i = 0; i < 8; ++i) {
            if (i < 4) {
                ids[i] = corners[i];
                continue;
            }
            ids[i] = static_cast<std::int32_t>(quads.points.size() / 3);
            quads.points.insert(quads.points.end(), points[i].data(), points[i].data() + 3);
        }
        const auto face = [&](std::size_t i) {
            std::array<std::int32_t, 4> result{};
            std::ranges::transform(layout[i], result.begin(), [&](std::int32_t k) { return ids[at(k)]; });
            return result;
        };
        std::ranges::copy(face(0), first);
        for (std::size_t i = 1; i < layout.size(); ++i)
            add_face(quads, quads.origin[f], face(i));
    }
}

} // namespace alphamst::quadrangulate
