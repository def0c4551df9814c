#include "refill/buffer_ring.h"

#include <algorithm>

#include "index.h"
#include "patch/region.h"
#include "reference/feature_line.h"
#include "reference/locate.h"

namespace alphamst::refill {
namespace {

template <class Values> void append(const Values &from, int start, Values &to) {
    to.insert(to.end(), from.begin() + start, from.end());
}

} // namespace

ShapeBounds shape_of(const geometry::Judgement &quads) {
    return {quads.min_scaled_jacobian, quads.min_shape, static_cast<double>(quads.poor), quads.inverted};
}

ShapeBounds both(const ShapeBounds &a, const ShapeBounds &b) {
    return {std::min(a.scaled_jacobian, b.scaled_jacobian), std::min(a.shape, b.shape), a.poor + b.poor,
            a.inverted + b.inverted};
}

bool reaches(const ShapeBounds &reached, const ShapeBounds &wanted) {
    return reached.scaled_jacobian >= wanted.scaled_jacobian && reached.shape >= wanted.shape &&
           reached.poor <= wanted.poor && reached.inverted <= wanted.inverted;
}

BufferRing::BufferRing(const mesh::QuadMesh &mesh, const Cavity &cavity, std::vector<int> faces, bool stays)
    : cavity_(cavity), faces_(std::move(faces)), stays_(stays) {
    number(mesh);
    if (cavity.curved()) {
        on_surface_ = cavity.on_surface(vertices_);
        if (mesh.curves) {
            geometry::SurfacePositions judged = on_surface_;
            reference::forget_normals(mesh, vertices_, quads_, judged);
            normals_ = std::move(judged.normals);
        }
    } else {
        flat_ = cavity.flat(std::span(vertices_).subspan(cavity.window.loop.size()));
        flat_.insert(flat_.begin(), cavity.loop_positions().begin(), cavity.loop_positions().end());
    }
    if (!stays_ && !quads_.empty())
        shape_ =
            shape_of(cavity.curved() ? geometry::judge(quads_, on_surface_) : geometry::judge(quads_, flat_));
}

void BufferRing::number(const mesh::QuadMesh &mesh) {
    const patch::Window &window = cavity_.window;
    for (std::size_t i = 0; i < window.loop.size(); ++i)
        number_.emplace(window.loop[i], static_cast<int>(i));
    vertices_ = window.loop;
    std::vector<int> found(vertices_.size(), 0); // faces of the buffer at each vertex
    for (const int f : faces_) {
        std::array<int, 4> quad = mesh.corners(f);
        for (int &v : quad) {
            const auto [it, fresh] = number_.emplace(v, static_cast<int>(vertices_.size()));
            if (fresh) {
                vertices_.push_back(v);
                found.push_back(0);
            }
            v = it->second;
            ++found[at(v)];
        }
        quads_.push_back(quad);
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const int v = vertices_[i];
        const int inside = i < window.loop.size() ? window.inside[i] : 0;
        fixed_.push_back(stays_ || v < 0 || found[i] + inside != mesh.valence(v) ||
                         patch::constrained(mesh, v));
    }
}

std::vector<geometry::Quad> BufferRing::quads(const fill::Filling &filling,
                                              const CavityEmbedding &embedding) const {
    const auto n = at(filling.vertices), loop = at(filling.boundary);
    std::vector<Eigen::Vector3d> lifted;
    for (const Eigen::Vector2d &p : embedding.flat) {
        const OpenMesh::Vec3d q = cavity_.lift(p);
        lifted.emplace_back(q[0], q[1], q[2]);
    }
    const auto &points = cavity_.curved() ? embedding.on_surface.points : lifted;
    const auto inside = [&](std::size_t v) { return points[v]; };
    const auto around = [&](std::size_t v) {
        return v < loop ? points[v] : points.size() > n ? points[v + n - loop] : on_surface_.points[v];
    };
    std::vector<geometry::Quad> all;
    const auto add = [&](const std::array<int, 4> &quad, const auto &place) {
        geometry::Quad &corners = all.emplace_back();
        for (std::size_t k = 0; k < 4; ++k)
            corners[k] = place(at(quad[k]));
    };
    for (const auto &quad : filling.quads)
        add(quad, inside);
    if (cavity_.curved())
        for (const auto &quad : quads_)
            add(quad, around);
    return all;
}

int BufferRing::inverted(const fill::Filling &filling, geometry::SurfacePositions on_surface) const {
    const auto n = at(filling.vertices);
    if (on_surface.points.size() == n) {
        append(on_surface_.points, filling.boundary, on_surface.points);
        append(on_surface_.surface_triangles, filling.boundary, on_surface.surface_triangles);
    }
    on_surface.normals.resize(n);
    std::copy_n(normals_.begin(), filling.boundary, on_surface.normals.begin());
    append(normals_, filling.boundary, on_surface.normals);
    return geometry::judge(join(filling), on_surface).inverted;
}

CavityEmbedding BufferRing::improve(const fill::Filling &filling, CavityEmbedding embedding,
                                    geometry::EmbedOptions options) const {
    const int loop = filling.boundary;
    const std::vector<std::array<int, 4>> quads = join(filling);
    std::vector<char> fixed(fixed_.begin(), fixed_.begin() + loop);
    fixed.resize(at(filling.vertices), 0);
    fixed.insert(fixed.end(), fixed_.begin() + loop, fixed_.end());
    if (cavity_.curved()) {
        append(on_surface_.points, loop, embedding.on_surface.points);
        append(on_surface_.normals, loop, embedding.on_surface.normals);
        append(on_surface_.surface_triangles, loop, embedding.on_surface.surface_triangles);
        const std::vector<double> areas = cavity_.reference().areas(quads, embedding.on_surface);
        options.area = areas;
        static_cast<geometry::Judgement &>(embedding) =
            geometry::improve(cavity_.surface(), quads, fixed, embedding.on_surface, options);
    } else {
        append(flat_, loop, embedding.flat);
        geometry::Embedding improved = geometry::improve(quads, fixed, std::move(embedding.flat), options);
        static_cast<geometry::Judgement &>(embedding) = improved;
        embedding.flat = std::move(improved.positions);
    }
    return embedding;
}

Moved BufferRing::moved(const fill::Filling &filling, const CavityEmbedding &embedding) const {
    Moved moved;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        if (fixed_[i])
            continue;
        const std::size_t place = i < at(filling.boundary) ? i : i + at(filling.vertices - filling.boundary);
        if (cavity_.curved()) {
            const Eigen::Vector3d &p = embedding.on_surface.points[place];
            moved.vertices.emplace_back(vertices_[i], OpenMesh::Vec3d(p.x(), p.y(), p.z()));
            moved.surface_triangles.push_back(embedding.on_surface.surface_triangles[place]);
        } else {
            moved.vertices.emplace_back(vertices_[i], cavity_.lift(embedding.flat[place]));
        }
    }
    return moved;
}

std::vector<std::array<int, 4>> BufferRing::join(const fill::Filling &filling) const {
    std::vector<std::array<int, 4>> quads = filling.quads;
    for (std::array<int, 4> quad : quads_) {
        for (int &v : quad)
            v += v >= filling.boundary ? filling.vertices - filling.boundary : 0;
        quads.push_back(quad);
    }
    return quads;
}

} // namespace alphamst::refill
