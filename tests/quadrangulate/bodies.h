// Bodies with sharp edges, in triangles.
#pragma once

#include <set>

#include "triangles.h"

namespace alphamst::quadrangulate::triangles {

// A box of nx * ny * nz squares a side, each cut like an X or along a diagonal.
inline Input box(int nx, int ny, int nz, bool crosses) {
    Input input;
    std::map<std::array<int, 3>, std::int32_t> ids;
    const auto vertex = [&](std::array<int, 3> p) { // in half squares
        const auto [place, is_new] = ids.try_emplace(p, std::int32_t(input.n_points()));
        if (is_new)
            input.points.insert(input.points.end(), {p[0] / 2.0, p[1] / 2.0, p[2] / 2.0});
        return place->second;
    };
    const std::array<int, 3> n{nx, ny, nz};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true})
            for (int i = 0; i < n[(axis + 1) % 3]; ++i)
                for (int j = 0; j < n[(axis + 2) % 3]; ++j) {
                    const auto at = [&](int du, int dv) {
                        std::array<int, 3> p{};
                        p[axis] = far ? 2 * n[axis] : 0;
                        p[(axis + 1) % 3] = 2 * i + du;
                        p[(axis + 2) % 3] = 2 * j + dv;
                        return vertex(p);
                    };
                    Quad q{at(0, 0), at(2, 0), at(2, 2), at(0, 2)};
                    if (!far)
                        std::swap(q[1], q[3]);
                    if (crosses) {
                        const std::int32_t o = at(1, 1);
                        for (std::size_t k = 0; k < 4; ++k)
                            input.add(q[k], q[(k + 1) % 4], o);
                    } else {
                        input.add(q[0], q[1], q[2]);
                        input.add(q[2], q[3], q[0]);
                    }
                }
    return input;
}

// Of coordinates that are the same for all corners, at least one for each quad of a side.
inline bool is_on_one_side(const Input &body, const Quad &quad) {
    for (std::size_t k = 0; k < 3; ++k) {
        std::set<double> values;
        for (const std::int32_t v : quad)
            values.insert(body.points[3 * std::size_t(v) + k]);
        if (values.size() == 1)
            return true;
    }
    return false;
}

// A square of this half width with a round hole of radius 1 and so many edges: each is joined to the nearest
// corner.
inline Input plate(int around, double half) {
    Input input;
    const double pi = std::acos(-1.0);
    for (int i = 0; i < around; ++i) {
        const double a = 2 * pi * i / around;
        input.points.insert(input.points.end(), {std::cos(a), std::sin(a), 0});
    }
    for (int k = 0; k < 4; ++k) {
        const double a = pi / 2 * k + pi / 4;
        input.points.insert(input.points.end(),
                            {half * std::sqrt(2.0) * std::cos(a), half * std::sqrt(2.0) * std::sin(a), 0});
    }
    for (int i = 0; i < around; ++i) {
        const int corner = around + 4 * i / around;
        input.add(i, corner, (i + 1) % around);
        if (4 * ((i + 1) % around) / around != 4 * i / around)
            input.add((i + 1) % around, corner, around + 4 * ((i + 1) % around) / around);
    }
    return input;
}

} // namespace alphamst::quadrangulate::triangles
