// What the fillings are measured against: a brute force and a checker that know nothing of the
// library.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace oracle {

using Word = std::vector<int>;
using Sides = std::vector<int>;
using Quad = std::array<int, 4>;

// One face at each corner, two at every other boundary vertex.
inline Word polygon(const Sides &sides) {
    Word word;
    for (const int n : sides)
        for (int k = 0; k < n; ++k)
            word.push_back(k == 0 ? 1 : 2);
    return word;
}

// All sides from shortest to longest with an even sum, one of each class under turns and mirrors.
inline std::vector<Sides> polygons(int corners, int shortest, int longest) {
    std::vector<Sides> all;
    Sides sides(static_cast<std::size_t>(corners), shortest);
    auto smallest = [](const Sides &n) {
        Sides turned = n;
        for (int mirror = 0; mirror < 2; ++mirror, std::reverse(turned.begin(), turned.end()))
            for (std::size_t i = 0; i < n.size(); ++i) {
                std::rotate(turned.begin(), turned.begin() + 1, turned.end());
                if (turned < n)
                    return false;
            }
        return true;
    };
    for (;;) {
        if (std::accumulate(sides.begin(), sides.end(), 0) % 2 == 0 && smallest(sides))
            all.push_back(sides);
        std::size_t i = sides.size();
        while (i > 0 && sides[i - 1] == longest)
            sides[--i] = shortest;
        if (i == 0)
            return all;
        ++sides[i - 1];
    }
}

