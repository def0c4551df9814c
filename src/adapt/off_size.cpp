#include "adapt/off_size.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "adapt/adapt.h"
#include "geometry/quad.h"
#include "index.h"
#include "mesh/submesh.h"
#include "patch/grow.h"
#include "reference/locate.h"
#include "reference/reference.h"
#include "reference/statistics.h"

namespace alphamst::adapt {
namespace {

// Layers of faces around those that are off. Each saves singular vertices that stay behind where a front has
// passed: more than the least number come as long as no more than twice the faces give way for which another
// size is wanted than before, by so much of log2 of the area.
constexpr int least_layers = 4, most_layers = 8;
constexpr double most_for_changed = 2, least_change = 0.1;
// Of the band: the change of what is wanted that makes it worth trying again.
constexpr double worth_trying = 0.5;
constexpr double no_limit = std::numeric_limits<double>::infinity();

// The length of edges that is wanted at a face, alpha times as dense.
class Wanted {
public:
    Wanted(const mesh::QuadMesh &mesh, double alpha)
        : mesh_(mesh), sizes_(*mesh.field(Entity::vertex, "size")), factor_(1 / std::sqrt(alpha)) {}

    double at_vertex(int vertex) const { return factor_ * sizes_[at(vertex)]; }
    double length(int face) const {
        double sum = 0;
        for (const int v : mesh_.corners(face))
            sum += at_vertex(v);
        return sum / 4;
    }
    double faces(int face) const { // how many there should be in its place
        const double edge = length(face);
        return geometry::area_vector(reference::quad_of(mesh_, face)).norm() / (edge * edge);
    }

private:
    const mesh::QuadMesh &mesh_;
    const std::vector<double> &sizes_;
    double factor_;
};

// And all faces that share a vertex with one of them; ascending.
std::vector<int> with_layer(patch::Growth &growth, const std::vector<int> &faces) {
    std::vector<int> all = growth.surround(faces, 1);
    std::ranges::sort(all);
    return all;
}

// A vertex at which they meet without sharing edges would be none of a mesh of their own: all around it come.
void fill_pinches(const mesh::QuadMesh &mesh, std::vector<int> &faces) {
    const auto has = [&](int f) { return f >= 0 && std::ranges::binary_search(faces, f); };
    for (bool found = true; found;) {
        found = false;
        std::vector<int> more = faces;
        for (const int f : faces)
            for (const int v : mesh.corners(f)) {
                const std::vector<int> around = mesh.faces_around(v);
                const bool closed = !mesh.on_boundary(v);
                int fans = closed && has(around.back()) && has(around.front()) ? -1 : 0;
                for (std::size_t i = 0; i < around.size(); ++i)
                    fans += has(around[i]) && (i == 0 || !has(around[i - 1]));
                if (fans > 1) {
                    more.insert(more.end(), around.begin(), around.end());
                    found = true;
                }
            }
        std::ranges::sort(more);
        more.erase(std::unique(more.begin(), more.end()), more.end());
        faces = std::move(more);
    }
}

// Remembers what these faces are adapted to, and all places that are seen for the first time.
void remember(mesh::QuadMesh &mesh, const std::vector<int> &faces, const Wanted &wanted) {
    auto field = std::make_shared<mesh::Field>();
    if (const mesh::Field *before = mesh.fields.find(Entity::vertex, adapted_size))
        *field = *before;
    else
        *field = {Entity::vertex, adapted_size, 1, mesh::Carry::linear,
                  std::vector<double>(at(mesh.n_vertices()), 0)};
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (!(field->values[at(v)] > 0))
            field->values[at(v)] = wanted.at_vertex(v);
    for (const int f : faces)
        for (const int v : mesh.corners(f))
            field->values[at(v)] = wanted.at_vertex(v);
    mesh.fields.set(std::move(field));
}

// For which length of edges a face was adapted; 0: nobody knows.
double adapted_to(const mesh::QuadMesh &mesh, const std::vector<double> *adapted, int face) {
    double sum = 0;
    for (const int v : mesh.corners(face)) {
        if (adapted == nullptr || !((*adapted)[at(v)] > 0))
            return 0;
        sum += (*adapted)[at(v)];
    }
    return sum / 4;
}

// Of the whole mesh, by what it says of the faces that may change: the others are looked at once.
void tell(const Outcome &of_part, Outcome &outcome) {
    outcome.faces_after += of_part.faces_after - of_part.faces_before;
    outcome.faces_wanted += of_part.faces_wanted - of_part.faces_before;
    outcome.singular_after += of_part.singular_after - of_part.singular_before;
    for (const auto &[valence, count] : of_part.valences_before)
        outcome.valences_after[valence] -= count;
    for (const auto &[valence, count] : of_part.valences_after)
        outcome.valences_after[valence] += count;
    std::erase_if(outcome.valences_after, [](const auto &entry) { return entry.second == 0; });
    outcome.quality_before = std::min(outcome.quality_before, of_part.quality_before);
    outcome.quality_after = std::min(outcome.quality_after, of_part.quality_after);
    outcome.aspect_ratio_before = std::max(outcome.aspect_ratio_before, of_part.aspect_ratio_before);
    outcome.aspect_ratio_after = std::max(outcome.aspect_ratio_after, of_part.aspect_ratio_after);
    outcome.size_error_before = of_part.size_error_before;
    outcome.size_error_after = of_part.size_error_after;
    outcome.least_area_before = of_part.least_area_before;
    outcome.least_area_after = of_part.least_area_after;
    outcome.shortest_edge_before = of_part.shortest_edge_before;
    outcome.shortest_edge_after = of_part.shortest_edge_after;
    outcome.fault = of_part.fault;
    outcome.text = of_part.text;
}

// What there is, but of quality only that of faces that are not in the list.
Outcome present(const mesh::QuadMesh &mesh, const std::vector<int> &but) {
    std::vector<int> others;
    for (int f = 0; f < mesh.n_faces(); ++f)
        if (!std::ranges::binary_search(but, f))
            others.push_back(f);
    Outcome outcome;
    outcome.faces_before = outcome.faces_after = outcome.faces_wanted = mesh.n_faces();
    reference::count(mesh, outcome.valences_before, outcome.singular_before);
    outcome.valences_after = outcome.valences_before;
    outcome.singular_after = outcome.singular_before;
    outcome.quality_before = others.empty() ? 1 : reference::least_quality(mesh, others);
    outcome.aspect_ratio_before = others.empty() ? 1 : reference::largest_aspect_ratio(mesh, others);
    outcome.quality_after = outcome.quality_before;
    outcome.aspect_ratio_after = outcome.aspect_ratio_before;
    return outcome;
}

} // namespace

bool goes_by_band(const mesh::QuadMesh &mesh, const Settings &settings) {
    return settings.size_band > 0 && mesh.field(Entity::vertex, "size") != nullptr &&
           (mesh.dim() == 2 || reference::plane_of(mesh));
}

std::vector<int> faces_off_size(const mesh::QuadMesh &mesh, double alpha, const Settings &settings) {
    const Wanted wanted(mesh, alpha);
    const std::vector<double> *adapted = mesh.field(Entity::vertex, adapted_size);
    std::vector<int> faces;
    int changed = 0;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const double then = adapted_to(mesh, adapted, f);
        const double change = then > 0 ? std::abs(2 * std::log2(wanted.length(f) / then)) : no_limit;
        changed += then > 0 && change > least_change;
        if (change > worth_trying * settings.size_band &&
            std::abs(std::log2(wanted.faces(f))) > settings.size_band)
            faces.push_back(f);
    }
    patch::Growth growth(mesh);
    for (int k = 0; k < most_layers && !faces.empty(); ++k) {
        std::vector<int> more = with_layer(growth, faces);
        if (k >= least_layers && static_cast<double>(more.size()) > most_for_changed * changed)
            break;
        faces = std::move(more);
    }
    return faces;
}

