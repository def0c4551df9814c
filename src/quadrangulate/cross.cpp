#include "quadrangulate/cross.h"

#include <algorithm>

#include "index.h"

namespace alphamst::quadrangulate {
namespace {

constexpr double flat = 0.99985; // cosine of 1 degree: the vertex that goes is not missed

std::int32_t next(const Surroundings &mesh, std::int32_t corner) {
    return static_cast<std::int32_t>(mesh::next_corner(mesh.faces, at(corner)));
}

} // namespace

std::optional<Cross> cross_around(const Surroundings &mesh, std::int32_t corner) {
    Cross cross;
    for (std::size_t k = 0; k < 4; ++k) {
        if (k > 0 && corner / 4 == cross.faces[0])
            return std::nullopt;
        cross.faces[k] = corner / 4;
        if (!mesh::is_triangle(mesh.faces, at(cross.faces[k])))
            return std::nullopt;
        cross.corners[k] = mesh.faces[at(next(mesh, corner))];
        const std::int32_t side = next(mesh, next(mesh, corner));
        if (mesh.sides.across[at(side)] < 0 || mesh.sides.bars[at(side)] != Bar::none ||
            (!mesh.sides.diagonals.empty() && mesh.sides.diagonals[at(side)]))
            return std::nullopt;
        corner = mesh.sides.across[at(side)];
    }
    if (corner / 4 != cross.faces[0])
        return std::nullopt;
    std::array<std::int32_t, 4> ring = cross.corners;
    std::ranges::sort(ring);
    if (std::ranges::adjacent_find(ring) != ring.end())
        return std::nullopt;
    const std::array<double, 4> sine = sines(mesh.points, cross.corners);
    if (*std::ranges::min_element(sine) < flattest)
        return std::nullopt;
    const std::int32_t centre = mesh.faces[at(corner)];
    if (!mesh.sides.held.empty() && mesh.sides.held[at(centre)])
        return std::nullopt;
    for (std::size_t k = 0; k < 4; ++k)
        if (cosine(mesh.points, centre, cross.corners[(k + 1) % 4], cross.corners[(k + 2) % 4],
                   cross.corners[k]) < flat)
            return std::nullopt;
    const auto least = std::ranges::min_element(cross.faces) - cross.faces.begin();
    std::rotate(cross.faces.begin(), cross.faces.begin() + least, cross.faces.end());
    std::rotate(cross.corners.begin(), cross.corners.begin() + least, cross.corners.end());
    return cross;
}

std::vector<Cross> crosses_from(const Surroundings &mesh, const std::vector<std::int32_t> &corners,
                                std::vector<bool> &taken) {
    std::vector<Cross> result;
    std::vector<std::int32_t> queue = corners;
    for (std::size_t head = 0; head < queue.size(); ++head) {
        if (taken[at(queue[head] / 4)])
            continue;
        const std::optional<Cross> cross = cross_around(mesh, queue[head]);
        if (!cross || std::ranges::any_of(cross->faces, [&](std::int32_t f) { return taken[at(f)]; }))
            continue;
        result.push_back(*cross);
        const std::int32_t centre = mesh.faces[at(queue[head])];
        for (const std::int32_t face : cross->faces) {
            taken[at(face)] = true;
            std::int32_t corner = 4 * face;
            while (mesh.faces[at(corner)] != centre)
                ++corner;
            const std::int32_t beyond = mesh.sides.across[at(next(mesh, corner))];
            if (beyond >= 0 && mesh::is_triangle(mesh.faces, at(beyond / 4)))
                queue.push_back(next(mesh, next(mesh, beyond)));
        }
    }
    return result;
}

} // namespace alphamst::quadrangulate
