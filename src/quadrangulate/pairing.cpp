#include "quadrangulate/pairing.h"

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <algorithm>
#include <cmath>

#include "disjoint_sets.h"
#include "index.h"
#include "quadrangulate/cross.h"
#include "quadrangulate/exact_windows.h"
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

// What an edge of the dual may be used for, the later the less welcome.
enum Stage : std::uint8_t {
    sound,   // a convex quad
    unsound, // a quad to be mended by moving its vertices
    stuck,   // a quad with a corner of 180 degrees or more on the boundary or a border, whose vertices do not
             // move
    border,  // a midpoint on a border, or a quad over a sharp edge
    exits    // a midpoint on the boundary
};
constexpr std::array<double, TriangleDual::stages> penalty{0, 10, 1000, 100, 100};

constexpr double most_bent = 0.5; // 1 less the cosine of the angle between two normals: 60 degrees
// So much more than quads that are only bent cost those over creases, and concave or flat ones.
constexpr double crossing = 3, concavity = 5;
// As most_bent, of quads over sharp edges: 100 degrees. The edges of boxes are below, those of a tetrahedron
// above.
constexpr double most_crossed = 1.1736;
// Less than any other: a quad that was given is taken apart only for one that is left over. More is not
// needed, and would draw paths around.
constexpr float cost_of_given = -0.5F;
constexpr int most_rounds = 4; // of crosses: what follows from one is mostly found with it

class Pairs {
public:
    Pairs(mesh::Coordinates points, mesh::Faces faces, const TriangleSides &sides, bool may_leave)
        : points_(points), faces_(faces), sides_(sides), may_leave_(may_leave), fixed_(points.size() / 3),
          node_of_(faces.size() / 4, -1), taken_(faces.size() / 4) {
        for (std::size_t c = 0; c < faces.size(); ++c)
            if (faces[c] >= 0 && (sides.across[c] < 0) == (sides.bars[c] < Bar::sharp))
                fixed_[at(faces[c])] = fixed_[at(faces[mesh::next_corner(faces, c)])] = true;
        for (std::size_t f = 0; f < node_of_.size(); ++f)
            if (mesh::is_triangle(faces, f)) {
                node_of_[f] = static_cast<std::int32_t>(face_of_.size());
                face_of_.push_back(static_cast<std::int32_t>(f));
            }
        make_dual();
    }

    Pairing run() {
        Matching matching(dual_);
        matching.take_cheapest(sound);
        std::vector<std::int8_t> matched;
        for (int round = 0; round < most_rounds; ++round) {
            for (const Stage stage : {sound, unsound, border})
                matching.augment(stage);
            if (may_leave_)
                leave(matching);
            if (round == 0)
                matching.improve();
            match_windows(dual_, matching, matched);
            if (!sides_.diagonals.empty()) // one of many tries
                matched = matching.sides();
            if (!take_crosses(matching))
                break;
        }
        return pairing(matching);
    }

private:
    std::size_t corner(std::size_t place) const { return 4 * at(face_of_[place / 3]) + place % 3; }
    Corners quad_over(std::size_t c) const { return quadrangulate::quad_over(sides_, faces_, c); }

    void make_dual() {
        const std::size_t n = 3 * face_of_.size();
        dual_ = {std::vector<std::int32_t>(n, TriangleDual::none), std::vector<float>(n),
                 std::vector<std::uint8_t>(n, TriangleDual::never)};
        for (std::size_t p = 0; p < n; ++p) {
            const std::size_t c = corner(p);
            if (sides_.across[c] < 0) {
                dual_.across[p] = TriangleDual::outside;
                if (may_leave_ && sides_.bars[c] == Bar::none)
                    dual_.stage[p] = exits;
            } else if (const std::int32_t other = node_of_[at(sides_.across[c] / 4)]; other >= 0) {
                const std::size_t q = 3 * at(other) + at(sides_.across[c] % 4);
                dual_.across[p] = static_cast<std::int32_t>(q);
                if (q < p) {
                    dual_.stage[p] = dual_.stage[q];
                    dual_.cost[p] = dual_.cost[q];
                } else {
                    measure(p, c);
                }
            }
        }
    }

