#include "fill/layout.h"

#include <algorithm>
#include <map>
#include <queue>

#include "disjoint_sets.h"

namespace alphamst::fill {
namespace {

using Edge = std::pair<int, int>;

Edge edge(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

struct Edges {
    std::map<Edge, int> number;
    std::vector<Edge> ends;
    std::vector<std::array<int, 4>> of_quad; // edge k joins corners k and k+1

    explicit Edges(const Filling &filling) {
        for (const auto &quad : filling.quads) {
            std::array<int, 4> mine{};
            for (std::size_t k = 0; k < 4; ++k) {
                const Edge e = edge(quad[k], quad[(k + 1) % 4]);
                const auto [it, fresh] = number.emplace(e, static_cast<int>(ends.size()));
                if (fresh)
                    ends.push_back(e);
                mine[k] = it->second;
            }
            of_quad.push_back(mine);
        }
    }
};

// Chord of each edge, numbered from 0 in order of first edge.
std::vector<int> chord_of_edges(const Edges &edges, int &chords) {
    DisjointSets groups(edges.ends.size());
    for (const auto &quad : edges.of_quad) {
        groups.unite(quad[0], quad[2]);
        groups.unite(quad[1], quad[3]);
    }
    std::vector<int> chord(edges.ends.size(), -1), name(edges.ends.size(), -1);
    chords = 0;
    for (std::size_t e = 0; e < chord.size(); ++e) {
        int &number = name[groups.find(e)];
        if (number < 0)
            number = chords++;
        chord[e] = number;
    }
    return chord;
}

std::vector<int> faces_at(const Filling &filling) {
    std::vector<int> count(static_cast<std::size_t>(filling.vertices), 0);
    for (const auto &quad : filling.quads)
        for (const int v : quad)
            ++count[static_cast<std::size_t>(v)];
    return count;
}

// Vertices that no line passes: singular ones, corners, and those of the boundary without two faces.
std::vector<char> stopping_vertices(const Filling &filling, const std::vector<int> &faces,
                                    const std::vector<int> &corners) {
    std::vector<char> stops(static_cast<std::size_t>(filling.vertices), 0);
    for (int v = 0; v < filling.vertices; ++v)
        stops[static_cast<std::size_t>(v)] =
            faces[static_cast<std::size_t>(v)] != (v >= filling.boundary ? 4 : 2);
    for (const int c : corners)
        stops[static_cast<std::size_t>(c)] = 1;
    return stops;
}

// Whether the line of each edge comes to a vertex that stops it. Lines are edges that go straight on
// through regular vertices: an edge belongs to the line of the edge opposite to it in the vertex's fan.
std::vector<char> broken_lines(const Filling &filling, const Edges &edges, const std::vector<int> &faces,
                               const std::vector<char> &stops) {
    DisjointSets lines(edges.ends.size());
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> around(
        static_cast<std::size_t>(filling.vertices));
    for (std::size_t q = 0; q < filling.quads.size(); ++q)
        for (std::size_t k = 0; k < 4; ++k)
            around[static_cast<std::size_t>(filling.quads[q][k])].push_back({q, k});
    std::vector<char> stopped(edges.ends.size(), 0);
    for (int v = 0; v < filling.vertices; ++v) {
        const auto &fan = around[static_cast<std::size_t>(v)];
        if (v >= filling.boundary && faces[static_cast<std::size_t>(v)] == 4) {
            for (const auto &[q, k] : fan) {
                const int out = edges.of_quad[q][k], in = edges.of_quad[q][(k + 3) % 4];
                for (const auto &[r, l] : fan) // the quad after q has `in` as its outgoing edge
                    if (edges.of_quad[r][l] == in)
                        lines.unite(out, edges.of_quad[r][(l + 3) % 4]);
            }
        } else if (stops[static_cast<std::size_t>(v)]) {
            for (const auto &[q, k] : fan) {
                stopped[static_cast<std::size_t>(edges.of_quad[q][k])] = 1;
                stopped[static_cast<std::size_t>(edges.of_quad[q][(k + 3) % 4])] = 1;
            }
        }
    }
    std::vector<char> line_stopped(edges.ends.size(), 0), broken(edges.ends.size(), 0);
    for (std::size_t e = 0; e < edges.ends.size(); ++e)
        if (stopped[e])
            line_stopped[lines.find(e)] = 1;
    for (std::size_t e = 0; e < edges.ends.size(); ++e)
        broken[e] = line_stopped[lines.find(e)];
    return broken;
}

// Chords on the two sides of an unbroken inner line are copies of one, which is the first of its class.
DisjointSets copied_chords(const Edges &edges, const std::vector<int> &chord, int chords,
                           const std::vector<char> &broken) {
    std::vector<int> quads_at(edges.ends.size(), 0);
    for (const auto &quad : edges.of_quad)
        for (const int e : quad)
            ++quads_at[static_cast<std::size_t>(e)];
    DisjointSets classes(static_cast<std::size_t>(chords));
    std::vector<int> across(edges.ends.size(), -1);
    for (const auto &quad : edges.of_quad)
        for (std::size_t k = 0; k < 4; ++k) {
            const auto e = static_cast<std::size_t>(quad[k]);
            if (quads_at[e] != 2 || broken[e])
                continue;
            const int beside = chord[static_cast<std::size_t>(quad[(k + 1) % 4])];
            if (across[e] < 0) {
                across[e] = beside;
                continue;
            }
            const auto [first, later] = std::minmax({classes.find(across[e]), classes.find(beside)});
            classes.unite(first, later);
        }
    return classes;
}

// The vertex of the blocks that each one of the filling is merged into. Numbered in the order of the
// filling, in which the boundary comes first; says how many there are of either.
std::vector<int> name_vertices(const Filling &filling, DisjointSets &merged, Filling &blocks) {
    std::vector<int> name_of_group(static_cast<std::size_t>(filling.vertices), -1), name;
    int next = 0;
    for (int v = 0; v < filling.vertices; ++v) {
        int &number = name_of_group[static_cast<std::size_t>(merged.find(v))];
        if (number < 0)
            number = next++;
        name.push_back(number);
        if (v == filling.boundary - 1)
            blocks.boundary = next;
    }
    blocks.vertices = next;
    return name;
}

} // namespace

void complete(Layout &layout) {
    const Edges edges(layout.blocks);
    const std::vector<int> chord = chord_of_edges(edges, layout.chords);
    const auto chords = static_cast<std::size_t>(layout.chords);
    layout.sides = static_cast<int>(layout.corners.size());
    layout.crossing.clear();
    layout.product.assign(chords, std::vector<int>(chords, 0));
    for (const auto &quad : edges.of_quad) {
        const int a = chord[static_cast<std::size_t>(quad[0])], b = chord[static_cast<std::size_t>(quad[1])];
        layout.crossing.push_back({a, b});
        ++layout.product[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
        ++layout.product[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)];
    }
    layout.incidence.assign(static_cast<std::size_t>(layout.sides), std::vector<int>(chords, 0));
    const int length = layout.blocks.boundary;
    for (int i = 0, side = -1; i < length; ++i) {
        if (side + 1 < layout.sides && layout.corners[static_cast<std::size_t>(side + 1)] == i)
            ++side;
        const int e = edges.number.at(edge(i, (i + 1) % length));
        if (side >= 0)
            ++layout.incidence[static_cast<std::size_t>(side)]
                              [static_cast<std::size_t>(chord[static_cast<std::size_t>(e)])];
    }
}

Layout extract(const Filling &filling, const std::vector<int> &corners) {
    const Edges edges(filling);
    int chords = 0;
    const std::vector<int> chord = chord_of_edges(edges, chords);
    const std::vector<int> faces = faces_at(filling);
    const std::vector<char> broken =
        broken_lines(filling, edges, faces, stopping_vertices(filling, faces, corners));
    DisjointSets classes = copied_chords(edges, chord, chords, broken);
    const auto stays = [&](int e) {
        const int c = chord[static_cast<std::size_t>(e)];
        return classes.find(c) == c;
    };
    Layout layout;
    for (int v = filling.boundary; v < filling.vertices; ++v) {
        layout.v3 += faces[static_cast<std::size_t>(v)] == 3;
        layout.v5 += faces[static_cast<std::size_t>(v)] == 5;
    }

    // Collapse every chord that is not the first of its class.
    DisjointSets merged(static_cast<std::size_t>(filling.vertices));
    for (std::size_t e = 0; e < edges.ends.size(); ++e)
        if (!stays(static_cast<int>(e)))
            merged.unite(edges.ends[e].first, edges.ends[e].second);
    const std::vector<int> name = name_vertices(filling, merged, layout.blocks);
    for (const int c : corners)
        layout.corners.push_back(name[static_cast<std::size_t>(c)]);
    for (std::size_t q = 0; q < filling.quads.size(); ++q) {
        if (!stays(edges.of_quad[q][0]) || !stays(edges.of_quad[q][1]))
            continue;
        std::array<int, 4> quad{};
        for (std::size_t k = 0; k < 4; ++k)
            quad[k] = name[static_cast<std::size_t>(filling.quads[q][k])];
        layout.blocks.quads.push_back(quad);
    }
    complete(layout);
    return layout;
}

Filling expand(const Layout &layout, const Multiplicities &x) {
    const Edges edges(layout.blocks);
    int chords = 0;
    const std::vector<int> chord = chord_of_edges(edges, chords);
    auto copies = [&](int e) { return x[static_cast<std::size_t>(chord[static_cast<std::size_t>(e)])]; };
    Filling filling;
    std::vector<int> vertex(static_cast<std::size_t>(layout.blocks.vertices), -1);
    std::vector<int> first_inside(edges.ends.size(), -1); // first node of an edge, from its smaller end
    std::vector<char> backwards(edges.ends.size(), 0);    // nodes are numbered from the larger end
    for (int i = 0; i < layout.blocks.boundary; ++i) {
        const int j = (i + 1) % layout.blocks.boundary;
        vertex[static_cast<std::size_t>(i)] = filling.vertices++;
        const auto e = static_cast<std::size_t>(edges.number.at(edge(i, j)));
        first_inside[e] = filling.vertices;
        backwards[e] = i > j;
        filling.vertices += copies(static_cast<int>(e)) - 1;
    }
    filling.boundary = filling.vertices;
    for (int v = layout.blocks.boundary; v < layout.blocks.vertices; ++v)
        vertex[static_cast<std::size_t>(v)] = filling.vertices++;
    for (std::size_t e = 0; e < edges.ends.size(); ++e)
        if (first_inside[e] < 0) {
            first_inside[e] = filling.vertices;
            filling.vertices += copies(static_cast<int>(e)) - 1;
        }
    // Node t of 0 .. n on the edge e walked from block vertex `from`.
    auto node = [&](int e, int from, int t) {
        const auto number = static_cast<std::size_t>(e);
        const int n = copies(e);
        const auto [a, b] = edges.ends[number];
        if (t == 0 || t == n)
            return vertex[static_cast<std::size_t>((t == 0) == (from == a) ? a : b)];
        const bool reversed = (from == b) != (backwards[number] != 0);
        return first_inside[number] + (reversed ? n - t : t) - 1;
    };
    std::vector<int> grid;
    for (std::size_t q = 0; q < layout.blocks.quads.size(); ++q) {
        const auto &quad = layout.blocks.quads[q];
        const auto &sides = edges.of_quad[q];
        const int nu = copies(sides[0]), nv = copies(sides[1]);
        grid.assign(static_cast<std::size_t>((nu + 1) * (nv + 1)), -1);
        auto at = [&](int u, int v) -> int & { return grid[static_cast<std::size_t>(v * (nu + 1) + u)]; };
        for (int u = 0; u <= nu; ++u) {
            at(u, 0) = node(sides[0], quad[0], u);
            at(u, nv) = node(sides[2], quad[3], u);
        }
        for (int v = 1; v < nv; ++v) {
            at(0, v) = node(sides[3], quad[0], v);
            at(nu, v) = node(sides[1], quad[1], v);
            for (int u = 1; u < nu; ++u)
                at(u, v) = filling.vertices++;
        }
        for (int v = 0; v < nv; ++v)
            for (int u = 0; u < nu; ++u)
                filling.quads.push_back({at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1)});
    }
    return filling;
}

std::vector<int> side_lengths(const Layout &layout, const Multiplicities &x) {
    std::vector<int> lengths;
    for (const auto &row : layout.incidence)
        lengths.push_back(std::inner_product(row.begin(), row.end(), x.begin(), 0));
    return lengths;
}

std::int64_t face_count(const Layout &layout, const Multiplicities &x) {
    std::int64_t faces = 0;
    for (const auto &[a, b] : layout.crossing)
        faces += static_cast<std::int64_t>(x[static_cast<std::size_t>(a)]) * x[static_cast<std::size_t>(b)];
    return faces;
}

Filling mirrored(const Filling &filling) {
    auto place = [&](int v) { return v < filling.boundary ? (filling.boundary - v) % filling.boundary : v; };
    Filling result{filling.boundary, filling.vertices, {}};
    for (const auto &q : filling.quads)
        result.quads.push_back({place(q[0]), place(q[3]), place(q[2]), place(q[1])});
    return result;
}

Filling rotated(const Filling &filling, int first) {
    auto place = [&](int v) {
        return v < filling.boundary ? (v - first + filling.boundary) % filling.boundary : v;
    };
    Filling result{filling.boundary, filling.vertices, {}};
    for (const auto &q : filling.quads)
        result.quads.push_back({place(q[0]), place(q[1]), place(q[2]), place(q[3])});
    return result;
}

namespace {

// Quads in a canonical order and numbering that start at boundary vertex 0.
std::vector<int> reading(const Filling &filling, const std::vector<int> &corners) {
    std::map<Edge, std::pair<std::size_t, std::size_t>> left; // directed edge -> quad, corner
    for (std::size_t q = 0; q < filling.quads.size(); ++q)
        for (std::size_t k = 0; k < 4; ++k)
            left[{filling.quads[q][k], filling.quads[q][(k + 1) % 4]}] = {q, k};
    std::vector<int> name(static_cast<std::size_t>(filling.vertices), -1), text{filling.boundary};
    text.insert(text.end(), corners.begin(), corners.end());
    for (int v = 0; v < filling.boundary; ++v)
        name[static_cast<std::size_t>(v)] = v;
    int next = filling.boundary;
    std::queue<Edge> front;
    std::vector<char> seen(filling.quads.size(), 0);
    for (int v = 0; v < filling.boundary; ++v)
        front.push({v, (v + 1) % filling.boundary});
    while (!front.empty()) {
        const auto it = left.find(front.front());
        front.pop();
        if (it == left.end() || seen[it->second.first])
            continue;
        const auto [q, k] = it->second;
        seen[q] = 1;
        for (std::size_t i = 0; i < 4; ++i) {
            const int v = filling.quads[q][(k + i) % 4], w = filling.quads[q][(k + i + 1) % 4];
            int &number = name[static_cast<std::size_t>(v)];
            if (number < 0)
                number = next++;
            text.push_back(number);
            front.push({w, v});
        }
    }
    return text;
}

} // namespace

std::vector<int> signature(const Layout &layout) {
    std::vector<int> best;
    for (int mirror = 0; mirror < 2; ++mirror) {
        const Filling filling = mirror ? mirrored(layout.blocks) : layout.blocks;
        std::vector<int> corners = layout.corners;
        if (mirror)
            for (int &c : corners)
                c = (filling.boundary - c) % filling.boundary;
        for (const int first : corners) {
            std::vector<int> moved;
            for (const int c : corners)
                moved.push_back((c - first + filling.boundary) % filling.boundary);
            std::sort(moved.begin(), moved.end());
            std::vector<int> text = reading(rotated(filling, first), moved);
            if (best.empty() || text < best)
                best = std::move(text);
        }
    }
    return best;
}

} // namespace alphamst::fill
