#include "adapt/pieces.h"

#include <algorithm>

#include "adapt/patches.h"
#include "index.h"
#include "patch/region.h"

namespace alphamst::adapt {
namespace {

// With 3,000 faces a filling at once has seven times the singular vertices that windows come to.
constexpr int most_faces = 1000;

} // namespace

bool is_small(const mesh::QuadMesh &mesh) { return mesh.n_faces() <= most_faces; }

std::optional<std::size_t> refill_pieces(mesh::QuadMesh &mesh, std::int64_t wanted, const Settings &settings,
                                         const Progress &progress) {
    if (!is_small(mesh))
        return std::nullopt;
    std::vector<int> free;
    for (int f = 0; f < mesh.n_faces(); ++f)
        if ((mesh.face_flags[at(f)] & mesh::fixed) == 0)
            free.push_back(f);
    std::vector<Patch> pieces;
    std::vector<double> weights;
    for (std::vector<int> &faces : patch::parts(mesh, free, false)) {
        weights.push_back(static_cast<double>(faces.size()));
        pieces.emplace_back().faces = std::move(faces);
    }
    share(pieces, weights, wanted - mesh.n_faces() + static_cast<std::int64_t>(free.size()));
    const std::uint64_t before = mesh.checksum();
    refill_patches(mesh, pieces, settings, progress, "pieces",
                   [](const Patch &piece) { return goal_of(piece, 1); });
    if (mesh.checksum() == before)
        return std::nullopt;
    return at(std::ranges::count_if(pieces, [&](const Patch &piece) {
        return std::ranges::any_of(piece.faces, [&](int face) {
            return std::ranges::any_of(mesh.neighbours(face), [](int across) { return across < 0; });
        });
    }));
}

} // namespace alphamst::adapt
