#include "transfer/cell.h"

#include <algorithm>

#include "index.h"
#include "reference/locate.h"

namespace alphamst::transfer {
namespace {

using Eigen::Vector3d;
using geometry::Quad;

// Of the corner and the two edges at it.
Quad quarter(const Quad &face, std::size_t corner) {
    const Vector3d &here = face[corner], &next = face[(corner + 1) % 4], &last = face[(corner + 3) % 4];
    return {here, (here + next) / 2, geometry::centre(face), (last + here) / 2};
}

void sort(std::vector<int> &cells) {
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

} // namespace

int Cells::count() const { return entity_ == Entity::face ? mesh_.n_faces() : mesh_.n_vertices(); }

Cells::Parts Cells::parts(int face) const {
    const Quad quad = reference::quad_of(mesh_, face);
    Parts parts;
    if (entity_ == Entity::face) {
        parts.all[parts.count++] = {face, quad};
        return parts;
    }
    for (std::size_t i = 0; i < 4; ++i)
        parts.all[parts.count++] = {mesh_.corners(face)[i], quarter(quad, i)};
    return parts;
}

std::vector<int> Cells::of(const std::vector<int> &faces) const {
    if (entity_ == Entity::face)
        return faces;
    std::vector<int> cells;
    for (const int f : faces)
        for (const int v : mesh_.corners(f))
            cells.push_back(v);
    sort(cells);
    return cells;
}

std::vector<Quad> Cells::quads(int cell) const {
    if (entity_ == Entity::face)
        return {reference::quad_of(mesh_, cell)};
    std::vector<Quad> quads;
    for (const int f : mesh_.faces_around(cell))
        for (const Part &part : parts(f))
            if (part.cell == cell)
                quads.push_back(part.quad);
    return quads;
}

double Cells::area(int cell) const {
    double sum = 0;
    for (const Quad &quad : quads(cell))
        sum += quality::measure(quality::Metric::area, quad, 0);
    return sum;
}

Cells::Place Cells::place(int cell) const {
    const std::vector<Quad> parts = quads(cell);
    Place place{geometry::area_centroid(parts.front()), geometry::area_vector(parts.front())};
    if (parts.size() == 1)
        return place;
    const Vector3d from = place.centroid;
    Vector3d moment = Vector3d::Zero();
    double area = place.normal.norm();
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const Vector3d normal = geometry::area_vector(parts[i]);
        place.normal += normal;
        area += normal.norm();
        moment += normal.norm() * (geometry::area_centroid(parts[i]) - from);
    }
    if (area > 0)
        place.centroid += moment / area;
    return place;
}

bool Cells::parted(int face, int other, std::size_t side) const {
    if (!mesh_.face_marker.empty() && mesh_.face_marker[at(face)] != mesh_.face_marker[at(other)])
        return true;
    const std::array<int, 4> corners = mesh_.corners(face);
    const std::size_t edge = at(mesh_.find_edge(corners[side], corners[(side + 1) % 4]));
    return (mesh_.edge_flags[edge] & mesh::feature) != 0 ||
           (!mesh_.edge_marker.empty() && mesh_.edge_marker[edge] != 0);
}

std::vector<int> Cells::neighbours(int cell) const {
    std::vector<int> found;
    if (entity_ == Entity::vertex) {
        for (const int f : mesh_.faces_around(cell))
            for (const int v : mesh_.corners(f))
                found.push_back(v);
    } else {
        // Two steps over edges reach all faces at a vertex of up to five.
        const auto visit = [&](int face, const auto &reached) {
            const std::array<int, 4> beside = mesh_.neighbours(face);
            for (std::size_t i = 0; i < 4; ++i)
                if (beside[i] >= 0 && !parted(face, beside[i], i))
                    reached(beside[i]);
        };
        const std::array<int, 4> corners = mesh_.corners(cell);
        const auto touches = [&](int face) {
            const std::array<int, 4> others = mesh_.corners(face);
            return std::find_first_of(others.begin(), others.end(), corners.begin(), corners.end()) !=
                   others.end();
        };
        visit(cell, [&](int near) {
            found.push_back(near);
            visit(near, [&](int next) {
                if (touches(next))
                    found.push_back(next);
            });
        });
    }
    sort(found);
    std::erase(found, cell);
    return found;
}

} // namespace alphamst::transfer
