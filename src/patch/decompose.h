// What the ways to decompose a mesh have in common: the dual graph of the free faces, and
// the disks that groups of faces become.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/quad_mesh.h"
#include "patch/patches.h"

namespace alphamst::patch {

// The dual graph of an edge-connected set of faces: a node is a face, by its place in
// `faces`, a link an edge that is no barrier.
struct FaceDual {
    FaceDual(const mesh::QuadMesh &mesh, std::vector<int> part, const Pace &pace = {});

    std::size_t size() const { return faces.size(); }
    std::span<const std::int32_t> neighbours(std::size_t node) const {
        const auto first = static_cast<std::size_t>(start[node]),
                   last = static_cast<std::size_t>(start[node + 1]);
        return std::span(links).subspan(first, last - first);
    }
    double length(std::size_t node, std::size_t next) const {
        return (centroids[next] - centroids[node]).norm();
    }

    std::vector<int> faces; // ascending
    std::vector<OpenMesh::Vec3d> centroids;
    std::vector<std::int32_t> start, links; // those of node i: links[start[i]] .. links[start[i + 1] - 1]
};

// One for every part of the faces that are not taken.
std::vector<FaceDual> duals(const mesh::QuadMesh &mesh, Taken taken, const Pace &pace = {});

using Groups = std::vector<std::vector<int>>;

// A disk of each group. Faces of other groups are taken; those that were dropped are not.
Groups disks(const mesh::QuadMesh &mesh, const Groups &groups, Taken taken, const Pace &pace = {});

// Disks of all free faces: `divide` tells the group, 0 .. n - 1, of every node of a dual graph.
using Divide = std::function<std::vector<std::size_t>(const FaceDual &dual, std::size_t n, const Pace &pace)>;
Groups decompose(const mesh::QuadMesh &mesh, double size, Taken taken, const Divide &divide,
                 const Pace &pace);

// Lloyd (1982) on the graph, from random nodes: a group for every node.
std::vector<std::size_t> lloyd(const FaceDual &dual, std::size_t n, std::uint64_t seed,
                               const Pace &pace = {});

} // namespace alphamst::patch
