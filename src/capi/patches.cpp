// A set of patches: how its patches are chosen and set.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/ids.h"
#include "capi/under_way.h"
#include "patch/patches.h"
#include "patch/window.h"

namespace alphamst::capi {
namespace {

using Faces = std::vector<int>;

// The set, if it may be changed now.
Patches &changeable(amst_patches *handle) {
    Patches &patches = *required(handle, "patches").impl;
    patches.mesh->context->require_idle();
    patches.require_current();
    return patches;
}

std::vector<char> taken(const Patches &patches) {
    const mesh::QuadMesh &mesh = *patches.mesh->current;
    std::vector<char> result(static_cast<std::size_t>(mesh.n_faces()));
    const std::size_t flagged = std::min(result.size(), mesh.face_flags.size());
    for (std::size_t f = 0; f < flagged; ++f)
        result[f] = (mesh.face_flags[f] & mesh::fixed) != 0;
    for (const Patch &region : patches.regions)
        for (const int face : region.faces)
            result[static_cast<std::size_t>(face)] = 1;
    return result;
}

[[noreturn]] void refuse_taken(const Patches &patches, int face) {
    for (std::size_t p = 0; p < patches.regions.size(); ++p) {
        const Faces &faces = patches.regions[p].faces;
        if (std::binary_search(faces.begin(), faces.end(), face)) {
            const auto patch = static_cast<std::int64_t>(p);
            Failure failure(Fault::patch, "face {} is in patch {} already", Entity::face, {face, patch});
            failure.patch = patch;
            throw failure;
        }
    }
    throw Failure(Fault::patch, "face {} is FIXED and can be in no patch", Entity::face, {face});
}

// Appends the patch that these faces, none of them taken, make.
void add(Patches &patches, Faces faces, const std::vector<char> &taken, amst_id *patch) {
    if (!faces.empty() && patches.options.repair_patches)
        faces = patch::repair_but_rings(*patches.mesh->current, std::move(faces), taken);
    if (faces.empty())
        throw Failure(Fault::patch, "the patch would be empty: no face that is free was found, or none that "
                                    "makes a disk with others");
    patches.regions.push_back({std::move(faces), {}, 0});
    if (patch != nullptr)
        *patch = out(patches.mesh->context->index_base, static_cast<int>(patches.regions.size()) - 1);
}

// By the numbers of enum amst_decomposition.
constexpr std::array decompositions = {patch::clusters, patch::partition, patch::voronoi_cells,
                                       patch::medial_discs, patch::singularity_clusters};

std::array<double, 3> place(const double *components, const char *name) {
    required(components, name);
    for (int c = 0; c < 3; ++c)
        if (!std::isfinite(components[c]))
            throw Failure(Fault::not_finite,
                          std::string(name) + " has a component that is not a finite number");
    return {components[0], components[1], components[2]};
}

} // namespace

void Patches::require_current() const {
    if (revision != mesh->revision)
        throw Failure(Fault::stale, "the patches are of revision " + std::to_string(revision) +
                                        ", the mesh has revision " + std::to_string(mesh->revision));
}

} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_patches_create(const amst_mesh *mesh, const amst_options *options, amst_patches **out) {
    return guarded(index_base(mesh), [&] {
        const std::shared_ptr<Mesh> &parent = required(mesh, "mesh").impl;
        amst_patches *&created = required(out, "out");
        auto patches = std::make_shared<Patches>();
        patches->mesh = parent;
        patches->revision = parent->revision;
        patches->options = options_of(options);
        created = new amst_patches{std::move(patches)};
    });
}

void amst_patches_destroy(amst_patches *patches) { delete patches; }

amst_status amst_patches_add_faces(amst_patches *patches, const amst_id *faces, std::int64_t n,
                                   amst_id *patch) {
    return guarded(index_base(patches), [&] {
        Patches &set = changeable(patches);
        require_array(faces, n, "faces", "n");
        const std::vector<char> others = taken(set);
        const int base = index_base(patches);
        Faces chosen;
        for (std::int64_t i = 0; i < n; ++i) {
            const int face = in(base, faces[i], std::int64_t{set.mesh->current->n_faces()}, Entity::face);
            if (others[static_cast<std::size_t>(face)] == 0)
                chosen.push_back(face);
            else if (!set.options.repair_patches)
                refuse_taken(set, face);
        }
        std::sort(chosen.begin(), chosen.end());
        chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
        add(set, std::move(chosen), others, patch);
    });
}

