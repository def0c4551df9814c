#include "quadrangulate/recut.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "index.h"
#include "quadrangulate/pairing.h"

namespace alphamst::quadrangulate {
namespace {

using Side = std::array<std::int32_t, 2>;
using Corners = std::array<std::int32_t, 4>;

struct Hash {
    std::size_t operator()(const Side &side) const {
        return std::hash<std::uint64_t>()(static_cast<std::uint64_t>(side[0]) << 32 |
                                          static_cast<std::uint64_t>(side[1]));
    }
};

Side sorted(Side edge) {
    if (edge[0] > edge[1])
        std::swap(edge[0], edge[1]);
    return edge;
}

class Recut {
public:
    Recut(QuadArrays &quads, const Polygons &polygons, const std::vector<bool> &on_boundary)
        : quads_(quads), polygons_(polygons), on_boundary_(on_boundary) {
        for (const Side &curve : polygons.curves)
            for (const Side &piece : pieces(quads, curve))
                curves_.insert(sorted(piece));
    }

    // Only the sides near the midpoints are of interest: one sweep finds their faces, a
    // second one the sides of these and of their neighbours.
    void find_sides(std::span<const Side> flat) {
        std::vector<bool> midpoint(quads_.points.size() / 3), near(midpoint.size());
        for (const Side &side : flat)
            midpoint[at(side[1])] = true;
        for (std::size_t f = 0; f < quads_.origin.size(); ++f) {
            const Corners face = corners(f);
            if (std::any_of(face.begin(), face.end(), [&](std::int32_t v) { return midpoint[at(v)]; }))
                for (const std::int32_t v : face)
                    near[at(v)] = true;
        }
        for (std::size_t f = 0; f < quads_.origin.size(); ++f) {
            const Corners face = corners(f);
            for (std::size_t k = 0; k < 4; ++k)
                if (near[at(face[k])] && near[at(face[(k + 1) % 4])])
                    face_of_[{face[k], face[(k + 1) % 4]}] = static_cast<std::int32_t>(f);
        }
    }

    void cut(const Side &flat) {
        const auto found = face_of_.find(flat);
        if (found == face_of_.end())
            return; // split by a row
        const std::int32_t face = found->second;
        const Corners quad = turned(face, flat[0]);
        const auto [a, m, b, c] = quad;
        struct Cut {
            Side side;
            std::int32_t neighbour = -1;
            Corners first, second;
            double gain = 0;
        } best;
        for (const Side &side : {Side{c, b}, Side{a, c}}) {
            const std::int32_t neighbour = across(face, side);
            if (neighbour < 0)
                continue;
            const Corners other = turned(neighbour, side[0]);
            const bool beyond_b = side[0] == c;
            const std::int32_t opposite = beyond_b ? other[3] : other[2];
            if (has_corner(quad, other[2]) || has_corner(quad, other[3]) || is_edge(m, opposite))
                continue;
            const Corners first = beyond_b ? Corners{m, b, other[2], opposite} : Corners{m, b, c, opposite};
            const Corners second = beyond_b ? Corners{opposite, c, a, m} : Corners{opposite, other[3], a, m};
            const double gain = std::min(worth(first), worth(second)) - std::min(worth(quad), worth(other));
            if (gain > best.gain)
                best = {side, neighbour, first, second, gain};
        }
        if (best.neighbour < 0)
            return;
        face_of_.erase(best.side);
        face_of_.erase({best.side[1], best.side[0]});
        replace(face, best.first);
        replace(best.neighbour, best.second);
    }

private:
    static bool has_corner(const Corners &quad, std::int32_t v) {
        return std::find(quad.begin(), quad.end(), v) != quad.end();
    }

    bool is_edge(std::int32_t v, std::int32_t w) const {
        return face_of_.contains({v, w}) || face_of_.contains({w, v});
    }

    double worth(const Corners &quad) const {
        const std::array<double, 4> sine = sines(quads_.points, quad);
        double least = 1;
        for (std::size_t k = 0; k < 4; ++k)
            least = std::min(least, sine[k] - (sine[k] < flattest && on_boundary_[at(quad[k])] ? 1 : 0));
        return least;
    }

    Corners corners(std::size_t face) const {
        Corners result;
        std::copy_n(quads_.faces.begin() + static_cast<std::ptrdiff_t>(4 * face), 4, result.begin());
        return result;
    }

    // The corners from v on.
    Corners turned(std::int32_t face, std::int32_t v) const {
        Corners result = corners(at(face));
        std::rotate(result.begin(), std::find(result.begin(), result.end(), v), result.end());
        return result;
    }

    // The face that has this side, if it may be cut together with `face`.
    std::int32_t across(std::int32_t face, const Side &side) const {
        const auto found = face_of_.find(side);
        if (found == face_of_.end() || found->second == face || curves_.contains(sorted(side)))
            return -1;
        const auto marker = [&](std::int32_t f) {
            return polygons_.face_marker.empty() ? 0 : polygons_.face_marker[at(quads_.origin[at(f)])];
        };
        return marker(found->second) == marker(face) ? found->second : -1;
    }

    void replace(std::int32_t face, const Corners &quad) {
        std::copy(quad.begin(), quad.end(), quads_.faces.begin() + 4 * std::ptrdiff_t{face});
        for (std::size_t k = 0; k < 4; ++k)
            face_of_[{quad[k], quad[(k + 1) % 4]}] = face;
    }

    QuadArrays &quads_;
    const Polygons &polygons_;
    const std::vector<bool> &on_boundary_;
    std::unordered_set<Side, Hash> curves_;
    std::unordered_map<Side, std::int32_t, Hash> face_of_;
};

} // namespace

void recut(QuadArrays &quads, const Polygons &polygons, std::span<const Side> flat,
           const std::vector<bool> &on_boundary) {
    Recut recut(quads, polygons, on_boundary);
    recut.find_sides(flat);
    for (const Side &side : flat)
        recut.cut(side);
}

} // namespace alphamst::quadrangulate
