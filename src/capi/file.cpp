// Meshes and patches from and to files.
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/limits.h"
#include "capi/options.h"
#include "capi/remarks.h"
#include "capi/triangles.h"
#include "draw/svg.h"
#include "io/arrays.h"
#include "io/checkpoint.h"
#include "io/file.h"
#include "io/scanner.h"
#include "mesh/orient.h"
#include "patch/window.h"
#include "quadrangulate/fields.h"

namespace alphamst::capi {
namespace {

// Without triangles.
io::Arrays all_quad(const Context &context, io::Arrays arrays, const Options &options, EdgeChanges &changes) {
    std::vector<std::array<std::int32_t, 2>> curves =
        edges_to_keep(options, context.index_base, arrays.faces);
    if (!mesh::any_triangle(arrays.faces))
        return arrays;
    for (const auto &[vertices, marker] : arrays.marked_edges)
        curves.push_back(vertices);
    std::vector<std::int32_t> held;
    for (const auto &[vertex, marker] : arrays.marked_points)
        held.push_back(vertex);
    quadrangulate::QuadArrays quads = quads_of(
        context, "amst_mesh_read", {arrays.points, arrays.faces, arrays.face_marker, curves, held}, options);
    changes = changes_in(quads);
    std::vector<std::int32_t> face_marker;
    if (!arrays.face_marker.empty())
        for (const std::int32_t face : quads.origin)
            face_marker.push_back(arrays.face_marker[static_cast<std::size_t>(face)]);
    std::vector<io::Arrays::MarkedEdge> marked_edges;
    for (const auto &[vertices, marker] : arrays.marked_edges)
        for (const std::array<std::int32_t, 2> &piece : quadrangulate::pieces(quads, vertices))
            marked_edges.push_back({piece, marker});
    arrays.fields = quadrangulate::fields_of({arrays.points, arrays.faces, {}, {}}, arrays.fields, quads);
    arrays.face_marker = std::move(face_marker);
    arrays.marked_edges = std::move(marked_edges);
    arrays.points = std::move(quads.points);
    arrays.faces = std::move(quads.faces);
    return arrays;
}

mesh::QuadMesh mesh_of(const io::Arrays &arrays) {
    const auto n = static_cast<std::int32_t>(arrays.points.size() / 3);
    require_size(n, static_cast<std::int64_t>(arrays.faces.size() / 4));
    mesh::QuadMesh mesh = mesh::QuadMesh::build(arrays.dim, arrays.points, arrays.faces);
    mesh.face_marker = arrays.face_marker;
    mesh.curve_numbers = arrays.curve_numbers;
    if (!arrays.marked_edges.empty())
        mesh.edge_marker.resize(static_cast<std::size_t>(mesh.n_edges()));
    for (const auto &[vertices, marker] : arrays.marked_edges) // all are edges of faces
        mesh.edge_marker[static_cast<std::size_t>(mesh.find_edge(vertices[0], vertices[1]))] = marker;
    if (!arrays.marked_points.empty())
        mesh.vertex_marker.resize(static_cast<std::size_t>(n));
    for (const auto &[vertex, marker] : arrays.marked_points) {
        mesh.vertex_marker[static_cast<std::size_t>(vertex)] = marker;
        mesh.vertex_flags[static_cast<std::size_t>(vertex)] |= mesh::corner;
    }
    mesh.names = arrays.names;
    mesh.fields = arrays.fields;
    return mesh;
}

io::Arrays arrays_of(const mesh::QuadMesh &mesh) {
    io::Arrays arrays;
    arrays.dim = mesh.dim();
    arrays.points.reserve(static_cast<std::size_t>(mesh.n_vertices()) * 3);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        const OpenMesh::Vec3d &p = mesh.point(v);
        arrays.points.insert(arrays.points.end(), {p[0], p[1], p[2]});
    }
    arrays.faces.reserve(static_cast<std::size_t>(mesh.n_faces()) * 4);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const std::array<int, 4> corners = mesh.corners(f);
        arrays.faces.insert(arrays.faces.end(), corners.begin(), corners.end());
    }
    arrays.face_marker = mesh.face_marker;
    for (std::size_t e = 0; e < mesh.edge_marker.size(); ++e)
        if (mesh.edge_marker[e] != 0)
            arrays.marked_edges.push_back({mesh.edge_vertices(static_cast<int>(e)), mesh.edge_marker[e]});
    for (std::size_t v = 0; v < mesh.vertex_marker.size(); ++v)
        if (mesh.vertex_marker[v] != 0)
            arrays.marked_points.push_back({static_cast<std::int32_t>(v), mesh.vertex_marker[v]});
    arrays.names = mesh.names;
    arrays.fields = mesh.fields;
    return arrays;
}

// The boundary loop of a disk; of faces that are none, each face on its own.
void append_outlines(std::vector<std::vector<std::int32_t>> &outlines, const mesh::QuadMesh &mesh,
                     const std::vector<int> &faces) {
    constexpr std::int32_t harmless = patch::crosses_feature | patch::odd_boundary;
    if ((patch::defects(mesh, faces) & ~harmless) == 0) {
        outlines.push_back(patch::make_window(mesh, faces).loop);
        return;
    }
    for (const int face : faces) {
        const std::array<int, 4> corners = mesh.corners(face);
        outlines.emplace_back(corners.begin(), corners.end());
    }
}