Outcome adapt_off_size(mesh::QuadMesh &mesh, double alpha, const Settings &settings,
                       const Progress &progress) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<int> changing = faces_off_size(mesh, alpha, settings);
    if (changing.empty())
        return present(mesh, changing);
    const Wanted wanted(mesh, alpha);
    remember(mesh, changing, wanted);
    // One layer more, which stays: so the vertices at the rim have the valences of the whole.
    patch::Growth growth(mesh);
    std::vector<int> faces = with_layer(growth, changing);
    fill_pinches(mesh, faces);
    Outcome outcome = present(mesh, faces);
    mesh::Submesh part = mesh::submesh_of(mesh, faces);
    double sum = 0;
    for (std::size_t i = 0; i < faces.size(); ++i)
        if ((part.mesh.face_flags[i] & mesh::fixed) != 0) {
            sum += 1;
        } else if (std::ranges::binary_search(changing, faces[i])) {
            sum += wanted.faces(faces[i]);
        } else {
            part.mesh.face_flags[i] |= mesh::fixed | mesh::held;
            sum += 1;
        }
    Settings all_of_it = settings;
    all_of_it.size_band = 0;
    const Outcome of_part =
        adapt_whole(part.mesh, sum / static_cast<double>(faces.size()), all_of_it, progress);
    mesh::put_back(mesh, part);
    tell(of_part, outcome);
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

} // namespace alphamst::adapt
