#include "adapt/layers.h"

#include <algorithm>
#include <span>
#include <vector>

#include "index.h"
#include "patch/region.h"
#include "reference/statistics.h"

namespace alphamst::adapt {
namespace {

// Verdict's aspect ratio, of a face eight times longer than high. No mesh that was not made for a boundary
// layer has many such faces.
constexpr double stretched = 4.5;
// Smallest scaled Jacobian: what is worse is a sliver.
constexpr double straight = 0.5;
// Of the faces: where fewer are wanted, layers that stay leave too little for the others, whose corners
// close.
constexpr double coarser = 0.75;

// 0 for a face that is no rectangle.
double stretch(const mesh::QuadMesh &mesh, int face) {
    const std::span one(&face, 1);
    return reference::least_quality(mesh, one) >= straight ? reference::largest_aspect_ratio(mesh, one) : 0;
}

std::vector<double> stretches_of(const mesh::QuadMesh &mesh) {
    std::vector<double> stretches;
    for (int f = 0; f < mesh.n_faces(); ++f)
        stretches.push_back(stretch(mesh, f));
    return stretches;
}

// A layer goes on: two faces beside it are stretched, too.
bool goes_on(const mesh::QuadMesh &mesh, int face, const std::vector<double> &stretches) {
    int beside = 0;
    for (const patch::Halfedge h : patch::halfedges_of(mesh, face))
        if (const int next = patch::right(mesh, h); next >= 0)
            beside += stretches[at(next)] >= stretched;
    return beside >= 2;
}

} // namespace

std::vector<int> layers_of(const mesh::QuadMesh &mesh) {
    const std::vector<double> stretches = stretches_of(mesh);
    std::vector<int> faces;
    for (int f = 0; f < mesh.n_faces(); ++f)
        if (stretches[at(f)] >= stretched && (mesh.face_flags[at(f)] & mesh::fixed) == 0 &&
            goes_on(mesh, f, stretches))
            faces.push_back(f);
    return faces;
}

std::int64_t hold_layers(mesh::QuadMesh &mesh, std::int64_t wanted) {
    if (static_cast<double>(wanted) < coarser * mesh.n_faces())
        return 0;
    const std::vector<double> stretches = stretches_of(mesh);
    std::vector<int> faces = layers_of(mesh);
    std::stable_sort(faces.begin(), faces.end(),
                     [&](int a, int b) { return stretches[at(a)] > stretches[at(b)]; });
    faces.resize(std::min(faces.size(), at(mesh.n_faces() / 2)));
    for (const int f : faces)
        mesh.face_flags[at(f)] |= mesh::fixed | mesh::held;
    return static_cast<std::int64_t>(faces.size());
}

void release_layers(mesh::QuadMesh &mesh) {
    for (std::uint8_t &flags : mesh.face_flags)
        if ((flags & mesh::held) != 0)
            flags &= static_cast<std::uint8_t>(~(mesh::fixed | mesh::held));
}

} // namespace alphamst::adapt