// The faces in colour, where a field says by how much their sizes are wrong.
void colour_faces(draw::Picture &picture, const mesh::QuadMesh &mesh) {
    const mesh::Field *errors = mesh.fields.find(Entity::face, size_error_field);
    if (errors != nullptr && errors->components == 1)
        picture.errors = errors->values;
}

// The way of each chord through each face, where the edges it enters and leaves by have one number.
void append_chords(std::vector<draw::Polyline> &lines, const mesh::QuadMesh &mesh,
                   const std::vector<double> &chords) {
    const std::size_t components = chords.size() / static_cast<std::size_t>(mesh.n_edges());
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const std::array<int, 4> v = mesh.corners(f);
        for (std::size_t k = 0; k < 2; ++k) {
            const std::array<int, 2> from{v[k], v[k + 1]}, to{v[k + 2], v[(k + 3) % 4]};
            const auto number = [&](const std::array<int, 2> &edge) {
                return chords[components * static_cast<std::size_t>(mesh.find_edge(edge[0], edge[1]))];
            };
            if (number(from) == number(to) && std::abs(number(from)) < 9e15)
                lines.push_back({from, to, std::llround(number(from))});
        }
    }
}

void say_all(const Context &context, const std::string &call, const std::vector<std::string> &remarks) {
    for (const std::string &remark : remarks)
        context.say(AMST_LOG_WARNING, call + ": " + remark);
}

bool has_extension(std::string_view path, std::string_view extension) {
    return path.size() >= extension.size() &&
           io::same_word(path.substr(path.size() - extension.size()), extension);
}
bool is_picture(std::string_view path) { return has_extension(path, ".svg"); }
bool is_checkpoint(std::string_view path) { return has_extension(path, ".amst"); }

// As it was when it was written, but for savepoints and callbacks.
std::shared_ptr<Mesh> restored(const std::shared_ptr<Context> &context, const std::string &path) {
    io::Checkpoint checkpoint = io::parse_checkpoint(io::load(path));
    require_size(checkpoint.mesh->n_vertices(), checkpoint.mesh->n_faces());
    auto made = std::make_shared<Mesh>(context, std::move(checkpoint.mesh));
    made->revision = checkpoint.history.revision;
    made->last_revision = checkpoint.history.last_revision;
    made->at_creation = {std::move(checkpoint.history.crossed), std::move(checkpoint.history.split)};
    return made;
}

io::History history_of(const Mesh &mesh) {
    return {mesh.revision, mesh.last_revision, mesh.at_creation.crossed, mesh.at_creation.split};
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_read(amst_context *ctx, const char *path, const amst_options *options,
                           amst_mesh **out) {
    return guarded(index_base(ctx), [&] {
        const std::shared_ptr<Context> context = required(ctx, "ctx").impl; // whatever a callback destroys
        required(path, "path");
        amst_mesh *&created = required(out, "out");
        if (is_checkpoint(path)) {
            created = new amst_mesh{restored(context, path)};
            return amst_status{AMST_OK};
        }
        EdgeChanges changes;
        io::Arrays given = io::read(path);
        const auto n_given = static_cast<std::int64_t>(given.faces.size() / 4);
        const mesh::Oriented oriented = mesh::orient(given.dim, given.points, given.faces);
        if (!oriented.faces.empty())
            given.faces = oriented.faces;
        const io::Arrays arrays = all_quad(*context, std::move(given), options_of(options), changes);
        std::shared_ptr<mesh::QuadMesh> mesh(new mesh::QuadMesh(mesh_of(arrays)));
        auto made = std::make_shared<Mesh>(context, std::move(mesh));
        made->at_creation = std::move(changes);
        say_all(*context, "amst_mesh_read", arrays.remarks);
        say_turned(*context, "amst_mesh_read", oriented, n_given);
        say_oddities(*context, "amst_mesh_read", *made->current);
        created = new amst_mesh{std::move(made)};
        if (arrays.left_out.empty())
            return amst_status{AMST_OK};
        record_remark(arrays.left_out, -1, context->index_base);
        return amst_status{AMST_PARTIAL};
    });
}

amst_status amst_mesh_write(const amst_mesh *mesh, const char *path) {
    return guarded(index_base(mesh), [&] {
        const std::shared_ptr<Mesh> written = required(mesh, "mesh").impl; // whatever a callback destroys
        const mesh::QuadMesh &current = *written->current;
        required(path, "path");
        if (is_checkpoint(path)) {
            io::save(path, io::print_checkpoint(current, history_of(*written)));
            return;
        }
        const io::Arrays arrays = arrays_of(current);
        if (!is_picture(path)) {
            say_all(*written->context, "amst_mesh_write", io::write(path, arrays));
            return;
        }
        draw::Picture picture = draw::picture(arrays);
        colour_faces(picture, current);
        if (const std::vector<double> *chords = current.field(Entity::edge, "chord"))
            append_chords(picture.lines, current, *chords);
        draw::write_svg(path, picture);
    });
}

amst_status amst_patches_write(const amst_patches *patches, const char *path) {
    return guarded(index_base(patches), [&] {
        const Patches &set = *required(patches, "patches").impl;
        set.require_current();
        required(path, "path");
        if (!is_picture(path))
            throw Failure(Fault::unsupported, "patches are written as a picture: the extension must be .svg");
        const mesh::QuadMesh &mesh = *set.mesh->current;
        const io::Arrays arrays = arrays_of(mesh);
        draw::Picture picture = draw::picture(arrays);
        colour_faces(picture, mesh);
        for (const Patch &region : set.regions)
            append_outlines(picture.outlines, mesh, region.faces);
        draw::write_svg(path, picture);
    });
}
