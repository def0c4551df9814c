#include "io/markers.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "index.h"
#include "mesh/sides.h"

namespace alphamst::io {
namespace {

using Edge = std::array<std::int32_t, 2>;
using Face = std::array<std::int32_t, 4>;

Edge sorted(const Edge &edge) { return {std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}; }

// "3 lines are ...: 1-2 (7), 3-4 (7, 8)"; of many only the first ones.
class Remark {
public:
    explicit Remark(const Number &number) : number_(number) {}

    void add(std::span<const std::int32_t> vertices, const std::set<std::int32_t> &markers) {
        constexpr int most = 10;
        ++n_;
        if (n_ > most)
            list_ += n_ == most + 1 ? ", ..." : "";
        if (n_ > most)
            return;
        list_ += n_ == 1 ? ": " : ", ";
        const char *before = "";
        for (const std::int32_t v : vertices) {
            list_ += std::exchange(before, "-");
            list_ += std::to_string(number_(v));
        }
        before = " (";
        for (const std::int32_t marker : markers) {
            list_ += std::exchange(before, ", ");
            list_ += std::to_string(marker);
        }
        list_ += ")";
    }
    void say(const char *text, Arrays &mesh) const {
        if (n_ > 0)
            mesh.remarks.push_back(std::to_string(n_) + text + list_);
    }
    void say_left_out(const char *text, Arrays &mesh) const {
        say(text, mesh);
        if (n_ > 0 && mesh.left_out.empty())
            mesh.left_out = mesh.remarks.back();
    }

private:
    const Number &number_;
    int n_ = 0;
    std::string list_;
};

// For each of these edges, ascending, whether a face has it.
std::vector<bool> sides_of_faces(const std::vector<Edge> &edges, mesh::Faces faces) {
    std::vector<bool> found(edges.size());
    for (std::size_t c = 0; c < faces.size(); ++c) {
        if (faces[c] < 0)
            continue;
        const Edge side = sorted({faces[c], faces[mesh::next_corner(faces, c)]});
        if (const auto place = std::ranges::lower_bound(edges, side); place != edges.end() && *place == side)
            found[at(place - edges.begin())] = true;
    }
    return found;
}

void settle_edges(Arrays &mesh, const Number &number) {
    if (mesh.marked_edges.empty())
        return;
    std::vector<Edge> edges;
    for (const Arrays::MarkedEdge &line : mesh.marked_edges)
        edges.push_back(sorted(line.vertices));
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const auto place = [&](const Arrays::MarkedEdge &line) {
        return at(std::ranges::lower_bound(edges, sorted(line.vertices)) - edges.begin());
    };
    std::vector<std::set<std::int32_t>> markers(edges.size());
    for (const Arrays::MarkedEdge &line : mesh.marked_edges)
        markers[place(line)].insert(line.marker);
    const std::vector<bool> found = sides_of_faces(edges, mesh.faces);
    std::vector<bool> seen(edges.size());
    std::vector<Arrays::MarkedEdge> kept;
    Remark missing(number), several(number);
    for (const Arrays::MarkedEdge &line : mesh.marked_edges) {
        const std::size_t edge = place(line);
        if (seen[edge])
            continue;
        seen[edge] = true;
        if (!found[edge])
            missing.add(line.vertices, markers[edge]);
        else if (markers[edge].size() > 1)
            several.add(line.vertices, markers[edge]);
        if (found[edge])
            kept.push_back({line.vertices, *markers[edge].begin()});
    }
    mesh.marked_edges = std::move(kept);
    several.say(" lines have several markers, of which the smallest counts; nodes (markers)", mesh);
    constexpr const char *text =
        " lines with a marker are no edges of faces and are left out; nodes (markers)";
    mesh.curve_numbers ? missing.say(text, mesh) : missing.say_left_out(text, mesh);
}

void settle_points(Arrays &mesh, const Number &number) {
    if (mesh.marked_points.empty())
        return;
    std::vector<bool> has_face(mesh.points.size() / 3);
    for (const std::int32_t v : mesh.faces)
        if (v >= 0)
            has_face[at(v)] = true;
    std::map<std::int32_t, std::set<std::int32_t>> markers;
    for (const auto &[vertex, marker] : mesh.marked_points)
        markers[vertex].insert(marker);
    mesh.marked_points.clear();
    Remark missing(number), several(number);
    for (const auto &[vertex, numbers] : markers) {
        if (!has_face[at(vertex)]) {
            missing.add({&vertex, 1}, numbers);
            continue;
        }
        if (numbers.size() > 1)
            several.add({&vertex, 1}, numbers);
        mesh.marked_points.push_back({vertex, *numbers.begin()});
    }
    several.say(" points have several markers, of which the smallest counts; nodes (markers)", mesh);
    missing.say_left_out(" points with a marker have no face and are left out; nodes (markers)", mesh);
}

// Of faces that are left.
void keep_values(Arrays &mesh, const std::vector<bool> &gone) {
    const mesh::Fields all = mesh.fields;
    for (const auto &old : all) {
        if (old->entity != Entity::face)
            continue;
        auto field = std::make_shared<mesh::Field>(*old);
        auto to = field->values.begin();
        for (std::size_t f = 0; f < gone.size(); ++f)
            if (!gone[f])
                to = std::copy_n(old->values.begin() + static_cast<std::ptrdiff_t>(f * at(old->components)),
                                 old->components, to);
        field->values.erase(to, field->values.end());
        mesh.fields.set(std::move(field));
    }
}

// A face comes once for each of its markers: the first place of each, and there the smallest marker.
void settle_faces(Arrays &mesh, const Number &number) {
    std::vector<std::int32_t> &marker = mesh.face_marker;
    if (std::ranges::all_of(marker, [](std::int32_t m) { return m == 0; }))
        marker.clear();
    if (marker.empty() || std::ranges::adjacent_find(marker, std::not_equal_to<>()) == marker.end())
        return;
    const auto face = [&](std::size_t f) {
        return Face{mesh.faces[4 * f], mesh.faces[4 * f + 1], mesh.faces[4 * f + 2], mesh.faces[4 * f + 3]};
    };
    std::vector<std::size_t> order(marker.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(
        order, [&](std::size_t f, std::size_t g) { return std::pair(face(f), f) < std::pair(face(g), g); });
    std::vector<bool> gone(marker.size());
    Remark several(number);
    for (std::size_t i = 0; i < order.size();) {
        std::size_t end = i;
        std::set<std::int32_t> markers;
        for (; end < order.size() && face(order[end]) == face(order[i]); ++end)
            markers.insert(marker[order[end]]);
        // Equal ones of equal markers are a mistake, which building the mesh will name.
        if (end - i > 1 && markers.size() == end - i && !markers.contains(0)) {
            const Face repeated = face(order[i]);
            several.add({repeated.data(), repeated[3] < 0 ? std::size_t{3} : 4}, markers);
            marker[order[i]] = *markers.begin();
            for (std::size_t k = i + 1; k < end; ++k)
                gone[order[k]] = true;
        }
        i = end;
    }
    std::size_t n = 0;
    for (std::size_t f = 0; f < gone.size(); ++f) {
        if (gone[f])
            continue;
        std::copy_n(&mesh.faces[4 * f], 4, &mesh.faces[4 * n]);
        marker[n++] = marker[f];
    }
    mesh.faces.resize(4 * n);
    marker.resize(n);
    if (n < gone.size())
        keep_values(mesh, gone);
    several.say(" faces have several markers, of which the smallest counts; nodes (markers)", mesh);
}

} // namespace

void settle_markers(Arrays &mesh, const Number &number) {
    settle_faces(mesh, number);
    settle_edges(mesh, number);
    settle_points(mesh, number);
}

std::string clean_name(std::string_view name) {
    std::string result(name);
    for (char &c : result)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f' || c == '"')
            c = '_';
    return result;
}

} // namespace alphamst::io
