#include "patch/decompose.h"

#include <algorithm>
#include <cmath>

#include "patch/region.h"

namespace alphamst::patch {
namespace {

std::size_t n_groups(const FaceDual &dual, double size) {
    const double wanted = std::round(static_cast<double>(dual.size()) / std::max(size, 1.0));
    return static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(dual.size())));
}

// Of the time of a decomposition, about.
constexpr double duals_part = 0.1, divide_part = 0.6;

} // namespace

FaceDual::FaceDual(const mesh::QuadMesh &mesh, std::vector<int> part, const Pace &pace)
    : faces(std::move(part)), start{0} {
    centroids.reserve(faces.size());
    for (const int face : faces) {
        pace.step();
        for (const Halfedge h : halfedges_of(mesh, face)) {
            const int next = right(mesh, h);
            const auto it = std::lower_bound(faces.begin(), faces.end(), next);
            if (it != faces.end() && *it == next && !barrier(mesh, h))
                links.push_back(static_cast<std::int32_t>(it - faces.begin()));
        }
        start.push_back(static_cast<std::int32_t>(links.size()));
        centroids.push_back(centroid(mesh, face));
    }
}

std::vector<FaceDual> duals(const mesh::QuadMesh &mesh, Taken taken, const Pace &pace) {
    std::vector<int> free;
    for (int face = 0; face < mesh.n_faces(); ++face)
        if (taken.empty() || !taken[static_cast<std::size_t>(face)])
            free.push_back(face);
    std::vector<FaceDual> result;
    for (auto &part : parts(mesh, free, false))
        result.emplace_back(mesh, std::move(part), pace);
    return result;
}

Groups disks(const mesh::QuadMesh &mesh, const Groups &groups, Taken taken, const Pace &pace) {
    std::vector<char> used(static_cast<std::size_t>(mesh.n_faces()), 0);
    std::copy(taken.begin(), taken.end(), used.begin());
    const auto mark = [&](const std::vector<int> &faces, char value) {
        for (const int face : faces)
            used[static_cast<std::size_t>(face)] = value;
    };
    for (const auto &group : groups)
        mark(group, 1);
    Groups result;
    for (const auto &group : groups) {
        mark(group, 0);
        pace.reach(static_cast<double>(result.size()) / static_cast<double>(groups.size()));
        std::vector<int> disk = repair(mesh, group, used);
        mark(disk, 1);
        if (!disk.empty())
            result.push_back(std::move(disk));
    }
    return result;
}

Groups decompose(const mesh::QuadMesh &mesh, double size, Taken taken, const Divide &divide,
                 const Pace &pace) {
    Groups groups;
    double done = 0;
    for (const FaceDual &dual : duals(mesh, taken, pace.part(0, duals_part))) {
        const double part =
            divide_part * static_cast<double>(dual.size()) / static_cast<double>(mesh.n_faces());
        const std::size_t n = n_groups(dual, size), first = groups.size();
        const std::vector<std::size_t> group =
            divide(dual, n, pace.part(duals_part + done, duals_part + done + part));
        done += part;
        groups.resize(first + n);
        for (std::size_t i = 0; i < dual.size(); ++i)
            groups[first + group[i]].push_back(dual.faces[i]);
    }
    return disks(mesh, groups, taken, pace.part(duals_part + divide_part, 1));
}

} // namespace alphamst::patch
