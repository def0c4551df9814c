#include "mesh/components.h"

#include "disjoint_sets.h"
#include "index.h"

namespace alphamst::mesh {

std::vector<std::int32_t> neighbours(Faces faces, const EdgeSides &sides) {
    std::vector<std::int32_t> across(faces.size(), -1);
    visit_edges(sides, [&](std::span<const Side> edge) {
        if (edge.size() != 2)
            return;
        across[at(edge[0].corner)] = edge[1].corner;
        across[at(edge[1].corner)] = edge[0].corner;
    });
    return across;
}

Components find_components(Faces faces, const std::vector<std::int32_t> &across) {
    const std::size_t n_faces = faces.size() / 4;
    Components components{std::vector<std::int32_t>(n_faces, -1), std::vector<bool>(n_faces), {}};
    std::vector<std::size_t> queue;
    for (std::size_t first = 0; first < n_faces; ++first) {
        if (components.of_face[first] >= 0 || faces[4 * first] < 0)
            continue;
        const auto name = static_cast<std::int32_t>(components.one_sided.size());
        components.one_sided.push_back(-1);
        components.of_face[first] = name;
        queue.assign(1, first);
        for (std::size_t head = 0; head < queue.size(); ++head)
            for (std::size_t c = 4 * queue[head]; c < 4 * queue[head] + 4; ++c) {
                if (across[c] < 0)
                    continue;
                const std::size_t face = queue[head], other = at(across[c]) / 4;
                // Two that run alike start their common side at different vertices.
                const bool against = components.against[face] != (faces[c] == faces[at(across[c])]);
                if (components.of_face[other] < 0) {
                    components.of_face[other] = name;
                    components.against[other] = against;
                    queue.push_back(other);
                } else if (components.against[other] != against && components.one_sided[at(name)] < 0) {
                    components.one_sided[at(name)] = static_cast<std::int32_t>(c);
                }
            }
    }
    return components;
}

// Corners of one vertex are together where an edge joins them.
std::vector<bool> find_pinched(Faces faces, const EdgeSides &sides, std::size_t n_vertices) {
    DisjointSets fans(faces.size());
    visit_edges(sides, [&](std::span<const Side> edge) {
        const auto ends = [&](const Side &side) {
            const std::size_t c = at(side.corner), d = next_corner(faces, c);
            return runs_down(faces, side) ? std::pair(d, c) : std::pair(c, d);
        };
        for (const Side &side : edge) {
            fans.unite(ends(edge[0]).first, ends(side).first);
            fans.unite(ends(edge[0]).second, ends(side).second);
        }
    });
    std::vector<std::int64_t> fan(n_vertices, -1);
    std::vector<bool> several(n_vertices);
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (faces[c] >= 0) {
            const auto own = static_cast<std::int64_t>(fans.find(c));
            std::int64_t &first = fan[at(faces[c])];
            several[at(faces[c])] = several[at(faces[c])] || (first >= 0 && first != own);
            first = own;
        }
    return several;
}

int count_lone_faces(const QuadMesh &mesh) {
    int n = 0;
    for (int f = 0; f < mesh.n_faces(); ++f)
        n += mesh.neighbours(f) == std::array{-1, -1, -1, -1} ? 1 : 0;
    return n;
}

} // namespace alphamst::mesh