// The word of a simply connected region of the square grid, grown cell by cell.
template <class Random> Word region(int cells, Random &random) {
    using Cell = std::pair<int, int>;
    const std::array<Cell, 4> step{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    std::set<Cell> inside{{0, 0}};
    Word word;
    for (int tries = 0; static_cast<int>(inside.size()) < cells && tries < 40 * cells; ++tries) {
        auto it = inside.begin();
        std::advance(it, static_cast<long>(random() % inside.size()));
        const Cell by = step[random() % 4], cell{it->first + by.first, it->second + by.second};
        if (!inside.insert(cell).second)
            continue;
        std::map<Cell, Cell> next; // boundary edges, the region on their left
        std::map<Cell, int> faces;
        bool simple = true;
        for (const Cell &c : inside)
            for (std::size_t k = 0; k < 4; ++k) {
                const std::array<Cell, 4> corner{{{c.first, c.second},
                                                  {c.first + 1, c.second},
                                                  {c.first + 1, c.second + 1},
                                                  {c.first, c.second + 1}}};
                const std::array<Cell, 4> beyond{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
                ++faces[corner[k]];
                if (!inside.count({c.first + beyond[k].first, c.second + beyond[k].second}))
                    simple = next.insert({corner[k], corner[(k + 1) % 4]}).second && simple;
            }
        Word loop;
        Cell at = next.begin()->first;
        do {
            loop.push_back(faces[at]);
            at = next[at];
        } while (at != next.begin()->first && loop.size() <= next.size());
        if (simple && loop.size() == next.size())
            word = loop;
        else
            inside.erase(cell);
    }
    return word;
}

// ------------------------------------------------------------------ checker

// What quads over a boundary loop 0 .. boundary-1 really are.
struct Disk {
    std::string fault; // empty: a disk of quads whose boundary is the loop, counter-clockwise
    Word word;         // faces at each boundary vertex
    int v3 = 0, v5 = 0;
    int other = 0; // inner vertices of valence neither 3, 4 nor 5
    int faces = 0;
};

template <class Filling> Disk inspect(const Filling &filling) {
    Disk disk;
    const int boundary = filling.boundary, vertices = filling.vertices;
    const auto fail = [&](const std::string &why) {
        disk.fault = why;
        return disk;
    };
    if (boundary < 4 || vertices < boundary)
        return fail("no boundary");
    std::map<std::pair<int, int>, std::size_t> left;                          // directed edge -> quad
    std::vector<std::map<int, int>> link(static_cast<std::size_t>(vertices)); // next neighbour, clockwise
    std::vector<int> valence(static_cast<std::size_t>(vertices), 0);
    for (std::size_t q = 0; q < filling.quads.size(); ++q)
        for (std::size_t k = 0; k < 4; ++k) {
            const int v = filling.quads[q][k], next = filling.quads[q][(k + 1) % 4];
            const int last = filling.quads[q][(k + 3) % 4];
            if (v < 0 || v >= vertices)
                return fail("vertex out of range");
            if (v == next || v == filling.quads[q][(k + 2) % 4])
                return fail("quad with a vertex twice");
            if (!left.insert({{v, next}, q}).second)
                return fail("edge used twice in one direction");
            link[static_cast<std::size_t>(v)][last] = next;
            ++valence[static_cast<std::size_t>(v)];
        }
    std::size_t edges = 0, open = 0;
    for (const auto &[edge, quad] : left) {
        const auto [a, b] = edge;
        if (left.count({b, a})) {
            edges += a < b;
            continue;
        }
        ++edges;
        ++open;
        if (a >= boundary || b != (a + 1) % boundary)
            return fail("open edge inside");
    }
    if (open != static_cast<std::size_t>(boundary))
        return fail("boundary edge missing");
    for (int v = 0; v < vertices; ++v) { // one fan around each vertex
        const auto &around = link[static_cast<std::size_t>(v)];
        if (around.empty())
            return fail("vertex without faces");
        int at = v < boundary ? (v + boundary - 1) % boundary : around.begin()->first;
        const int start = at;
        std::size_t steps = 0;
        for (auto it = around.find(at); it != around.end() && steps <= around.size(); it = around.find(at)) {
            at = it->second;
            ++steps;
            if (at == start)
                break;
        }
        const int end = v < boundary ? (v + 1) % boundary : start;
        if (steps != around.size() || at != end)
            return fail("vertex with more than one fan");
    }
    std::vector<char> seen(filling.quads.size(), 0);
    std::vector<std::size_t> stack{0};
    seen[0] = 1;
    std::size_t reached = 0;
    while (!stack.empty()) {
        const Quad quad = filling.quads[stack.back()];
        stack.pop_back();
        ++reached;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto it = left.find({quad[(k + 1) % 4], quad[k]});
            if (it != left.end() && !seen[it->second]) {
                seen[it->second] = 1;
                stack.push_back(it->second);
            }
        }
    }
    if (reached != filling.quads.size())
        return fail("not connected");
    if (static_cast<std::size_t>(vertices) + filling.quads.size() != edges + 1)
        return fail("not a disk");
    disk.faces = static_cast<int>(filling.quads.size());
    for (int v = 0; v < vertices; ++v) {
        const int faces = valence[static_cast<std::size_t>(v)];
        if (v < boundary) {
            disk.word.push_back(faces);
            continue;
        }
        disk.v3 += faces == 3;
        disk.v5 += faces == 5;
        disk.other += faces < 3 || faces > 5;
    }
    return disk;
}

// -------------------------------------------------------------- brute force

// Valence-3 and valence-5 vertices and faces of a filling.
struct Count {
    int v3, v5, faces;
    auto operator<=>(const Count &) const = default;
};

// Every quadrangulation of a disk with given face counts at the boundary vertices, each
// made exactly once: a quad is laid on one open edge of one open loop in all possible ways. No
// valence is chosen when a vertex is made; it is read off when the last open loop leaves it.
// Branches are cut by the face limit and by the singularities that the valences seen so far
// already force; nothing is remembered and nothing is developed.
class BruteForce {
public:
    BruteForce(const Word &word, int most_v3, int most_v5, int most_faces)
        : most_v3_(most_v3), most_v5_(most_v5), most_faces_(most_faces) {
        Loop loop;
        for (const int letter : word) {
            loop.push_back(static_cast<int>(vertices_.size()));
            vertices_.push_back({letter, 0, 1});
        }
        for (std::size_t i = 0; i < loop.size(); ++i)
            edges_.push_back(ends(loop[i], loop[(i + 1) % loop.size()]));
        if (loop.size() >= 4 && loop.size() % 2 == 0)
            loops_.push_back(std::move(loop));
    }

    std::set<Count> all() {
        stop_at_first_ = false;
        return run();
    }
    bool any() {
        stop_at_first_ = true;
        return !run().empty();
    }

    long long nodes = 0;

private:
    using Loop = std::vector<int>; // counter-clockwise, the region to fill on its left
    struct Vertex {
        int wanted; // faces of a boundary vertex, 0: an inner vertex
        int faces;  // laid so far
        int open;   // open loops through it
    };

    std::set<Count> run() {
        found_.clear();
        if (!loops_.empty() && plausible())
            grow();
        return found_;
    }

    bool done() const { return stop_at_first_ && !found_.empty(); }
    Vertex &at(int v) { return vertices_[static_cast<std::size_t>(v)]; }
    const Vertex &at(int v) const { return vertices_[static_cast<std::size_t>(v)]; }
    int largest(const Vertex &vertex) const { return vertex.wanted != 0 ? vertex.wanted : 5; }

    // Whether the valences so far can be completed within the limits. By Gauss and Bonnet a region
    // whose vertices still want r faces each holds 4 - sum of (2 - r) more valence-3 than valence-5
    // vertices.
    bool plausible() {
        int v3 = 0, v5 = 0, faces = faces_;
        for (const Vertex &vertex : vertices_) {
            if (vertex.faces + vertex.open > largest(vertex))
                return false;
            if (vertex.wanted != 0) {
                if (vertex.open == 0 && vertex.faces != vertex.wanted)
                    return false;
            } else {
                if (vertex.open == 0 && vertex.faces < 3)
                    return false;
                v3 += vertex.open == 0 && vertex.faces == 3;
                v5 += vertex.faces + vertex.open == 5;
            }
        }
        v3_ = v3, v5_ = v5;
        for (const Loop &loop : loops_) {
            int low = 4, high = 4;
            for (const int v : loop) {
                const Vertex &vertex = at(v);
                const int most = largest(vertex) - vertex.faces - (vertex.open - 1);
                if (vertex.open > 1) { // any share of what is left
                    low -= 1;
                    high -= 2 - most;
                } else {
                    const int regular = vertex.wanted != 0 ? most : std::max(1, most - 1);
                    low -= 2 - regular;
                    high -= 2 - regular;
                }
            }
            v3 += std::max(0, low);
            v5 += std::max(0, -high);
            faces += static_cast<int>(loop.size()) / 2 - 1;
        }
        return v3 <= most_v3_ && v5 <= most_v5_ && faces <= most_faces_;
    }

    // Ways an end of the next quad's edge can go on: this quad is its last one here, or not.
    int freedom(int v) const {
        const Vertex &vertex = at(v);
        const bool five = vertex.faces + vertex.open == 5; // counted already
        bool last = true, more = vertex.faces + vertex.open + 1 <= largest(vertex);
        if (vertex.wanted == 0) {
            if (vertex.open == 1)
                last = vertex.faces >= 3 || (vertex.faces == 2 && v3_ < most_v3_);
            if (!five && vertex.faces + vertex.open + 1 == 5)
                more = more && v5_ < most_v5_;
        } else if (vertex.open == 1) {
            last = vertex.faces + 1 == vertex.wanted;
        }
        return last + more;
    }

    void grow() {
        ++nodes;
        if (loops_.empty()) {
            found_.insert({v3_, v5_, faces_});
            return;
        }
        Loop loop = loops_.back();
        const std::size_t length = loop.size();
        std::size_t best = 0;
        int fewest = 99;
        for (std::size_t i = 0; i < length; ++i) {
            const int ways = freedom(loop[i]) * freedom(loop[(i + 1) % length]);
            if (ways == 0)
                return;
            if (ways < fewest || (ways == fewest && loop[i] < loop[best]))
                fewest = ways, best = i;
        }
        std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(best), loop.end());
        loops_.pop_back();
        lay(loop);
        loops_.push_back(std::move(loop));
    }

    // The quad (loop[0], loop[1], c, d), c and d new or at positions j < k of the loop.
    void lay(const Loop &loop) {
        const int n = static_cast<int>(loop.size()), fresh = static_cast<int>(vertices_.size());
        auto splits = [](int edges) { return edges % 2 == 1; }; // 1: glued, else a loop
        auto room = [&](int position) {
            const Vertex &vertex = at(loop[static_cast<std::size_t>(position)]);
            return vertex.faces + vertex.open < largest(vertex);
        };
        for (int j = 2; j < n - 1 && !done(); ++j) // both there
            if (splits(j - 1) && (j == 2 || room(j)))
                for (int k = j + 1; k < n && !done(); k += 2)
                    if (splits(n - k) && (k == n - 1 || room(k)))
                        attempt(loop, {path(loop, 1, j, {}), path(loop, j, k, {}), path(loop, k, n, {})},
                                {loop[0], loop[1], loop[static_cast<std::size_t>(j)],
                                 loop[static_cast<std::size_t>(k)]},
                                0);
        for (int k = 3; k < n && !done(); k += 2) // c new
            if (splits(n - k) && (k == n - 1 || room(k)))
                attempt(loop, {path(loop, 1, k, {fresh}), path(loop, k, n, {})},
                        {loop[0], loop[1], fresh, loop[static_cast<std::size_t>(k)]}, 1);
        for (int j = 2; j < n - 1 && !done(); j += 2) // d new
            if (j == 2 || room(j))
                attempt(loop, {path(loop, 1, j, {}), path(loop, j, n, {fresh})},
                        {loop[0], loop[1], loop[static_cast<std::size_t>(j)], fresh}, 1);
        if (!done())
            attempt(loop, {path(loop, 1, n, {fresh + 1, fresh})}, {loop[0], loop[1], fresh, fresh + 1}, 2);
    }

    // The loop from position i on to j, back over further vertices; a glued edge leaves none.
    static Loop path(const Loop &loop, int i, int j, const Loop &back) {
        if (j == i + 1 && back.empty())
            return {};
        Loop part;
        for (int p = i; p <= j; ++p)
            part.push_back(loop[static_cast<std::size_t>(p) % loop.size()]);
        part.insert(part.end(), back.begin(), back.end());
        return part;
    }

    static std::pair<int, int> ends(int a, int b) { return std::minmax({a, b}); }

    // Lays the quad if that joins no two vertices by a second edge.
    void attempt(const Loop &loop, std::vector<Loop> parts, const Quad &quad, int made) {
        const std::size_t loops = loops_.size(), vertices = vertices_.size(), edges = edges_.size();
        for (std::size_t k = 1; k < 4; ++k) {
            const int a = quad[k], b = quad[(k + 1) % 4];
            const auto at_a = std::find(loop.begin(), loop.end(), a);
            if (at_a != loop.end() && (at_a + 1 == loop.end() ? loop.front() : *(at_a + 1)) == b)
                continue; // glued
            if (std::find(edges_.begin(), edges_.end(), ends(a, b)) != edges_.end()) {
                edges_.resize(edges);
                return;
            }
            edges_.push_back(ends(a, b));
        }
        std::vector<std::pair<int, Vertex>> before;
        for (const int v : loop) {
            before.push_back({v, at(v)});
            --at(v).open;
        }
        vertices_.resize(vertices + static_cast<std::size_t>(made), {0, 0, 0});
        for (const int v : quad)
            ++at(v).faces;
        for (Loop &part : parts) {
            for (const int v : part)
                ++at(v).open;
            if (!part.empty())
                loops_.push_back(std::move(part));
        }
        ++faces_;
        if (plausible())
            grow();
        --faces_;
        loops_.resize(loops);
        edges_.resize(edges);
        vertices_.resize(vertices);
        for (const auto &[v, old] : before)
            at(v) = old;
    }

    int most_v3_, most_v5_, most_faces_;
    bool stop_at_first_ = false;
    std::vector<Vertex> vertices_;
    std::vector<Loop> loops_;
    std::vector<std::pair<int, int>> edges_;
    int faces_ = 0, v3_ = 0, v5_ = 0;
    std::set<Count> found_;
};

