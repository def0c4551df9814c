#include "smooth/areas.h"

#include <algorithm>

#include "index.h"
#include "reference/locate.h"

namespace alphamst::smooth {
namespace {

double area_of(const mesh::QuadMesh &mesh, int face) {
    return geometry::area_vector(reference::quad_of(mesh, face)).norm();
}

} // namespace

std::vector<double> local_areas(const mesh::QuadMesh &mesh) {
    constexpr int layers = 4;
    std::vector<double> area;
    for (int f = 0; f < mesh.n_faces(); ++f)
        area.push_back(area_of(mesh, f));
    std::vector<double> sum(at(mesh.n_vertices())), count(sum.size(), 0);
    for (const auto &q : mesh.faces())
        for (const int v : q)
            ++count[at(v)];
    for (int layer = 0; layer < layers; ++layer) {
        std::fill(sum.begin(), sum.end(), 0);
        for (std::size_t f = 0; f < area.size(); ++f)
            for (const int v : mesh.faces()[f])
                sum[at(v)] += area[f];
        for (std::size_t f = 0; f < area.size(); ++f) {
            area[f] = 0;
            for (const int v : mesh.faces()[f])
                area[f] += sum[at(v)] / count[at(v)] / 4;
        }
    }
    return area;
}

std::vector<double> wished_areas(const mesh::QuadMesh &mesh, const std::vector<double> &sizes) {
    std::vector<double> wished(at(mesh.n_faces()), 0);
    for (std::size_t f = 0; f < wished.size(); ++f)
        for (const int v : mesh.faces()[f])
            wished[f] += sizes[at(v)] * sizes[at(v)] / 4;
    return wished;
}

std::vector<double> wanted_areas(const mesh::QuadMesh &mesh, const reference::SizingField &density) {
    std::vector<double> wanted;
    double sum = 0, area = 0;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        wanted.push_back(1 / density.of_face(mesh, f));
        sum += wanted.back();
        area += area_of(mesh, f);
    }
    for (double &a : wanted)
        a *= area / sum;
    return wanted;
}

} // namespace alphamst::smooth
