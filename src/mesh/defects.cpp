#include "mesh/defects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "index.h"
#include "mesh/components.h"
#include "mesh/hanging.h"
#include "mesh/quad_mesh.h"

namespace alphamst::mesh {
namespace {

using Ids = std::vector<std::int64_t>;

struct Kind {
    Fault fault;
    Entity entity;
    const char *all, *first, *cure;
};

// In the order in which they are told. Those further down may be consequences of those above.
constexpr Kind not_finite{Fault::not_finite, Entity::vertex,
                          "vertices have coordinates that are infinite or not numbers",
                          "vertex {} has a coordinate that is infinite or not a number", "give finite ones"};
constexpr Kind no_vertex{Fault::range, Entity::face, "faces have corners that are no vertices",
                         "face {} has corner {}", "correct the corner or add the vertex"};
constexpr Kind repeated{Fault::not_quad, Entity::face, "faces have a vertex at two corners",
                        "face {} has vertex {} at two corners",
                        "give it three or four different corners, or leave it out"};
constexpr Kind crossing{
    Fault::not_manifold, Entity::face, "faces have their corners in crossing order",
    "face {} has its corners in crossing order, as pixels of VTK have: {}, {}, {}, {}",
    "list the corners of a face in the order in which one goes round it, say the last two exchanged"};
constexpr Kind given_twice{Fault::not_manifold, Entity::face, "faces are given twice",
                           "face {} has the vertices of face {}", "leave one of the two out"};
constexpr Kind crowded{Fault::not_manifold, Entity::face, "edges have more than two faces",
                       "face {} is the third one at the edge between vertices {} and {}",
                       "split the mesh there, with vertices of their own for the faces beyond"};
constexpr Kind one_sided{
    Fault::not_manifold, Entity::face, "surfaces have only one side, as a Moebius strip",
    "the surface of face {} has only one side, as a Moebius strip: over the edge between "
    "vertices {} and {} one comes back to it from behind",
    "cut it along edges from boundary to boundary, with the vertices there given twice"};
constexpr Kind hangs{
    Fault::not_manifold, Entity::vertex, "vertices hang in the middle of an edge",
    "vertex {} hangs in the middle of the edge between vertices {} and {}, which face {} has",
    "make it a corner of faces at both sides: divide the larger face, or join the smaller"};
constexpr Kind pinched{Fault::not_manifold, Entity::vertex, "vertices have faces without a common edge",
                       "the faces at vertex {} meet there without sharing edges",
                       "give each group of them a vertex of its own"};
constexpr Kind turned{
    Fault::not_manifold, Entity::face, "edges have two faces that run along them the same way",
    "faces {} and {} both run from vertex {} to vertex {}", "reverse the corners of one of them"};

// The sentences in the order in which they are told.
class Report {
public:
    void tell(const Kind &kind, std::int64_t n, const Ids &first, const std::string &detail = "") {
        if (n == 0)
            return;
        if (text_.empty())
            place_ = kind;
        else
            text_ += ". Besides, ";
        if (n > 1)
            text_ += std::to_string(n) + " " + kind.all + "; the first: ";
        text_ += kind.first + detail + "; " + kind.cure;
        ids_.insert(ids_.end(), first.begin(), first.end());
    }
    bool empty() const { return text_.empty(); }
    Failure failure() const { return {place_.fault, text_, place_.entity, ids_}; }

private:
    Kind place_{Fault::internal, Entity::none, "", "", ""};
    std::string text_;
    Ids ids_;
};

// How many there are of a kind, and the first.
struct Count {
    std::int64_t n = 0;
    Ids first;

    void add(const Ids &ids) {
        if (n++ == 0)
            first = ids;
    }
};

// Whether the corners are listed as those of VTK's pixels, say.
bool sides_cross(Coordinates points, Faces faces, const std::vector<std::int32_t> &across, std::size_t face) {
    if (faces[4 * face] < 0 || is_triangle(faces, face))
        return false;
    // Two of the sides are diagonals, which no neighbour has.
    const auto is_free = [&](std::size_t k) { return across[4 * face + k] < 0; };
    if (!(is_free(0) && is_free(2)) && !(is_free(1) && is_free(3)))
        return false;
    const auto point = [&](std::size_t k) {
        const std::size_t v = 3 * at(faces[4 * face + k]);
        return OpenMesh::Vec3d(points[v], points[v + 1], points[v + 2]);
    };
    const auto normal = [&](std::size_t i, std::size_t j, std::size_t k) {
        return (point(j) - point(i)) % (point(k) - point(i));
    };
    // Of a concave quad one diagonal has triangles that face each other, of a crossing one both have.
    return (normal(0, 1, 2) | normal(0, 2, 3)) < 0 && (normal(1, 2, 3) | normal(1, 3, 0)) < 0;
}

class Search {
public:
    Search(Coordinates points, Faces faces, std::size_t n_vertices, bool triangles)
        : points_(points), kept_(faces.begin(), faces.end()), faces_(kept_), n_vertices_(n_vertices),
          triangles_(triangles) {}

