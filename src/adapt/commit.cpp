#include "adapt/commit.h"

#include <algorithm>

#include "index.h"
#include "refill/patch.h"

namespace alphamst::adapt {
void Commits::renumber(refill::Replacement &replacement, std::vector<int> &buffer) const {
    for (auto *list : {&replacement.window.faces, &buffer})
        for (int &f : *list)
            f = faces.now(f);
    patch::Window &window = replacement.window;
    for (auto *list : {&window.loop, &window.interior, &window.parents})
        for (int &v : *list)
            if (v >= 0) // not a new one, nor none
                v = vertices.now(v);
    for (auto &[v, point] : replacement.moved.vertices)
        v = vertices.now(v);
}

// The triangles under the vertices. A filling in a plane knows none.
void Commits::follow_surface(const refill::Replacement &replacement,
                             const mesh::QuadMesh::Replaced &replaced) {
    std::vector<int> &triangles = reference_.surface_triangles;
    if (triangles.empty())
        return;
    triangles.resize(std::max(triangles.size(), at(mesh_.n_vertices())));
    for (const auto &[from, to] : replaced.moved_vertices)
        triangles[at(to)] = triangles[at(from)];
    triangles.resize(at(mesh_.n_vertices()));
    for (std::size_t i = 0; i < replaced.vertices.size(); ++i)
        triangles[at(replaced.vertices[i])] =
            replacement.surface_triangles.empty()
                ? reference::spot_of(mesh_, *reference_.surface, replaced.vertices[i]).triangle
                : replacement.surface_triangles[i];
}

void Commits::follow_boundary(const refill::Replacement &replacement,
                              const mesh::QuadMesh::Replaced &replaced) {
    if (!reference_.boundary)
        return;
    reference::Boundary &boundary = *reference_.boundary;
    const std::size_t during = std::max(boundary.places.size(), at(mesh_.n_vertices()));
    boundary.places.resize(during);
    boundary.stays.resize(during);
    boundary.follow(replaced.moved_vertices, mesh_.n_vertices());
    const std::vector<surface::CurvePlace> &added = replacement.window.added_places;
    for (std::size_t i = 0; i < replaced.vertices.size(); ++i) {
        const std::size_t v = at(replaced.vertices[i]);
        boundary.places[v] = i < added.size() ? added[i] : surface::CurvePlace();
        boundary.stays[v] = i >= added.size();
    }
}

// Samples of the surface go to the new faces and to the buffer, both by their numbers before any others
// are moved.
void Commits::follow_distance(const refill::Replacement &replacement, const std::vector<int> &buffer,
                              const mesh::QuadMesh::Replaced &replaced) {
    if (!reference_.surface_distance)
        return;
    reference::SurfaceDistance &distance = *reference_.surface_distance;
    std::vector<int> owners(replaced.faces), freed(replacement.window.faces);
    owners.insert(owners.end(), buffer.begin(), buffer.end());
    if (!replacement.moved.vertices.empty())
        freed.insert(freed.end(), buffer.begin(), buffer.end());
    distance.resize(std::max(distance.faces(), mesh_.n_faces()));
    distance.assign(freed, replacement.owners, owners);
    for (const auto &[from, to] : replaced.moved_faces)
        distance.move(from, to);
    distance.resize(mesh_.n_faces());
}

mesh::QuadMesh::Replaced Commits::put(refill::Replacement &replacement, std::vector<int> buffer) {
    renumber(replacement, buffer);
    for (std::size_t k = 0; k < replacement.moved.vertices.size(); ++k) {
        const auto &[v, point] = replacement.moved.vertices[k];
        mesh_.set_point(v, point);
        if (!replacement.moved.surface_triangles.empty())
            reference_.surface_triangles[at(v)] = replacement.moved.surface_triangles[k];
    }
    const auto replaced = refill::commit(mesh_, replacement);
    follow_surface(replacement, replaced);
    follow_boundary(replacement, replaced);
    follow_distance(replacement, buffer, replaced);
    for (const int f : replacement.window.faces)
        faces.remove(f);
    for (const int v : replacement.window.interior)
        vertices.remove(v);
    for (const int f : replaced.faces)
        faces.add(f);
    for (const int v : replaced.vertices)
        vertices.add(v);
    for (const auto &[from, to] : replaced.moved_faces)
        faces.move(from, to);
    for (const auto &[from, to] : replaced.moved_vertices)
        vertices.move(from, to);
    return replaced;
}

} // namespace alphamst::adapt
