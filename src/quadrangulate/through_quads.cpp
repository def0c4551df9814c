#include "quadrangulate/through_quads.h"

#include <algorithm>
#include <array>
#include <utility>

#include "disjoint_sets.h"
#include "index.h"

namespace alphamst::quadrangulate {
namespace {

constexpr int draw_layers = 3;      // about as far as a path goes that turns around a vertex
constexpr int most_rounds = 16;     // and fewer where
constexpr int most_rounds_vain = 2; // nothing has become better in so many, or
constexpr int most_tries = 8;       // what is poor is so however quads are cut
constexpr int growth = 2;           // of the part around it with every try
constexpr int most_doubled = 8;     // of a part around a triangle that is left over: most of any mesh

// Where the sides of faces are once quads are cut: a quad becomes two triangles one after the other.
class Places {
public:
    explicit Places(const Cut &cut, mesh::Faces given) : cut_(cut), given_(given), first_(given.size() / 4) {
        for (std::size_t t = cut.origin.size(); t-- > 0;)
            first_[at(cut.origin[t])] = static_cast<std::int32_t>(t);
    }

    std::int32_t first_triangle(std::size_t face) const { return first_[face]; }
    std::int32_t n_triangles(std::size_t face) const { return mesh::is_triangle(given_, face) ? 1 : 2; }

    std::int32_t operator()(std::int32_t corner) const {
        const auto face = at(corner / 4);
        const std::int32_t first = first_[face];
        if (mesh::is_triangle(given_, face))
            return 4 * first + corner % 4;
        std::int32_t start = 0;
        while (given_[4 * face + at(start)] != cut_.faces[4 * at(first)])
            ++start;
        const std::int32_t k = (corner % 4 - start + 4) % 4;
        return 4 * (first + k / 2) + k % 2;
    }

private:
    const Cut &cut_;
    mesh::Faces given_;
    std::vector<std::int32_t> first_;
};

void connect(TriangleSides &sides, std::int32_t c, std::int32_t d, Bar bar) {
    sides.across[at(c)] = d;
    sides.bars[at(c)] = bar;
    if (d < 0)
        return;
    sides.across[at(d)] = c;
    sides.bars[at(d)] = bar;
}

class ThroughQuads {
public:
    ThroughQuads(const Polygons &polygons, bool may_leave, Paired &paired)
        : points_(polygons.points), given_(polygons.faces), n_given_(given_.size() / 4),
          may_leave_(may_leave), sides_(std::move(paired.sides)), paired_(paired),
          diagonals_(parallel_diagonals(given_, sides_.across)), components_(n_given_), odd_(n_given_),
          has_exit_(n_given_), tries_(n_given_), local_(n_given_, -1) {
        paired.cut = cut_quads(points_, given_, diagonals_);
        places_.emplace_back(paired.cut, given_);
        for (std::size_t c = 0; c < given_.size(); ++c)
            if (sides_.across[c] > static_cast<std::int32_t>(c))
                components_.unite(static_cast<std::int32_t>(c / 4), sides_.across[c] / 4);
        for (std::size_t f = 0; f < n_given_; ++f)
            if (mesh::is_triangle(given_, f))
                odd_[components_.find(f)].flip();
        cut_all();
    }

    void run() {
        int in_vain = 0;
        for (int round = 0; round < most_rounds; ++round) {
            const std::vector<std::vector<std::int32_t>> parts = parts_near_poor();
            if (parts.empty())
                return;
            bool is_better = false;
            for (const std::vector<std::int32_t> &part : parts)
                is_better = try_part(part, round) || is_better;
            in_vain = is_better ? 0 : in_vain + 1;
            if (in_vain >= most_rounds_vain &&
                std::ranges::none_of(paired_.pairing.poor, [&](std::int32_t t) { return is_left_over(t); }))
                return;
        }
    }

private:
    const Places &places() const { return places_.front(); }
    std::vector<Choice> &choices() { return paired_.pairing.choices; }
    bool is_exit(const Choice &choice) const { return choice.kind == Choice::Kind::halve && choice.mate < 0; }
    bool is_left_over(std::int32_t t) { return choices()[at(t)].kind == Choice::Kind::none; }