// Valence-3 less valence-5 vertices of every filling.
inline int excess(const Word &word) {
    int sum = 4;
    for (const int letter : word)
        sum -= 2 - letter;
    return sum;
}

// Fewest singularities of fillings with up to most_faces faces, -1 if it is more than `most`.
inline int least(const Word &word, int most, int most_faces) {
    const int index = excess(word);
    for (int k = std::abs(index); k <= most; k += 2)
        for (int faces = static_cast<int>(word.size()) / 2; faces < most_faces + 4; faces += 4) // small first
            if (BruteForce(word, (k + index) / 2, (k - index) / 2, std::min(faces, most_faces)).any())
                return k;
    return -1;
}

// -------------------------------------------------------- the exact conditions

// Fewest singularities of a polygon with sides of at least 3 edges. With M the longest side and R the
// sum of the others: strict triangle inequality and its like, see Tarini (2021) for one singularity.
inline int table(const Sides &n) {
    const int total = std::accumulate(n.begin(), n.end(), 0);
    const int longest = *std::max_element(n.begin(), n.end()), rest = total - longest;
    if (total % 2 != 0)
        return -1;
    auto triangle = [](int a, int b, int c) {
        return (a + b + c) % 2 == 0 && a < b + c && b < a + c && c < a + b;
    };
    if (n.size() == 1)
        return n[0] >= 6 ? 3 : -1;
    if (n.size() == 2)
        return n[0] >= 3 && n[1] >= 3 ? 2 : -1;
    if (n.size() == 3)
        return triangle(n[0], n[1], n[2]) ? 1 : 3;
    if (n.size() == 4)
        return n[0] == n[2] && n[1] == n[3] ? 0 : longest <= rest - 4 ? 2 : 4;
    if (n.size() == 5) {
        bool one = true; // each side with its neighbours is longer than the two others
        for (std::size_t i = 0; i < 5; ++i)
            one = one && n[(i + 4) % 5] + n[i] + n[(i + 1) % 5] > n[(i + 2) % 5] + n[(i + 3) % 5];
        return one ? 1 : longest <= rest - 6 ? 3 : 5;
    }
    // Chords between opposite sides, of at most two of the three classes, taken off.
    for (int none = 0; none < 3; ++none)
        for (int s = 0; s < longest; ++s)
            for (int t = 0; t < longest; ++t) {
                std::array<int, 3> off{s, t, t};
                off[static_cast<std::size_t>(none)] = 0;
                off[static_cast<std::size_t>((none + 1) % 3)] = s;
                off[static_cast<std::size_t>((none + 2) % 3)] = t;
                auto left = [&](std::size_t i) { return n[i] - off[i % 3]; };
                if (triangle(left(0), left(2), left(4)) && triangle(left(1), left(3), left(5)))
                    return 2;
            }
    return longest <= rest - 8 ? 4 : 6;
}

} // namespace oracle