    // Whether the two triangles at the side become a quad, if they are mates.
    bool merges(std::size_t c) const {
        if (sides_.bars[c] >= Bar::sharp)
            return sides_.bars[c] == Bar::sharp && can_cross(sides_, points_, faces_, c);
        const Corners quad = quad_over(c);
        return quad[1] != quad[3];
    }

    void measure(std::size_t place, std::size_t c) {
        if (!sides_.diagonals.empty() && sides_.diagonals[c]) {
            dual_.stage[place] = sound;
            dual_.cost[place] = cost_of_given;
            return;
        }
        if (sides_.bars[c] >= Bar::sharp || !merges(c)) {
            dual_.stage[place] = border;
            dual_.cost[place] =
                static_cast<float>(penalty[border] + (merges(c) ? bend_over(sides_, points_, faces_, c) : 2));
            return;
        }
        const Corners quad = quad_over(c);
        const std::array<double, 4> sine = sines(points_, quad);
        const double least = *std::ranges::min_element(sine), bent = bend_over(sides_, points_, faces_, c);
        Stage stage = least >= flattest && bent <= most_bent && sides_.bars[c] == Bar::none ? sound : unsound;
        for (std::size_t k = 0; k < 4; ++k)
            if (sine[k] < flattest && fixed_[at(quad[k])])
                stage = stuck;
        dual_.stage[place] = stage;
        const double extra = least < flattest ? concavity : sides_.bars[c] == Bar::crease ? crossing : 0;
        dual_.cost[place] = static_cast<float>((1 - least) * (1 - least) + bent + penalty[stage] + extra);
    }

    // One triangle of each component that has an odd number of them gets a midpoint on the boundary.
    void leave(Matching &matching) const {
        std::vector<std::int32_t> free;
        for (std::size_t node = 0; node < face_of_.size(); ++node)
            if (matching.side(static_cast<int>(node)) < 0 && !taken_[at(face_of_[node])])
                free.push_back(static_cast<std::int32_t>(node));
        if (free.empty())
            return;
        DisjointSets components(faces_.size() / 4);
        for (std::size_t c = 0; c < faces_.size(); ++c)
            if (sides_.across[c] > static_cast<std::int32_t>(c))
                components.unite(static_cast<std::int32_t>(c / 4), sides_.across[c] / 4);
        std::vector<bool> odd(faces_.size() / 4);
        for (const std::int32_t f : face_of_)
            odd[at(components.find(f))].flip();
        for (std::size_t node = 0; node < face_of_.size(); ++node)
            if (const int side = matching.side(static_cast<int>(node));
                side >= 0 && dual_.across[3 * node + at(side)] == TriangleDual::outside)
                odd[at(components.find(face_of_[node]))] = false;
        matching.begin(exits);
        for (const std::int32_t node : free)
            if (auto due = odd[at(components.find(face_of_[at(node)]))]; due && matching.augment_from(node))
                due = false;
        matching.end();
    }

    // False if there are none to be taken.
    bool take_crosses(Matching &matching) {
        std::vector<std::int32_t> corners;
        for (std::size_t node = 0; node < face_of_.size(); ++node) {
            const int side = matching.side(static_cast<int>(node));
            if (side < 0 || matching.mate(static_cast<int>(node)) < static_cast<int>(node))
                continue;
            const std::size_t p = 3 * node + at(side), c = corner(p);
            if (dual_.stage[p] != unsound && dual_.stage[p] != stuck)
                continue;
            const std::array<double, 4> sine = sines(points_, quad_over(c));
            if (sine[0] < flattest)
                corners.push_back(static_cast<std::int32_t>(c));
            if (sine[2] < flattest)
                corners.push_back(static_cast<std::int32_t>(mesh::next_corner(faces_, c)));
        }
        const std::vector<Cross> found = crosses_from({points_, faces_, sides_}, corners, taken_);
        for (const Cross &cross : found)
            for (const std::int32_t face : cross.faces)
                remove(node_of_[at(face)], matching);
        crosses_.insert(crosses_.end(), found.begin(), found.end());
        return !found.empty();
    }