    // What was paired before, of all triangles, quads being two of them that are merged.
    void cut_all() {
        const std::size_t n = paired_.cut.origin.size();
        paired_.sides = {std::vector<std::int32_t>(4 * n, -1), std::vector<Bar>(4 * n, Bar::none),
                         paired_.cut.diagonals, sides_.held};
        Pairing before = std::exchange(paired_.pairing, {});
        choices().resize(n);
        for (std::size_t f = 0; f < n_given_; ++f) {
            const std::int32_t t = places().first_triangle(f);
            if (before.choices[f].kind != Choice::Kind::none)
                choices()[at(t)] = before.choices[f];
            if (before.choices[f].mate >= 0 && before.choices[f].kind != Choice::Kind::cross)
                choices()[at(t)].mate = places().first_triangle(at(before.choices[f].mate));
            if (!mesh::is_triangle(given_, f)) {
                choices()[at(t)] = {Choice::Kind::merge, 2, t + 1};
                choices()[at(t) + 1] = {Choice::Kind::merge, 2, t};
            }
            if (is_exit(choices()[at(t)]))
                has_exit_[components_.find(f)] = true;
            connect_face(f);
        }
        const auto first = [&](std::int32_t f) { return places().first_triangle(at(f)); };
        for (Cross &cross : before.crosses)
            std::ranges::transform(cross.faces, cross.faces.begin(), first);
        paired_.pairing.crosses = std::move(before.crosses);
        paired_.pairing.poor.resize(before.poor.size());
        std::ranges::transform(before.poor, paired_.pairing.poor.begin(), first);
    }

    void connect_face(std::size_t f) {
        for (std::size_t c = 4 * f; c < 4 * f + 4; ++c)
            if (given_[c] >= 0)
                connect(paired_.sides, places()(static_cast<std::int32_t>(c)),
                        sides_.across[c] < 0 ? -1 : places()(sides_.across[c]), sides_.bars[c]);
        if (const std::int32_t t = places().first_triangle(f); !mesh::is_triangle(given_, f))
            connect(paired_.sides, 4 * t + 2, 4 * t + 6, Bar::none);
    }

    // The faces given in so many layers around what is poor, together with all that are paired with them;
    // each part is connected, and ascending.
    std::vector<std::vector<std::int32_t>> parts_near_poor() {
        std::vector<std::pair<int, std::int32_t>> queue; // layers that are left, face
        std::vector<int> left(n_given_, -1);
        const auto add = [&](int layers, std::int32_t face) {
            if (left[at(face)] < layers) {
                left[at(face)] = layers;
                queue.emplace_back(layers, face);
            }
        };
        for (const std::int32_t t : paired_.pairing.poor) {
            const std::int32_t face = paired_.cut.origin[at(t)];
            const int tries = tries_[at(face)];
            if (is_left_over(t) && tries < most_doubled)
                add(draw_layers << tries, face);
            else if (tries < most_tries)
                add(draw_layers + growth * tries, face);
        }
        for (std::size_t head = 0; head < queue.size(); ++head) {
            const auto [layers, face] = queue[head];
            for (std::size_t c = 4 * at(face); layers > 0 && c < 4 * at(face) + 4; ++c)
                if (sides_.across[c] >= 0)
                    add(layers - 1, sides_.across[c] / 4);
            const std::int32_t first = places().first_triangle(at(face));
            for (std::int32_t t = first; t < first + places().n_triangles(at(face)); ++t) {
                const Choice &choice = choices()[at(t)];
                if (choice.kind == Choice::Kind::cross)
                    for (const std::int32_t other : paired_.pairing.crosses[at(choice.mate)].faces)
                        add(0, paired_.cut.origin[at(other)]);
                else if (choice.mate >= 0)
                    add(0, paired_.cut.origin[at(choice.mate)]);
            }
        }
        return connected(left);
    }