    // Whether there are any but faces that are turned over.
    bool find_lasting() {
        const bool finite = find_bad_points(), sound = find_bad_corners() && finite;
        sides_ = sort_sides(faces_, n_vertices_);
        across_ = neighbours(faces_, sides_);
        const bool in_order = find_crossing();
        find_repeated_faces();
        find_crowded_edges();
        // What else is odd may come from what was left out, or from crossing sides.
        if (sound && in_order) {
            find_one_sided();
            find_pinched();
        }
        return !report_.empty();
    }

    void find_turned() {
        Count bad;
        visit_edges(sides_, [&](std::span<const Side> sides) {
            if (sides.size() == 2 && runs_down(faces_, sides[0]) == runs_down(faces_, sides[1])) {
                const std::size_t c = at(sides[0].corner);
                bad.add(
                    {sides[1].corner / 4, sides[0].corner / 4, faces_[c], faces_[next_corner(faces_, c)]});
            }
        });
        report_.tell(turned, bad.n, bad.first);
    }

    Failure failure() const { return report_.failure(); }

private:
    bool find_bad_points() {
        Count bad;
        for (std::size_t v = 0; v < points_.size() / 3; ++v)
            if (!std::isfinite(points_[3 * v]) || !std::isfinite(points_[3 * v + 1]) ||
                !std::isfinite(points_[3 * v + 2]))
                bad.add({static_cast<std::int64_t>(v)});
        report_.tell(not_finite, bad.n, bad.first);
        if (bad.n > 0)
            points_ = {};
        return bad.n == 0;
    }

    // Faces that are bad are left out from then on.
    bool find_bad_corners() {
        Count beyond, twice;
        for (std::size_t f = 0; f < faces_.size() / 4; ++f) {
            if (has_corners(faces_, f, n_vertices_, triangles_))
                continue;
            const auto corners =
                std::span(kept_).subspan(4 * f, triangles_ && is_triangle(faces_, f) ? 3 : 4);
            const auto id = static_cast<std::int64_t>(f);
            const auto bad =
                std::ranges::find_if(corners, [&](std::int32_t v) { return v < 0 || at(v) >= n_vertices_; });
            if (bad != corners.end()) {
                beyond.add({id, *bad});
            } else {
                std::ranges::sort(corners);
                twice.add({id, *std::ranges::adjacent_find(corners)});
            }
            std::ranges::fill(std::span(kept_).subspan(4 * f, 4), -1);
        }
        report_.tell(no_vertex, beyond.n, beyond.first,
                     ", but the mesh has " + std::to_string(n_vertices_) + " vertices");
        report_.tell(repeated, twice.n, twice.first);
        return beyond.n + twice.n == 0;
    }

    bool find_crossing() {
        Count bad;
        for (std::size_t f = 0; f < faces_.size() / 4 && !points_.empty(); ++f)
            if (sides_cross(points_, faces_, across_, f))
                bad.add({static_cast<std::int64_t>(f), faces_[4 * f], faces_[4 * f + 1], faces_[4 * f + 2],
                         faces_[4 * f + 3]});
        report_.tell(crossing, bad.n, bad.first);
        return bad.n == 0;
    }

    // Two faces that are each other's back may be a pillow, but not where there are more.
    bool is_back(std::size_t f, std::size_t g) const {
        const std::int32_t *q = &faces_[4 * f], *r = &faces_[4 * g];
        const std::ptrdiff_t n = is_triangle(faces_, f) ? 3 : 4, k = std::find(r, r + n, q[0]) - r;
        for (std::ptrdiff_t i = 0; i < n; ++i)
            if (q[i] != r[(k - i + n) % n])
                return false;
        return true;
    }

