#include "draw/view.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "draw/raster.h"

namespace alphamst::draw {
namespace {

struct Frame {
    Vector3 towards, right, above; // the eye; in the picture
};

// Coordinates divided by a power of two near the largest, so that nothing overflows.
std::vector<Vector3> normalized(const io::Arrays &mesh) {
    double largest = 0;
    for (double x : mesh.points)
        largest = std::max(largest, std::abs(x));
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    std::vector<Vector3> points(mesh.points.size() / 3);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        points[i / 3][i % 3] = std::scalbn(mesh.points[i], -exponent);
    return points;
}

Frame frame(const Vector3 &towards, const Vector3 &up) {
    const Vector3 right = unit_vector(cross_product(up, towards));
    return {towards, right, cross_product(towards, right)};
}

struct Box {
    Vector3 least{}, most{};
};

Box box(const std::vector<Vector3> &points) {
    Box box;
    for (std::size_t v = 0; v < points.size(); ++v)
        for (std::size_t k = 0; k < 3; ++k) {
            box.least[k] = v == 0 ? points[v][k] : std::min(box.least[k], points[v][k]);
            box.most[k] = v == 0 ? points[v][k] : std::max(box.most[k], points[v][k]);
        }
    return box;
}

// To the right, up and to the eye.
std::vector<Vector3> turned(const std::vector<Vector3> &points, const Frame &frame) {
    std::vector<Vector3> result(points.size());
    for (std::size_t v = 0; v < points.size(); ++v)
        result[v] = {dot_product(points[v], frame.right), dot_product(points[v], frame.above),
                     dot_product(points[v], frame.towards)};
    return result;
}

// How well a mesh stands upright along an axis: the part of its box that its lowest fiftieth spans.
double stand(const std::vector<Vector3> &points, std::size_t axis) {
    const Box whole = box(points);
    const double top = whole.least[axis] + (whole.most[axis] - whole.least[axis]) / 50;
    std::vector<Vector3> low;
    std::copy_if(points.begin(), points.end(), std::back_inserter(low),
                 [&](const Vector3 &p) { return p[axis] <= top; });
    const Box foot = box(low);
    double part = 1;
    for (std::size_t k = 0; k < 3; ++k)
        if (k != axis && whole.most[k] > whole.least[k])
            part *= (foot.most[k] - foot.least[k]) / (whole.most[k] - whole.least[k]);
    return part;
}

// Engineers' files have z up, many of sculptures y: the mesh tells by its feet (Fu et al. 2008); z when in
// doubt.
Vector3 upright(const std::vector<Vector3> &points) {
    return stand(points, 1) > 2 * stand(points, 2) ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
}

double mean_edge(const io::Arrays &mesh, const std::vector<Pixel> &pixels) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const Pixel a = pixels[static_cast<std::size_t>(mesh.faces[i])];
        const Pixel b = pixels[static_cast<std::size_t>(mesh.faces[i % 4 == 3 ? i - 3 : i + 1])];
        sum += std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
    }
    return mesh.faces.empty() ? 0 : sum / static_cast<double>(mesh.faces.size());
}

// How much of the picture the mesh covers, in the unit of the points.
double silhouette(const io::Arrays &mesh, const std::vector<Vector3> &points, const Frame &frame) {
    std::vector<Vector3> seen = turned(points, frame);
    const Box bounds = box(seen);
    for (Vector3 &p : seen)
        p = difference(p, bounds.least);
    const Vector3 size = difference(bounds.most, bounds.least);
    const double cell = std::max(size[0], size[1]) / 128;
    return cell > 0 ? static_cast<double>(Raster(mesh, seen, size[0], size[1], cell).covered()) * cell * cell
                    : 0;
}

// As people choose to see things, not from right above, below or along the ground (Blanz, Tarr and
// Buelthoff 1999), and with as much of them to be seen as can be (Plemenos and Benayada 1996).
Frame widest(const io::Arrays &mesh, const std::vector<Vector3> &points) {
    constexpr int n = 96; // points of a Fibonacci sphere: the next one is turned by the golden angle
    constexpr double cosine = -0.7373688780783197, sine = 0.6754902942615238;
    const Vector3 up = upright(points);
    const Vector3 ahead = up[2] > 0 ? Vector3{1, 0, 0} : Vector3{0, 0, 1}, aside = cross_product(up, ahead);
    Frame best = frame(unit_vector({1, 1, 1}), up);
    double most = 0, x = 1, y = 0;
    for (int i = 0; i < n; ++i) {
        const double height = 1 - (2 * i + 1.0) / n, radius = std::sqrt(1 - height * height);
        if (height > 0.25 && height < 0.65) {
            Vector3 towards;
            for (std::size_t k = 0; k < 3; ++k)
                towards[k] = height * up[k] + radius * (x * ahead[k] + y * aside[k]);
            const Frame candidate = frame(unit_vector(towards), up);
            const double area = silhouette(mesh, points, candidate);
            if (area > most * 1.001) { // not the last digit, but the first of equal ones
                most = area;
                best = candidate;
            }
        }
        const double turned = cosine * x - sine * y;
        y = sine * x + cosine * y;
        x = turned;
    }
    return best;
}

// Of a mesh whose mean normal is `towards`. z points up in the picture, or y when z points to the eye.
Frame facing(const Vector3 &towards) {
    return frame(towards, std::abs(towards[2]) > 0.9 ? Vector3{0, 1, 0} : Vector3{0, 0, 1});
}

} // namespace

Vector3 cross_product(const Vector3 &a, const Vector3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot_product(const Vector3 &a, const Vector3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 difference(const Vector3 &a, const Vector3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector3 unit_vector(const Vector3 &a) {
    const double length = std::sqrt(dot_product(a, a));
    return length > 0 ? Vector3{a[0] / length, a[1] / length, a[2] / length} : a;
}

Vector3 normal(const io::Arrays &mesh, const std::vector<Vector3> &points, std::size_t face) {
    const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(mesh.faces[4 * face + k])]; };
    return cross_product(difference(at(2), at(0)), difference(at(3), at(1)));
}

Drawing project(const io::Arrays &mesh) {
    Drawing drawing;
    const std::vector<Vector3> points = normalized(mesh);
    Vector3 sum{0, 0, 0};
    double total = 0;
    for (std::size_t f = 0; f < mesh.faces.size() / 4; ++f) {
        const Vector3 n = normal(mesh, points, f);
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += n[k];
        total += std::sqrt(dot_product(n, n));
    }
    const double length = std::sqrt(dot_product(sum, sum));
    drawing.curved = mesh.dim == 3 && length < (1 - 1e-9) * total;
    const Frame from = mesh.dim == 2          ? facing({0, 0, 1})
                       : length > 0.1 * total ? facing(unit_vector(sum))
                       : drawing.curved       ? widest(mesh, points)
                                              : facing(unit_vector({1, 1, 1}));
    drawing.points = turned(points, from);
    const auto [least, most] = box(drawing.points);
    const double side = std::max(most[0] - least[0], most[1] - least[1]);
    const double scale = side > 0 ? longer_side / side : 0;
    drawing.pixels.reserve(points.size());
    for (Vector3 &p : drawing.points) {
        drawing.pixels.push_back(
            {std::llround((p[0] - least[0]) * scale), std::llround((most[1] - p[1]) * scale)});
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = (p[k] - least[k]) * scale;
    }
    drawing.width = std::llround((most[0] - least[0]) * scale);
    drawing.height = std::llround((most[1] - least[1]) * scale);
    drawing.edge = mean_edge(mesh, drawing.pixels);
    return drawing;
}

} // namespace alphamst::draw
