#include "mesh/submesh.h"

#include <algorithm>
#include <unordered_map>

#include "index.h"

namespace alphamst::mesh {
namespace {

// Ids of one kind of entity in the part, and in the whole, where those that are not in the part have none.
class Twins {
public:
    explicit Twins(std::vector<int> whole) : whole_(std::move(whole)) {
        for (std::size_t i = 0; i < whole_.size(); ++i)
            part_[whole_[i]] = static_cast<int>(i);
    }

    int of(int id) const { return whole_[at(id)]; }
    std::vector<int> of(std::span<const int> ids) const {
        std::vector<int> all;
        for (const int id : ids)
            all.push_back(id < 0 ? id : of(id)); // negative: a new vertex on the boundary
        return all;
    }

    // After the same was replaced in both: who was moved into gaps, and who came.
    void follow(std::span<const std::array<int, 2>> moved_in_whole, std::span<const int> came_to_whole,
                std::span<const std::array<int, 2>> moved, std::span<const int> came, int count) {
        for (const auto &[from, to] : moved_in_whole)
            if (const auto twin = part_.find(from); twin != part_.end()) {
                const int id = twin->second;
                part_.erase(twin);
                pair(id, to);
            } else {
                part_.erase(to);
            }
        whole_.resize(std::max(whole_.size(), at(count)));
        for (const int id : came)
            whole_.resize(std::max(whole_.size(), at(id) + 1));
        for (const auto &[from, to] : moved)
            pair(to, whole_[at(from)]);
        for (std::size_t i = 0; i < came.size(); ++i)
            pair(came[i], came_to_whole[i]);
        whole_.resize(at(count));
    }

private:
    void pair(int id, int in_whole) {
        whole_[at(id)] = in_whole;
        part_[in_whole] = id;
    }

    std::vector<int> whole_;            // [of the part]
    std::unordered_map<int, int> part_; // of the whole
};

} // namespace

Submesh submesh_of(const QuadMesh &whole, std::span<const int> faces) {
    Submesh part;
    part.faces.assign(faces.begin(), faces.end());
    for (const int f : faces)
        for (const int v : whole.corners(f))
            part.vertices.push_back(v);
    std::ranges::sort(part.vertices);
    part.vertices.erase(std::unique(part.vertices.begin(), part.vertices.end()), part.vertices.end());
    std::vector<double> points;
    for (const int v : part.vertices)
        for (std::size_t k = 0; k < 3; ++k)
            points.push_back(whole.point(v)[k]);
    std::vector<std::int32_t> corners;
    for (const int f : faces)
        for (const int v : whole.corners(f))
            corners.push_back(static_cast<std::int32_t>(std::ranges::lower_bound(part.vertices, v) -
                                                        part.vertices.begin()));
    QuadMesh &mesh = part.mesh = QuadMesh::build(whole.dim(), points, corners);

    const auto take = [](auto &own, const auto &all, std::span<const int> ids) {
        if (!all.empty()) {
            own.resize(ids.size());
            for (std::size_t i = 0; i < ids.size(); ++i)
                own[i] = all[at(ids[i])];
        }
    };
    std::vector<int> edges;
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [v, w] = mesh.edge_vertices(e);
        edges.push_back(whole.find_edge(part.vertices[at(v)], part.vertices[at(w)]));
    }
    take(mesh.vertex_flags, whole.vertex_flags, part.vertices);
    take(mesh.edge_flags, whole.edge_flags, edges);
    take(mesh.face_flags, whole.face_flags, part.faces);
    take(mesh.vertex_marker, whole.vertex_marker, part.vertices);
    take(mesh.edge_marker, whole.edge_marker, edges);
    take(mesh.face_marker, whole.face_marker, part.faces);
    mesh.curve_numbers = whole.curve_numbers;
    mesh.surface = whole.surface;
    mesh.curves = whole.curves;
    mesh.boundary = whole.boundary;
    if (const Field *size = whole.fields.find(Entity::vertex, "size")) {
        auto own = std::make_shared<Field>(*size);
        own->values.clear();
        take(own->values, size->values, part.vertices);
        mesh.fields.set(std::move(own));
    }
    mesh.begun = std::make_shared<const QuadMesh>(mesh);
    mesh.journal.emplace();
    return part;
}

void put_back(QuadMesh &whole, const Submesh &part) {
    const QuadMesh &changed = part.mesh;
    Twins faces(part.faces), vertices(part.vertices);
    for (const auto &entry : *changed.journal) {
        const QuadMesh::Replacement &asked = *entry;
        const QuadMesh::Replaced there =
            whole.replace_disk(faces.of(asked.faces), vertices.of(asked.loop), asked.quads, asked.points,
                               vertices.of(asked.parents));
        const QuadMesh::Replaced &here = asked.replaced;
        faces.follow(there.moved_faces, there.faces, here.moved_faces, here.faces, here.n_faces);
        vertices.follow(there.moved_vertices, there.vertices, here.moved_vertices, here.vertices,
                        here.n_vertices);
    }
    for (int v = 0; v < changed.n_vertices(); ++v)
        if (const int twin = vertices.of(v); whole.point(twin) != changed.point(v))
            whole.set_point(twin, changed.point(v));
}

} // namespace alphamst::mesh
