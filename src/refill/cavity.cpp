#include "refill/cavity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "patch/region.h"
#include "reference/cross_field.h"
#include "reference/locate.h"
#include "refill/respacing.h"
#include "smooth/shaping.h"

namespace alphamst::refill {
namespace {

Eigen::Vector3d vector(const OpenMesh::Vec3d &p) { return {p[0], p[1], p[2]}; }

std::string name_defects(std::int32_t bits) {
    struct Name {
        std::int32_t bit;
        const char *text;
    };
    constexpr Name names[] = {{patch::empty, "it has no face"},
                              {patch::not_connected, "its faces are not connected through edges"},
                              {patch::not_disk, "it has a hole or closes up"},
                              {patch::pinched, "its boundary touches itself"},
                              {patch::crosses_feature, "a flagged entity or region border lies inside"},
                              {patch::odd_boundary, "its boundary has an odd number of edges"}};
    std::string text = "the patch cannot be refilled:";
    for (const Name &name : names)
        if ((bits & name.bit) != 0)
            text += std::string(text.back() == ':' ? " " : ", ") + name.text;
    return text;
}

} // namespace

Cavity::Cavity(const mesh::QuadMesh &mesh, const Patch &patch, const Goal &goal, const Settings &settings,
               const reference::Reference &reference)
    : mesh_(mesh), goal_(goal), settings_(settings), reference_(reference) {
    patch::Region region(mesh, patch.faces);
    const std::int32_t bits = patch::defects_of(mesh, region);
    if (bits != 0)
        throw Refusal{Fault::patch, name_defects(bits)};
    window = patch::window_of(mesh, std::move(region));
    regular_ = window.wanted;
    if (!patch.corners.empty())
        use_corners(patch.corners);
    read_old_filling();
    flatten();
    old_quality = old_shape.min_scaled_jacobian;
    if (goal.sizes && patch.corners.empty())
        keep_angles(goal.keep_quality ? std::min(0.95, old_quality + 0.01) : std::min(0.3, old_quality));
    if (goal.sizes)
        want_sizes();
}

double Cavity::wanted_area(const Eigen::Vector3d &place) const {
    const Eigen::Vector2d p = plane_.to_plane(place);
    return sizes_->at({p.x(), p.y(), 0});
}

double Cavity::wanted_part(const Eigen::Vector3d &place) const {
    const Eigen::Vector2d p = plane_.to_plane(place);
    return sizes_->part({p.x(), p.y(), 0});
}

void Cavity::respace(patch::Window respaced) {
    if (curved())
        throw Refusal{Fault::internal, "a curved patch keeps its boundary"};
    window = std::move(respaced);
    regular_ = window.wanted;
    old_positions_.clear();
    for (const Eigen::Vector3d &p : loop_points(mesh_, window))
        old_positions_.push_back(plane_.to_plane(p));
    if (corners_given_)
        use_corners(corners_);
    else if (goal_.sizes)
        keep_angles(goal_.keep_quality ? std::min(0.95, old_quality + 0.01) : std::min(0.3, old_quality));
}

bool Cavity::fits(const fill::Filling &filling) const {
    const int length = filling.boundary;
    for (const auto &quad : filling.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const int a = quad[k], b = quad[(k + 1) % 4];
            if (a >= length || b >= length || (a + 1) % length == b || (b + 1) % length == a)
                continue;
            const int from = window.loop[static_cast<std::size_t>(a)],
                      to = window.loop[static_cast<std::size_t>(b)];
            const int edge = from < 0 || to < 0 ? -1 : mesh_.find_edge(from, to);
            if (edge >= 0 && !inside(edge))
                return false;
        }
    return true;
}

std::map<int, std::int64_t> Cavity::valences(const fill::Filling &filling) const {
    std::vector<int> faces(static_cast<std::size_t>(filling.vertices), 0);
    for (const auto &quad : filling.quads)
        for (const int v : quad)
            ++faces[static_cast<std::size_t>(v)];
    std::map<int, std::int64_t> count;
    for (std::size_t v = 0; v < faces.size(); ++v) {
        if (v < window.loop.size() && on_boundary(v))
            continue;
        ++count[faces[v] + (v < window.loop.size() ? window.outside[v] : 0)];
    }
    return count;
}

std::vector<OpenMesh::Vec3d> Cavity::lift(const CavityEmbedding &laid) const {
    std::vector<OpenMesh::Vec3d> points;
    for (std::size_t v = window.loop.size(); v < laid.flat.size(); ++v)
        points.push_back(lift(laid.flat[v]));
    for (std::size_t v = window.loop.size(); v < laid.on_surface.points.size(); ++v) {
        const Eigen::Vector3d &p = laid.on_surface.points[v];
        points.emplace_back(p.x(), p.y(), p.z());
    }
    return points;
}

fill::Request Cavity::request() const {
    fill::Request request;
    request.word = window.wanted;
    for (std::size_t i = 0; i < window.loop.size(); ++i)
        request.regular.push_back(corners_given_ || on_boundary(i) ? regular_[i] : 4 - window.outside[i]);
    request.angles = window.angles;
    request.least_sine = least_sine_;
    request.faces = goal_.faces;
    request.any_count = goal_.any_count;
    if (goal_.keep_quality)
        request.fewer_than = old_singular_all; // for no more than that the present one stays
    request.fewer_than = std::min(request.fewer_than, old_singular_all + 1 + goal_.most_added);
    request.fewest = goal_.fewest;
    request.most_faces = goal_.most;
    request.most = settings_.candidates;
    // Where the present filling is an answer, three plans share the effort.
    request.node_limit = goal_.keep_quality ? settings_.node_limit / 3 : settings_.node_limit;
    request.seed = settings_.seed;
    request.tolerance = 0;
    return request;
}

void Cavity::use_corners(const std::vector<int> &corners) {
    std::fill(window.wanted.begin(), window.wanted.end(), 2);
    corners_ = corners;
    corners_given_ = true;
    for (const int corner : corners) {
        const auto at = std::find(window.loop.begin(), window.loop.end(), corner);
        if (at == window.loop.end())
            throw Refusal{Fault::patch, "a corner of the patch is not on its boundary; set the corners anew"};
        window.wanted[static_cast<std::size_t>(at - window.loop.begin())] = 1;
    }
    regular_ = window.wanted; // a filling that keeps the corners is what counts as regular
}

void Cavity::keep_angles(double least_sine) {
    least_sine_ = least_sine;
    for (std::size_t i = 0; i < window.angles.size(); ++i) {
        auto sine = [&](int letter) {
            constexpr double degree = 3.14159265358979323846 / 180;
            return window.angles[i] < 175 * letter ? std::sin(window.angles[i] / letter * degree) : -1;
        };
        int best = window.wanted[i];
        for (int away = 1; away < 3 && sine(best) < least_sine_; ++away)
            for (const int letter : {window.wanted[i] - away, window.wanted[i] + away})
                if (letter >= 1 && letter <= 4 && sine(letter) > sine(best))
                    best = letter;
        window.wanted[i] = best;
    }
}

void Cavity::flatten() {
    std::vector<int> vertices = window.loop;
    vertices.insert(vertices.end(), window.interior.begin(), window.interior.end());
    std::vector<Eigen::Vector3d> points;
    for (const int v : vertices)
        points.push_back(vector(mesh_.point(v)));
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < window.loop.size(); ++i)
        normal += (points[i] - points[0]).cross(points[(i + 1) % window.loop.size()] - points[0]);
    if (reference_.surface_triangles.empty() || reference_.planes_first) {
        plane_ = mesh_.dim() == 2 ? geometry::Plane::of_coordinates(normal.z() < 0)
                                  : geometry::Plane::fit(points, normal);
        if (plane_.holds(points)) {
            for (const Eigen::Vector3d &p : points)
                old_positions_.push_back(plane_.to_plane(p));
            old_shape = geometry::judge(old.quads, old_positions_);
            return;
        }
    }
    if (!reference_.surface)
        throw Refusal{Fault::internal, "the patch is curved, but the mesh keeps to no surface"};
    old_on_surface_ = on_surface(vertices);
    chart_.emplace(old, old_on_surface_, settings_.chart);
    old_positions_ = chart_->positions();
    old_shape = geometry::judge(old.quads, old_on_surface_);
}