    void find_repeated_faces() {
        is_repeated_.resize(faces_.size() / 4);
        std::vector<bool> crowded(faces_.size() / 4);
        visit_edges(sides_, [&](std::span<const Side> sides) {
            for (const Side &side : sides)
                if (sides.size() > 2)
                    crowded[at(side.corner) / 4] = true;
        });
        using Face = std::array<std::int32_t, 4>;
        std::vector<std::pair<Face, std::size_t>> sorted;
        for (std::size_t f = 0; f < faces_.size() / 4; ++f)
            if (faces_[4 * f] >= 0) {
                Face face{faces_[4 * f], faces_[4 * f + 1], faces_[4 * f + 2], faces_[4 * f + 3]};
                std::ranges::sort(face);
                sorted.emplace_back(face, f);
            }
        std::ranges::sort(sorted);
        std::vector<std::pair<std::size_t, std::size_t>> pairs;
        for (std::size_t i = 0, first = 0; i < sorted.size(); ++i) {
            if (sorted[i].first != sorted[first].first)
                first = i;
            const std::size_t f = sorted[i].second, g = sorted[first].second;
            if (i != first && (crowded[f] || !is_back(f, g)))
                pairs.emplace_back(f, g);
        }
        std::ranges::sort(pairs);
        Count bad;
        for (const auto &[f, g] : pairs) {
            is_repeated_[f] = true;
            bad.add({static_cast<std::int64_t>(f), static_cast<std::int64_t>(g)});
        }
        report_.tell(given_twice, bad.n, bad.first);
    }

    void find_crowded_edges() {
        Count bad;
        visit_edges(sides_, [&](std::span<const Side> sides) {
            std::vector<std::int32_t> corners;
            for (const Side &side : sides)
                if (!is_repeated_[at(side.corner) / 4])
                    corners.push_back(side.corner);
            if (corners.size() > 2)
                bad.add(
                    {corners[2] / 4, faces_[at(corners[0])], faces_[next_corner(faces_, at(corners[0]))]});
        });
        report_.tell(crowded, bad.n, bad.first);
    }

    void find_one_sided() {
        Count bad;
        for (const std::int32_t c : find_components(faces_, across_).one_sided)
            if (c >= 0)
                bad.add({c / 4, faces_[at(c)], faces_[next_corner(faces_, at(c))]});
        report_.tell(one_sided, bad.n, bad.first);
    }

    void find_pinched() {
        const std::vector<bool> at_hanging = find_hanging_vertices();
        const std::vector<bool> several = mesh::find_pinched(faces_, sides_, n_vertices_);
        Count bad;
        for (std::size_t v = 0; v < n_vertices_; ++v)
            if (several[v] && !at_hanging[v])
                bad.add({static_cast<std::int64_t>(v)});
        report_.tell(pinched, bad.n, bad.first);
    }

    // Those, and the ends of the edges where they hang: fans look apart there.
    std::vector<bool> find_hanging_vertices() {
        std::vector<bool> touched(n_vertices_);
        if (points_.empty())
            return touched;
        std::vector<std::array<std::int32_t, 2>> edges;
        std::vector<std::int64_t> owners;
        visit_edges(sides_, [&](std::span<const Side> sides) {
            const std::size_t c = at(sides[0].corner);
            if (sides.size() == 1) {
                edges.push_back({faces_[c], faces_[next_corner(faces_, c)]});
                owners.push_back(static_cast<std::int64_t>(c / 4));
            }
        });
        Count bad;
        for (const auto &[vertex, edge] : find_hanging(points_, edges)) {
            bad.add({vertex, edges[edge][0], edges[edge][1], owners[edge]});
            touched[at(vertex)] = touched[at(edges[edge][0])] = touched[at(edges[edge][1])] = true;
        }
        report_.tell(hangs, bad.n, bad.first);
        return touched;
    }

    Coordinates points_;
    std::vector<std::int32_t> kept_;
    Faces faces_;
    std::size_t n_vertices_;
    bool triangles_;
    EdgeSides sides_;
    std::vector<std::int32_t> across_;
    std::vector<bool> is_repeated_; // [face]
    Report report_;
};

} // namespace

Failure find_defects(Coordinates points, Faces faces, std::size_t n_vertices, bool triangles) {
    Search search(points, faces, n_vertices, triangles);
    if (!search.find_lasting())
        search.find_turned();
    return search.failure();
}

std::optional<Failure> find_lasting_defects(Coordinates points, Faces faces) {
    Search search(points, faces, points.size() / 3, true);
    return search.find_lasting() ? std::optional(search.failure()) : std::nullopt;
}

} // namespace alphamst::mesh
