// Writes Gmsh's MSH in ASCII: 2.2, which every program that reads MSH still reads, and 4.1, where markers are
// groups of the entities of a model, so that each marker gets one entity.
#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "index.h"
#include "io/formats.h"
#include "io/number.h"

namespace alphamst::io {
namespace {

// Element types of Gmsh's reference manual.
constexpr std::int64_t line_type = 1, quad_type = 3, point_type = 15;

void append_element(std::string &text, std::int64_t number, std::int64_t type, std::int32_t marker,
                    const std::int32_t *vertices, std::size_t n) {
    // The elementary tag must not be 0; the marker itself keeps regions apart.
    const std::array<std::int64_t, 5> head{number, type, 2, marker, marker == 0 ? 1 : marker};
    for (std::int64_t i : head) {
        append_number(text, i);
        text += ' ';
    }
    for (std::size_t k = 0; k < n; ++k) {
        append_number(text, std::int64_t{vertices[k]} + 1);
        text += k + 1 < n ? ' ' : '\n';
    }
}

void append_names(std::string &text, const Names &names) {
    if (names.empty())
        return;
    text += "$PhysicalNames\n" + std::to_string(names.size()) + "\n";
    for (const auto &[of, name] : names)
        text += std::to_string(static_cast<int>(of.first)) + " " + std::to_string(of.second) + " \"" + name +
                "\"\n";
    text += "$EndPhysicalNames\n";
}

class Writer4 {
public:
    explicit Writer4(const Arrays &mesh) : mesh_(mesh) {}

    std::string write() {
        for (const auto &[vertex, marker] : mesh_.marked_points)
            add(0, marker, {&vertex, 1});
        for (const auto &[vertices, marker] : mesh_.marked_edges)
            if (marker != 0)
                add(1, marker, vertices);
        for (std::size_t f = 0; f < mesh_.faces.size() / 4; ++f)
            add(2, mesh_.face_marker.empty() ? 0 : mesh_.face_marker[f],
                std::span(mesh_.faces).subspan(4 * f, 4));
        text_ = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
        append_names(text_, mesh_.names);
        append_entities();
        append_nodes();
        append_elements();
        return std::move(text_);
    }

private:
    // [dimension][marker] corners of the elements; the k-th is the entity k.
    using Groups = std::map<std::int32_t, std::vector<std::int32_t>>;
    struct Kind {
        std::int64_t type;
        std::size_t width;
    };
    static constexpr std::array<Kind, 3> kinds{{{point_type, 1}, {line_type, 2}, {quad_type, 4}}};

    void add(std::size_t dim, std::int32_t marker, std::span<const std::int32_t> vertices) {
        std::vector<std::int32_t> &corners = groups_[dim][marker];
        corners.insert(corners.end(), vertices.begin(), vertices.end());
    }

    void line(std::initializer_list<std::int64_t> numbers) {
        for (const std::int64_t number : numbers) {
            append_number(text_, number);
            text_ += ' ';
        }
        text_.back() = '\n';
    }

    void append_point(const std::array<double, 3> &p) {
        for (const double x : p) {
            append_number(text_, x);
            text_ += ' ';
        }
    }
    std::array<double, 3> point(std::int32_t v) const {
        return {mesh_.points[3 * at(v)], mesh_.points[3 * at(v) + 1], mesh_.points[3 * at(v) + 2]};
    }

    // The point, or the box around all of them.
    void append_place(std::size_t dim, const std::vector<std::int32_t> &vertices) {
        std::array<double, 3> low = point(vertices[0]), high = low;
        for (const std::int32_t v : vertices)
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], point(v)[k]);
                high[k] = std::max(high[k], point(v)[k]);
            }
        append_point(low);
        if (dim > 0)
            append_point(high);
    }

    void append_entities() {
        text_ += "$Entities\n";
        line({std::ssize(groups_[0]), std::ssize(groups_[1]), std::ssize(groups_[2]), 0});
        for (std::size_t dim = 0; dim < 3; ++dim) {
            std::int64_t entity = 0;
            for (const auto &[marker, corners] : groups_[dim]) {
                append_number(text_, ++entity);
                text_ += ' ';
                append_place(dim, corners);
                text_ += marker == 0 ? "0" : "1 " + std::to_string(marker);
                text_ += dim == 0 ? "\n" : " 0\n"; // nothing is known to bound it
            }
        }
        text_ += "$EndEntities\n";
    }

    // All on the first surface.
    void append_nodes() {
        const std::int64_t n = std::ssize(mesh_.points) / 3;
        text_ += "$Nodes\n";
        line({1, n, 1, n});
        line({2, 1, 0, n});
        for (std::int64_t v = 1; v <= n; ++v)
            line({v});
        append_points(text_, mesh_, "");
        text_ += "$EndNodes\n";
    }

    void append_elements() {
        std::int64_t n_blocks = 0, n = 0;
        for (std::size_t dim = 0; dim < 3; ++dim)
            for (const auto &[marker, corners] : groups_[dim]) {
                ++n_blocks;
                n += static_cast<std::int64_t>(corners.size() / kinds[dim].width);
            }
        text_ += "$Elements\n";
        line({n_blocks, n, 1, n});
        std::int64_t element = 0;
        for (std::size_t dim = 0; dim < 3; ++dim) {
            const auto [type, width] = kinds[dim];
            std::int64_t entity = 0;
            for (const auto &[marker, corners] : groups_[dim]) {
                line({static_cast<std::int64_t>(dim), ++entity, type,
                      static_cast<std::int64_t>(corners.size() / width)});
                for (std::size_t c = 0; c < corners.size(); ++c) {
                    if (c % width == 0)
                        append_number(text_, ++element);
                    text_ += ' ';
                    append_number(text_, std::int64_t{corners[c]} + 1);
                    text_ += c % width + 1 == width ? "\n" : "";
                }
            }
        }
        text_ += "$EndElements\n";
    }

    const Arrays &mesh_;
    std::array<Groups, 3> groups_;
    std::string text_;
};

} // namespace

std::string print_msh(const Arrays &mesh) {
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    append_names(text, mesh.names);
    text += "$Nodes\n" + std::to_string(mesh.points.size() / 3) + "\n";
    for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
        append_number(text, static_cast<std::int64_t>(i / 3 + 1));
        for (std::size_t k = 0; k < 3; ++k) {
            text += ' ';
            append_number(text, mesh.points[i + k]);
        }
        text += '\n';
    }
    std::string elements;
    std::int64_t n = 0;
    for (const auto &[vertex, marker] : mesh.marked_points)
        append_element(elements, ++n, point_type, marker, &vertex, 1);
    for (const Arrays::MarkedEdge &edge : mesh.marked_edges)
        if (edge.marker != 0)
            append_element(elements, ++n, line_type, edge.marker, edge.vertices.data(), 2);
    for (std::size_t f = 0; f < mesh.faces.size() / 4; ++f)
        append_element(elements, ++n, quad_type, mesh.face_marker.empty() ? 0 : mesh.face_marker[f],
                       &mesh.faces[4 * f], 4);
    return text + "$EndNodes\n$Elements\n" + std::to_string(n) + "\n" + elements + "$EndElements\n";
}

std::string print_msh4(const Arrays &mesh) { return Writer4(mesh).write(); }

} // namespace alphamst::io