    std::vector<std::vector<std::int32_t>> connected(std::vector<int> &left) const {
        std::vector<std::vector<std::int32_t>> parts;
        for (std::size_t f = 0; f < n_given_; ++f) {
            if (left[f] < 0)
                continue;
            left[f] = -1;
            std::vector<std::int32_t> part{static_cast<std::int32_t>(f)};
            for (std::size_t head = 0; head < part.size(); ++head)
                for (std::size_t c = 4 * at(part[head]); c < 4 * at(part[head]) + 4; ++c)
                    if (const std::int32_t d = sides_.across[c]; d >= 0 && left[at(d / 4)] >= 0) {
                        left[at(d / 4)] = -1;
                        part.push_back(d / 4);
                    }
            std::sort(part.begin(), part.end());
            parts.push_back(std::move(part));
        }
        return parts;
    }

    // Pairs the triangles of a part anew, and the halves of its quads, cut in other ways where that has not
    // helped; true and taken if less is poor.
    bool try_part(const std::vector<std::int32_t> &part, int round) {
        std::vector<std::int32_t> faces, across;
        std::vector<std::int8_t> diagonals;
        bool is_all = true; // that is connected
        for (std::size_t i = 0; i < part.size(); ++i)
            local_[at(part[i])] = static_cast<std::int32_t>(i);
        for (const std::int32_t f : part) {
            diagonals.push_back(diagonals_[at(f)]);
            for (std::size_t c = 4 * at(f); c < 4 * at(f) + 4; ++c) {
                faces.push_back(given_[c]);
                const std::int32_t d = sides_.across[c];
                const bool is_inside = d >= 0 && local_[at(d / 4)] >= 0;
                across.push_back(is_inside ? 4 * local_[at(d / 4)] + d % 4 : -1);
                is_all = is_all && (is_inside || d < 0);
            }
        }
        std::vector<std::int32_t> poor, drawn; // places in the part; where diagonals are to be others
        for (const std::int32_t t : paired_.pairing.poor)
            if (const std::int32_t i = local_[at(paired_.cut.origin[at(t)])]; i >= 0) {
                poor.push_back(i);
                // A part that has grown may suffice to what is left over.
                if (is_left_over(t) ? round % 2 == 1 : round > 0)
                    drawn.push_back(i);
            }
        draw_diagonals(faces, across, drawn, draw_layers, static_cast<std::uint64_t>(round), diagonals);
        Paired next;
        next.cut = cut_quads(points_, faces, diagonals);
        const Places places(next.cut, faces);
        next.sides = sides_of(part, across, next.cut, places);
        next.pairing = pair_triangles(points_, next.cut.faces, next.sides, may_leave_from(part));
        const bool is_better = next.pairing.poor.size() < poor.size();
        for (const std::int32_t i : poor)
            tries_[at(part[at(i)])] += is_all ? most_doubled / 4 : 1; // only cuts can help
        if (is_better)
            take(part, next, places, diagonals);
        for (const std::int32_t f : part)
            local_[at(f)] = -1;
        return is_better;
    }

    // Nothing leads out of the part.
    TriangleSides sides_of(const std::vector<std::int32_t> &part, const std::vector<std::int32_t> &across,
                           const Cut &cut, const Places &places) const {
        TriangleSides result{std::vector<std::int32_t>(cut.faces.size(), -1),
                             std::vector<Bar>(cut.faces.size(), Bar::none), cut.diagonals, sides_.held};
        for (std::size_t c = 0; c < across.size(); ++c) {
            const std::size_t given = 4 * at(part[c / 4]) + c % 4;
            if (given_[given] < 0)
                continue;
            const bool ends = across[c] < 0 && sides_.across[given] >= 0;
            connect(result, places(static_cast<std::int32_t>(c)), across[c] < 0 ? -1 : places(across[c]),
                    ends ? Bar::curve : sides_.bars[given]);
        }
        for (std::size_t t = 0; t + 1 < cut.origin.size(); ++t)
            if (cut.origin[t] == cut.origin[t + 1])
                connect(result, static_cast<std::int32_t>(4 * t + 2), static_cast<std::int32_t>(4 * t + 6),
                        Bar::none);
        return result;
    }