amst_status amst_patches_add_rings(amst_patches *patches, amst_id vertex, std::int32_t rings,
                                   amst_id *patch) {
    return guarded(index_base(patches), [&] {
        Patches &set = changeable(patches);
        const mesh::QuadMesh &mesh = *set.mesh->current;
        const int center = in(index_base(patches), vertex, mesh.n_vertices(), Entity::vertex);
        if (rings < 1)
            throw Failure(Fault::range, "rings must be at least 1, it is " + std::to_string(rings));
        const std::vector<char> others = taken(set);
        add(set, patch::rings(mesh, center, rings, others), others, patch);
    });
}

amst_status amst_patches_add_ball(amst_patches *patches, const double center[3], double radius,
                                  amst_id *patch) {
    return guarded(index_base(patches), [&] {
        Patches &set = changeable(patches);
        const std::array<double, 3> middle = place(center, "center");
        require_real(radius, 0, false, "radius");
        const std::vector<char> others = taken(set);
        add(set, patch::ball(*set.mesh->current, middle, radius, others), others, patch);
    });
}

amst_status amst_patches_add_box(amst_patches *patches, const double low[3], const double high[3],
                                 amst_id *patch) {
    return guarded(index_base(patches), [&] {
        Patches &set = changeable(patches);
        const std::array<double, 3> from = place(low, "low"), to = place(high, "high");
        for (std::size_t c = 0; c < 3; ++c)
            if (from[c] > to[c])
                throw Failure(Fault::argument, "low is above high in component " + std::to_string(c));
        const std::vector<char> others = taken(set);
        add(set, patch::box(*set.mesh->current, from, to, others), others, patch);
    });
}

amst_status amst_patches_decompose(amst_patches *patches, std::int32_t method, std::int64_t *added) {
    return guarded(index_base(patches), [&] {
        Patches &set = changeable(patches);
        if (method < 0 || method >= static_cast<std::int32_t>(decompositions.size()))
            throw Failure(Fault::argument, "there is no decomposition method " + std::to_string(method));
        const UnderWay under_way(set.mesh->context);
        const Pace pace(under_way.progress(), "decompose");
        pace.reach(0);
        const std::vector<char> others = taken(set);
        const auto decompose = decompositions[static_cast<std::size_t>(method)];
        std::vector<Faces> parts =
            decompose(*set.mesh->current, set.options.patch_faces, set.options.seed, others, pace);
        pace.reach(1);
        std::erase_if(parts, [](const Faces &part) { return part.empty(); });
        set.regions.reserve(set.regions.size() + parts.size());
        for (Faces &part : parts)
            set.regions.push_back({std::move(part), {}, 0});
        if (added != nullptr)
            *added = static_cast<std::int64_t>(parts.size());
    });
}

amst_status amst_patches_set_corners(amst_patches *patches, amst_id patch, const amst_id *vertices,
                                     std::int64_t n) {
    return guarded(index_base(patches), [&] {
        Patches &set = changeable(patches);
        const int base = index_base(patches);
        const int p = in(base, patch, static_cast<std::int64_t>(set.regions.size()), Entity::none);
        require_array(vertices, n, "vertices", "n");
        if (n != 0 && (n < 3 || n > 6))
            throw Failure(Fault::range,
                          "a patch has 3 to 6 corners, or 0 for those the library chooses; n is " +
                              std::to_string(n));
        std::vector<int> corners;
        for (std::int64_t i = 0; i < n; ++i)
            corners.push_back(in(base, vertices[i], set.mesh->current->n_vertices(), Entity::vertex));
        set.regions[static_cast<std::size_t>(p)].corners = std::move(corners);
    });
}

amst_status amst_patches_set_alpha(amst_patches *patches, amst_id patch, double alpha) {
    return guarded(index_base(patches), [&] {
        Patches &set = changeable(patches);
        require_real(alpha, 0, false, "alpha");
        if (patch == AMST_ALL) {
            for (Patch &region : set.regions)
                region.alpha = alpha;
            return;
        }
        const int p =
            in(index_base(patches), patch, static_cast<std::int64_t>(set.regions.size()), Entity::none);
        set.regions[static_cast<std::size_t>(p)].alpha = alpha;
    });
}