void Cavity::read_old_filling() {
    auto &local = local_;
    for (const int v : window.loop)
        local.emplace(v, static_cast<int>(local.size()));
    for (const int v : window.interior)
        local.emplace(v, static_cast<int>(local.size()));
    old.boundary = static_cast<int>(window.loop.size());
    old.vertices = static_cast<int>(local.size());
    for (const int f : window.faces) {
        const auto corners = mesh_.corners(f);
        old.quads.push_back(
            {local.at(corners[0]), local.at(corners[1]), local.at(corners[2]), local.at(corners[3])});
    }
    old_singular_all = singular_all(old);
}

double Cavity::old_alignment_error() const {
    if (reference_.cross_field == nullptr)
        return 0;
    std::vector<geometry::Quad> quads;
    for (const int f : window.faces)
        quads.push_back(reference::quad_of(mesh_, f));
    return reference_.cross_field->alignment_error(quads);
}

int Cavity::singular_all(const fill::Filling &filling) const {
    std::vector<int> faces(static_cast<std::size_t>(filling.vertices), 0);
    for (const auto &quad : filling.quads)
        for (const int v : quad)
            ++faces[static_cast<std::size_t>(v)];
    int sum = 0;
    for (std::size_t v = 0; v < faces.size(); ++v)
        if (v >= window.loop.size())
            sum += faces[v] != 4;
        else
            sum += on_boundary(v) ? faces[v] != regular_[v] : faces[v] + window.outside[v] != 4;
    return sum;
}

geometry::Points Cavity::flat(std::span<const int> vertices) const {
    geometry::Points positions;
    for (const int v : vertices)
        positions.push_back(plane_.to_plane(vector(mesh_.point(v))));
    return positions;
}

geometry::SurfacePositions Cavity::on_surface(std::span<const int> vertices) const {
    return reference::positions_on_surface(mesh_, surface(), reference_.surface_triangles, vertices);
}

OpenMesh::Vec3d Cavity::lift(const Eigen::Vector2d &position) const {
    const Eigen::Vector3d p = plane_.to_space(position);
    return {p.x(), p.y(), mesh_.dim() == 2 ? 0.0 : p.z()};
}

bool Cavity::inside(int edge) const {
    const auto sides = mesh_.edge_faces(edge);
    auto mine = [&](int f) {
        return f >= 0 && std::binary_search(window.faces.begin(), window.faces.end(), f);
    };
    return mine(sides[0]) && mine(sides[1]);
}

} // namespace alphamst::refill