    // Its component gets one vertex on the boundary at most.
    bool may_leave_from(const std::vector<std::int32_t> &part) {
        const std::int32_t component = components_.find(part.front());
        return may_leave_ && odd_[at(component)] && (!has_exit_[at(component)] || exit_of(part) >= 0);
    }

    std::int32_t exit_of(const std::vector<std::int32_t> &part) {
        for (const std::int32_t f : part) {
            const std::int32_t first = places().first_triangle(at(f));
            for (std::int32_t t = first; t < first + places().n_triangles(at(f)); ++t)
                if (is_exit(choices()[at(t)]))
                    return t;
        }
        return -1;
    }

    void take(const std::vector<std::int32_t> &part, const Paired &next, const Places &from,
              const std::vector<std::int8_t> &diagonals) {
        const auto whole = [&](std::int32_t t) {
            const std::int32_t i = next.cut.origin[at(t)];
            return places().first_triangle(at(part[at(i)])) + t - from.first_triangle(at(i));
        };
        const std::int32_t component = components_.find(part.front());
        if (exit_of(part) >= 0)
            has_exit_[at(component)] = false;
        const auto n_crosses = static_cast<std::int32_t>(paired_.pairing.crosses.size());
        for (std::int32_t t = 0; t < static_cast<std::int32_t>(next.cut.origin.size()); ++t) {
            std::copy_n(next.cut.faces.begin() + 4 * t, 4, paired_.cut.faces.begin() + 4 * whole(t));
            Choice choice = next.pairing.choices[at(t)];
            if (choice.mate >= 0)
                choice.mate =
                    choice.kind == Choice::Kind::cross ? choice.mate + n_crosses : whole(choice.mate);
            choices()[at(whole(t))] = choice;
        }
        for (Cross cross : next.pairing.crosses) { // those of before are not referred to any more
            std::ranges::transform(cross.faces, cross.faces.begin(), whole);
            paired_.pairing.crosses.push_back(cross);
        }
        if (exit_of(part) >= 0)
            has_exit_[at(component)] = true;
        for (std::size_t i = 0; i < part.size(); ++i)
            diagonals_[at(part[i])] = diagonals[i];
        for (const std::int32_t f : part)
            connect_face(at(f));
        std::erase_if(paired_.pairing.poor,
                      [&](std::int32_t t) { return local_[at(paired_.cut.origin[at(t)])] >= 0; });
        for (const std::int32_t t : next.pairing.poor) {
            paired_.pairing.poor.push_back(whole(t));
            tries_[at(part[at(next.cut.origin[at(t)])])] = 0;
        }
    }

    mesh::Coordinates points_;
    mesh::Faces given_;
    std::size_t n_given_;
    bool may_leave_;
    TriangleSides sides_; // of the faces given
    Paired &paired_;
    std::vector<std::int8_t> diagonals_;
    std::vector<Places> places_;
    DisjointSets components_;
    std::vector<bool> odd_, has_exit_; // of the face that stands for a component
    std::vector<int> tries_;           // in vain, of each face
    std::vector<std::int32_t> local_;  // the place of each face in the part under way, -1: not in it
};

} // namespace

void pair_through_quads(const Polygons &polygons, bool may_leave, Paired &paired) {
    ThroughQuads(polygons, may_leave, paired).run();
}

} // namespace alphamst::quadrangulate
