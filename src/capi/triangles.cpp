#include "capi/triangles.h"

#include <algorithm>
#include <string>

#include "quadrangulate/halve.h"

namespace alphamst::capi {
namespace {

using Edge = std::array<std::int32_t, 2>;

// "3 of something: 1-2, 3-4, 5-6"; of many only the first ones.
std::string list(const char *what, const std::vector<Edge> &edges, int index_base) {
    constexpr std::size_t most = 10;
    std::string text = std::to_string(edges.size()) + what;
    for (std::size_t i = 0; i < edges.size() && i < most; ++i)
        text += (i == 0 ? ": " : ", ") + std::to_string(edges[i][0] + index_base) + "-" +
                std::to_string(edges[i][1] + index_base);
    return edges.size() > most ? text + ", ..." : text;
}

// The edges given that have a vertex now, on the boundary or not. Pieces of halved ones are not told.
std::vector<Edge> halved(const quadrangulate::QuadArrays &quads, std::size_t n_given, bool on_boundary) {
    const std::vector<std::int32_t> across =
        quadrangulate::across_edges(quads.faces, mesh::pair_sides(quads.faces, quads.points.size() / 3));
    std::vector<bool> bounds(quads.points.size() / 3);
    for (std::size_t c = 0; c < across.size(); ++c)
        if (across[c] < 0)
            bounds[static_cast<std::size_t>(quads.faces[c])] = true;
    std::vector<Edge> edges;
    for (const auto &[edge, vertex] : quads.midpoints)
        if (static_cast<std::size_t>(edge[1]) < n_given &&
            bounds[static_cast<std::size_t>(vertex)] == on_boundary)
            edges.push_back(edge);
    return edges;
}

} // namespace

std::vector<Edge> edges_to_keep(const Options &options, int index_base, mesh::Faces faces) {
    std::vector<Edge> edges;
    for (const auto &[v, w] : options.edges) // an id below the base is that of no corner
        edges.push_back({v < index_base ? -1 : v - index_base, w < index_base ? -1 : w - index_base});
    if (edges.empty())
        return edges;
    std::vector<Edge> wanted;
    for (const auto &[v, w] : edges)
        wanted.push_back({std::min(v, w), std::max(v, w)});
    std::ranges::sort(wanted);
    std::vector<Edge> found;
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (const std::size_t next = mesh::next_corner(faces, c); faces[c] >= 0)
            if (const Edge side{std::min(faces[c], faces[next]), std::max(faces[c], faces[next])};
                std::ranges::binary_search(wanted, side))
                found.push_back(side);
    std::ranges::sort(found);
    std::vector<Edge> missing;
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (!std::ranges::binary_search(
                found, Edge{std::min(edges[e][0], edges[e][1]), std::max(edges[e][0], edges[e][1])}))
            missing.push_back(options.edges[e]);
    if (!missing.empty())
        throw Failure(Fault::not_found, list(" edges of the options are no sides of faces", missing, 0));
    return edges;
}

quadrangulate::QuadArrays quads_of(const Context &context, const char *call,
                                   const quadrangulate::Polygons &polygons, const Options &options) {
    quadrangulate::QuadArrays quads = quadrangulate::quadrangulate(
        polygons, options.quadrangulate,
        {.sharp_angle = options.sharp_angle, .new_boundary_vertices = !options.keep_boundary});
    if (context.log == nullptr || options.quadrangulate == quadrangulate::Quadrangulation::split)
        return quads;
    const auto say = [&](std::int32_t level, const std::string &text) {
        context.say(level, std::string(call) + ": " + text);
    };
    const std::size_t n_given = polygons.points.size() / 3;
    if (!quads.crossed.empty())
        say(AMST_LOG_WARNING,
            list(" sharp edges are within quads, as sides have odd numbers of triangles or no other pairs",
                 quads.crossed, context.index_base));
    if (!quads.midpoints.empty()) {
        if (const auto edges = halved(quads, n_given, true); !edges.empty())
            say(AMST_LOG_WARNING,
                list(" boundary edges have a new vertex, as the triangles are odd in number", edges,
                     context.index_base));
        if (const auto edges = halved(quads, n_given, false); !edges.empty())
            say(AMST_LOG_INFO, list(" edges inside have a new vertex, as triangles at them have no mate",
                                    edges, context.index_base));
    }
    if (const std::size_t added = quads.points.size() / 3 - n_given; added > 0)
        say(AMST_LOG_INFO, std::to_string(added) + " vertices are new, from " +
                               std::to_string(n_given + static_cast<std::size_t>(context.index_base)) +
                               " on");
    return quads;
}

EdgeChanges changes_in(const quadrangulate::QuadArrays &quads) {
    EdgeChanges changes;
    for (const auto &[v, w] : quads.crossed)
        changes.crossed.push_back({std::min(v, w), std::max(v, w)});
    std::ranges::sort(changes.crossed);
    for (const auto &[edge, vertex] : quads.midpoints)
        changes.split.push_back({edge[0], edge[1], vertex});
    return changes;
}

} // namespace alphamst::capi