    void remove(std::int32_t node, Matching &matching) {
        if (const int mate = matching.mate(node); mate >= 0)
            matching.take(mate, -1);
        matching.take(node, -1);
        for (int side = 0; side < 3; ++side) {
            const std::size_t p = 3 * at(node) + at(side);
            if (dual_.across[p] >= 0) {
                dual_.across[at(dual_.across[p])] = TriangleDual::none;
                dual_.stage[at(dual_.across[p])] = TriangleDual::never;
            }
            dual_.across[p] = TriangleDual::none;
            dual_.stage[p] = TriangleDual::never;
        }
    }

    Pairing pairing(const Matching &matching) const {
        Pairing result;
        result.choices.resize(node_of_.size());
        result.crosses = crosses_;
        for (std::size_t i = 0; i < crosses_.size(); ++i)
            for (const std::int32_t face : crosses_[i].faces)
                result.choices[at(face)] = {Choice::Kind::cross, -1, static_cast<std::int32_t>(i)};
        for (std::size_t node = 0; node < face_of_.size(); ++node) {
            const int side = matching.side(static_cast<int>(node)),
                      mate = matching.mate(static_cast<int>(node));
            if (side < 0) {
                if (!taken_[at(face_of_[node])])
                    result.poor.push_back(face_of_[node]);
                continue;
            }
            const std::uint8_t stage = dual_.stage[3 * node + at(side)];
            if (stage == unsound || stage == stuck)
                result.poor.push_back(face_of_[node]);
            const std::size_t c = 4 * at(face_of_[node]) + at(side);
            const auto kind = mate >= 0 && merges(c) ? Choice::Kind::merge : Choice::Kind::halve;
            result.choices[at(face_of_[node])] = {kind, static_cast<std::int8_t>(side),
                                                  mate < 0 ? -1 : face_of_[at(mate)]};
        }
        return result;
    }

    mesh::Coordinates points_;
    mesh::Faces faces_;
    const TriangleSides &sides_;
    bool may_leave_;
    std::vector<bool> fixed_; // vertices that do not move off where they are
    std::vector<std::int32_t> face_of_, node_of_;
    std::vector<bool> taken_; // faces of crosses
    std::vector<Cross> crosses_;
    TriangleDual dual_;
};

} // namespace

double cosine(mesh::Coordinates points, std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    const Vector p = point(points, a), side = point(points, b) - p;
    const Vector first = side % (point(points, c) - p), second = (point(points, d) - p) % side;
    return over(first | second, first.norm() * second.norm());
}

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

Corners quad_over(const TriangleSides &sides, mesh::Faces faces, std::size_t corner) {
    const auto opposite = [&](std::size_t c) {
        return faces[mesh::next_corner(faces, mesh::next_corner(faces, c))];
    };
    return {faces[corner], opposite(at(sides.across[corner])), faces[mesh::next_corner(faces, corner)],
            opposite(corner)};
}

double bend_over(const TriangleSides &sides, mesh::Coordinates points, mesh::Faces faces,
                 std::size_t corner) {
    const Corners quad = quad_over(sides, faces, corner);
    return 1 - cosine(points, quad[0], quad[2], quad[3], quad[1]);
}

bool can_cross(const TriangleSides &sides, mesh::Coordinates points, mesh::Faces faces, std::size_t corner) {
    if (!mesh::is_triangle(faces, corner / 4) || !mesh::is_triangle(faces, at(sides.across[corner] / 4)))
        return false;
    const Corners quad = quad_over(sides, faces, corner);
    const std::array<double, 4> sine = sines(points, quad);
    return quad[1] != quad[3] && bend_over(sides, points, faces, corner) <= most_crossed &&
           *std::ranges::min_element(sine) >= flattest;
}

Pairing pair_triangles(mesh::Coordinates points, mesh::Faces faces, const TriangleSides &sides,
                       bool may_leave) {
    return Pairs(points, faces, sides, may_leave).run();
}

} // namespace alphamst::quadrangulate
