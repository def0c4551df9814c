#include "quadrangulate/cut.h"

#include <algorithm>
#include <array>

#include "index.h"
#include "quadrangulate/pairing.h"
#include "random.h"

namespace alphamst::quadrangulate {
std::vector<std::int8_t> parallel_diagonals(mesh::Faces faces, const std::vector<std::int32_t> &across) {
    std::vector<std::int8_t> diagonal(faces.size() / 4, -1);
    std::vector<std::int32_t> queue;
    for (std::size_t first = 0; first < diagonal.size(); ++first) {
        if (diagonal[first] >= 0 || mesh::is_triangle(faces, first))
            continue;
        diagonal[first] = 0;
        queue.assign(1, static_cast<std::int32_t>(first));
        for (std::size_t head = 0; head < queue.size(); ++head)
            for (std::int32_t k = 0; k < 4; ++k) {
                const std::int32_t face = queue[head], beyond = across[at(4 * face + k)];
                if (beyond < 0 || diagonal[at(beyond / 4)] >= 0 || mesh::is_triangle(faces, at(beyond / 4)))
                    continue;
                // The one ends where the common side begins, the other where it ends.
                const bool begins = k % 2 == diagonal[at(face)];
                diagonal[at(beyond / 4)] = static_cast<std::int8_t>((beyond + (begins ? 0 : 1)) % 2);
                queue.push_back(beyond / 4);
            }
    }
    return diagonal;
}

void draw_diagonals(mesh::Faces faces, const std::vector<std::int32_t> &across,
                    const std::vector<std::int32_t> &near, int layers, std::uint64_t seed,
                    std::vector<std::int8_t> &diagonals) {
    std::vector<bool> seen(diagonals.size());
    std::vector<std::int32_t> queue;
    const auto add = [&](std::int32_t face) {
        if (!seen[at(face)]) {
            seen[at(face)] = true;
            queue.push_back(face);
        }
    };
    for (const std::int32_t face : near)
        add(face);
    std::size_t head = 0;
    for (int layer = 0; layer < layers; ++layer)
        for (const std::size_t end = queue.size(); head < end; ++head)
            for (std::size_t c = 4 * at(queue[head]); c < 4 * at(queue[head]) + 4; ++c)
                if (across[c] >= 0)
                    add(across[c] / 4);
    Random random(seed);
    for (const std::int32_t face : queue)
        if (!mesh::is_triangle(faces, at(face)))
            diagonals[at(face)] = static_cast<std::int8_t>(random() % 2);
}

Cut cut_quads(mesh::Coordinates points, mesh::Faces faces, const std::vector<std::int8_t> &diagonals) {
    Cut cut;
    const auto add = [&](std::size_t face, std::array<std::int32_t, 3> corners, bool diagonal) {
        cut.faces.insert(cut.faces.end(), {corners[0], corners[1], corners[2], -1});
        cut.origin.push_back(static_cast<std::int32_t>(face));
        cut.diagonals.insert(cut.diagonals.end(), {false, false, diagonal, false});
    };
    for (std::size_t f = 0; f < diagonals.size(); ++f) {
        if (diagonals[f] < 0) {
            add(f, {faces[4 * f], faces[4 * f + 1], faces[4 * f + 2]}, false);
            continue;
        }
        const auto corner = [&](std::size_t k) { return faces[4 * f + k % 4]; };
        const std::array<double, 4> sine = sines(points, {corner(0), corner(1), corner(2), corner(3)});
        const auto worst = static_cast<std::size_t>(std::ranges::min_element(sine) - sine.begin());
        // From a corner of more than 180 degrees only one diagonal is inside.
        const std::size_t first = sine[worst] < 0 ? worst : at(diagonals[f]);
        add(f, {corner(first), corner(first + 1), corner(first + 2)}, true);
        add(f, {corner(first + 2), corner(first + 3), corner(first)}, true);
    }
    return cut;
}

} // namespace alphamst::quadrangulate
