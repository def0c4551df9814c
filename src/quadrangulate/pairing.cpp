#include "quadrangulate/pairing.h"

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <algorithm>
#include <cmath>

#include "index.h"
#include "quadrangulate/matching.h"
#include "quality/corner.h"

namespace alphamst::quadrangulate {
namespace {

using Vector = OpenMesh::Vec3d;
using Corners = std::array<std::int32_t, 4>;

Vector point(mesh::Coordinates points, std::int32_t v) {
    return {points[3 * at(v)], points[3 * at(v) + 1], points[3 * at(v) + 2]};
}

double over(double value, double length) { return length > 0 ? value / length : 0; }

// Of the normals of triangles abc and bad.
double cosine(mesh::Coordinates points, std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    const Vector p = point(points, a), side = point(points, b) - p;
    const Vector first = side % (point(points, c) - p), second = (point(points, d) - p) % side;
    return over(first | second, first.norm() * second.norm());
}

// What an edge of the dual may be used for, the later the less welcome.
enum Stage : std::uint8_t {
    sound,   // a convex quad
    unsound, // a quad to be mended by moving its vertices, or one over a sharp edge
    exits,   // a midpoint on the boundary
    border,  // a midpoint on a border
    stuck    // a quad with a corner of 180 degrees or more on the boundary, whose vertices do not move
};
constexpr std::array<double, TriangleDual::stages> penalty{0, 10, 100, 100, 1000};

constexpr double most_bent = 0.5; // 1 less the cosine of the angle between two normals: 60 degrees

class Builder {
public:
    Builder(mesh::Coordinates points, mesh::Faces faces, const std::vector<std::int32_t> &across,
            const std::vector<bool> &barred)
        : points_(points), faces_(faces), across_(across), barred_(barred), on_boundary_(points.size() / 3),
          node_of_(faces.size() / 4, -1) {
        for (std::size_t c = 0; c < faces.size(); ++c)
            if (faces[c] >= 0 && across[c] < 0)
                on_boundary_[at(faces[c])] = on_boundary_[at(faces[mesh::next_corner(faces, c)])] = true;
        for (std::size_t f = 0; f < node_of_.size(); ++f)
            if (mesh::is_triangle(faces, f)) {
                node_of_[f] = static_cast<std::int32_t>(face_of.size());
                face_of.push_back(static_cast<std::int32_t>(f));
            }
    }

    std::size_t n_faces() const { return node_of_.size(); }

    TriangleDual dual() const {
        const std::size_t n = 3 * face_of.size();
        TriangleDual dual{std::vector<std::int32_t>(n, TriangleDual::none), std::vector<float>(n),
                          std::vector<std::uint8_t>(n, TriangleDual::never)};
        for (std::size_t p = 0; p < n; ++p) {
            const std::size_t c = corner(p);
            if (across_[c] < 0) {
                dual.across[p] = TriangleDual::outside;
                dual.stage[p] = exits;
            } else if (const std::int32_t other = node_of_[at(across_[c] / 4)]; other >= 0) {
                const std::size_t q = 3 * at(other) + at(across_[c] % 4);
                dual.across[p] = static_cast<std::int32_t>(q);
                if (q < p) {
                    dual.stage[p] = dual.stage[q];
                    dual.cost[p] = dual.cost[q];
                } else {
                    measure(dual, p, c);
                }
            }
        }
        return dual;
    }

    std::vector<std::int32_t> face_of;

private:
    std::size_t corner(std::size_t place) const { return 4 * at(face_of[place / 3]) + place % 3; }

    void measure(TriangleDual &dual, std::size_t place, std::size_t c) const {
        const std::size_t b = mesh::next_corner(faces_, c);
        const std::int32_t left = faces_[mesh::next_corner(faces_, b)],
                           right =
                               faces_[mesh::next_corner(faces_, mesh::next_corner(faces_, at(across_[c])))];
        if (barred_[c] || left == right) {
            dual.stage[place] = border;
            dual.cost[place] = static_cast<float>(penalty[border]);
            return;
        }
        const Corners quad{faces_[c], right, faces_[b], left};
        const std::array<double, 4> sine = sines(points_, quad);
        const double least = *std::min_element(sine.begin(), sine.end());
        const double bend = 1 - cosine(points_, faces_[c], faces_[b], left, right);
        Stage stage = least >= flattest && bend <= most_bent ? sound : unsound;
        for (std::size_t k = 0; k < 4; ++k)
            if (sine[k] < flattest && on_boundary_[at(quad[k])])
                stage = stuck;
        dual.stage[place] = stage;
        dual.cost[place] = static_cast<float>((1 - least) * (1 - least) + bend + penalty[stage]);
    }

    mesh::Coordinates points_;
    mesh::Faces faces_;
    const std::vector<std::int32_t> &across_;
    const std::vector<bool> &barred_;
    std::vector<bool> on_boundary_;
    std::vector<std::int32_t> node_of_;
};

std::vector<Choice> choices_of(const Builder &builder, const TriangleDual &dual, const Matching &matching) {
    std::vector<Choice> choices(builder.n_faces());
    for (std::size_t node = 0; node < builder.face_of.size(); ++node) {
        const int side = matching.side(static_cast<int>(node)), mate = matching.mate(static_cast<int>(node));
        if (side < 0)
            continue;
        Choice &choice = choices[at(builder.face_of[node])];
        const std::uint8_t stage = dual.stage[3 * node + at(side)];
        choice.kind = stage == exits || stage == border ? Choice::Kind::halve : Choice::Kind::merge;
        choice.side = static_cast<std::int8_t>(side);
        choice.mate = mate < 0 ? -1 : builder.face_of[at(mate)];
    }
    return choices;
}

} // namespace

std::array<double, 4> sines(mesh::Coordinates points, const Corners &quad) {
    std::array<Vector, 4> p, edge;
    for (std::size_t k = 0; k < 4; ++k)
        p[k] = point(points, quad[k]);
    for (std::size_t k = 0; k < 4; ++k)
        edge[k] = p[(k + 1) % 4] - p[k];
    const Vector normal = (p[2] - p[0]) % (p[3] - p[1]);
    std::array<double, 4> result{};
    for (std::size_t k = 0; k < 4; ++k) {
        const Vector &before = edge[(k + 3) % 4];
        result[k] = quality::scaled_jacobian((before % edge[k]) | normal,
                                             before.norm() * edge[k].norm() * normal.norm());
    }
    return result;
}

std::vector<Choice> pair_triangles(mesh::Coordinates points, mesh::Faces faces,
                                   const std::vector<std::int32_t> &across, const std::vector<bool> &barred) {
    const Builder builder(points, faces, across, barred);
    const TriangleDual dual = builder.dual();
    Matching matching(dual);
    matching.take_cheapest(sound);
    for (const Stage stage : {sound, unsound, exits, border, stuck})
        matching.augment(stage);
    matching.improve();
    return choices_of(builder, dual, matching);
}

} // namespace alphamst::quadrangulate
