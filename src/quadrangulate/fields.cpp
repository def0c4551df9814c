#include "quadrangulate/fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <memory>

#include "index.h"
#include "surface/triangle.h"

namespace alphamst::quadrangulate {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<int, 3>;

struct Share {
    std::int32_t from;
    double weight;
};

Vector3d point(mesh::Coordinates points, std::int32_t v) {
    return {points[3 * at(v)], points[3 * at(v) + 1], points[3 * at(v) + 2]};
}

Triangle corners(mesh::Faces faces, std::size_t face, std::size_t half) {
    return {faces[4 * face], faces[4 * face + 1 + half], faces[4 * face + 2 + half]};
}

// The corners of a face that the value at a point is made of.
std::vector<Share> shares_at(const Polygons &given, std::size_t face, const Vector3d &p) {
    surface::Closest best;
    Triangle of_best{};
    for (std::size_t half = 0; half < (mesh::is_triangle(given.faces, face) ? 1u : 2u); ++half) {
        const Triangle ids = corners(given.faces, face, half);
        const surface::Closest found = surface::closest(
            p, {point(given.points, ids[0]), point(given.points, ids[1]), point(given.points, ids[2])}, ids);
        if (half == 0 || found.squared < best.squared) {
            best = found;
            of_best = ids;
        }
    }
    return {{of_best[0], best.weights[0]}, {of_best[1], best.weights[1]}, {of_best[2], best.weights[2]}};
}

// [vertex] of the quads
std::vector<std::vector<Share>> shares_of_vertices(const Polygons &given, const QuadArrays &quads) {
    std::vector<std::vector<Share>> shares(quads.points.size() / 3);
    const std::size_t n_given = given.points.size() / 3;
    for (std::size_t v = 0; v < n_given; ++v)
        shares[v] = {{static_cast<std::int32_t>(v), 1}};
    for (std::size_t c = 0; c < quads.faces.size(); ++c)
        if (std::vector<Share> &of = shares[at(quads.faces[c])]; of.empty())
            of = shares_at(given, at(quads.origin[c / 4]), point(quads.points, quads.faces[c]));
    return shares;
}

double area(const Polygons &given, std::int32_t face) {
    const Triangle t = corners(given.faces, at(face), 0);
    const Vector3d a = point(given.points, t[0]);
    return (point(given.points, t[1]) - a).cross(point(given.points, t[2]) - a).norm() / 2;
}

// [quad] The triangles that it consists of, or the face it is of.
std::vector<std::vector<Share>> shares_of_faces(const Polygons &given, const QuadArrays &quads) {
    std::map<Triangle, std::int32_t> triangles;
    for (std::size_t f = 0; f < given.faces.size() / 4; ++f)
        if (mesh::is_triangle(given.faces, f)) {
            Triangle key = corners(given.faces, f, 0);
            std::ranges::sort(key);
            triangles.emplace(key, static_cast<std::int32_t>(f));
        }
    std::vector<std::vector<Share>> shares(quads.origin.size());
    for (std::size_t q = 0; q < shares.size(); ++q) {
        for (std::size_t left_out = 0; left_out < 4; ++left_out) {
            Triangle key;
            for (std::size_t k = 0; k < 3; ++k)
                key[k] = quads.faces[4 * q + (left_out + 1 + k) % 4];
            std::ranges::sort(key);
            if (const auto found = triangles.find(key); found != triangles.end())
                shares[q].push_back({found->second, area(given, found->second)});
        }
        double sum = 0;
        for (const Share &share : shares[q])
            sum += share.weight;
        if (shares[q].size() != 2 || !(sum > 0))
            shares[q] = {{quads.origin[q], 1}};
        else
            for (Share &share : shares[q])
                share.weight /= sum;
    }
    return shares;
}

mesh::Field blended(const mesh::Field &field, const std::vector<std::vector<Share>> &shares,
                    std::span<const std::int32_t> origin) {
    const std::size_t width = at(field.components);
    mesh::Field result{field.entity, field.name, field.components, field.carry, {}};
    result.values.resize(shares.size() * width);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        std::vector<Share> of = shares[i];
        if (field.carry == mesh::Carry::inherit && !of.empty())
            of = {field.entity == Entity::face
                      ? Share{origin[i], 1}
                      : Share{std::ranges::max_element(of, {}, &Share::weight)->from, 1}};
        for (const Share &share : of)
            for (std::size_t k = 0; k < width; ++k)
                result.values[i * width + k] += share.weight * field.values[at(share.from) * width + k];
    }
    return result;
}

} // namespace

mesh::Fields fields_of(const Polygons &given, const mesh::Fields &fields, const QuadArrays &quads) {
    mesh::Fields result;
    if (fields.empty())
        return result;
    const std::vector<std::vector<Share>> vertices = shares_of_vertices(given, quads),
                                          faces = shares_of_faces(given, quads);
    for (const auto &field : fields)
        if (field->entity != Entity::edge)
            result.set(std::make_shared<mesh::Field>(
                blended(*field, field->entity == Entity::face ? faces : vertices, quads.origin)));
    return result;
}

} // namespace alphamst::quadrangulate
