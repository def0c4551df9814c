#include "fill/exact.h"

#include <algorithm>
#include <functional>
#include <unordered_map>

#include "fill/branch.h"
#include "random.h"
#include "stop.h"

namespace alphamst::fill {
namespace {

__extension__ typedef unsigned __int128 Bits; // 2 bits a letter, 64 letters

Bits pack(const Word &word) {
    Bits bits = 0;
    for (auto it = word.rbegin(); it != word.rend(); ++it)
        bits = (bits << 2) | static_cast<Bits>(*it - 1);
    return bits;
}

Bits smallest_rotation(Bits bits, int length) {
    Bits best = bits;
    const int top = 2 * (length - 1);
    for (int i = 1; i < length; ++i) {
        bits = (bits >> 2) | ((bits & 3) << top);
        best = std::min(best, bits);
    }
    return best;
}

struct Key {
    Bits bits;
    std::int32_t shape; // length, v3, v5
    bool operator==(const Key &) const = default;
};

struct KeyHash {
    std::size_t operator()(const Key &key) const {
        auto mix = [](std::uint64_t h) {
            h ^= h >> 31;
            h *= 0x9e3779b97f4a7c15ull;
            return h ^ (h >> 29);
        };
        const auto low = static_cast<std::uint64_t>(key.bits);
        const auto high = static_cast<std::uint64_t>(key.bits >> 64);
        return mix(low + mix(high + static_cast<std::uint64_t>(key.shape)));
    }
};

Key canonical(const Word &word, Budget budget) {
    const int length = static_cast<int>(word.size());
    const Bits forward = smallest_rotation(pack(word), length);
    const Word mirror(word.rbegin(), word.rend());
    const Bits backward = smallest_rotation(pack(mirror), length);
    return {std::min(forward, backward), length + 256 * budget.v3 + 65536 * budget.v5};
}

Word unpack(const Key &key) {
    Word word(static_cast<std::size_t>(key.shape & 255));
    Bits bits = key.bits;
    for (int &letter : word) {
        letter = static_cast<int>(bits & 3) + 1;
        bits >>= 2;
    }
    return word;
}

// With no or one singularity left the front develops into the square lattice and the face
// count is the area it encloses, about the fixed point of its holonomy (Bunin 2008);
// -1 if it does not close.
int developed_area(const Word &word, Budget budget) {
    std::int64_t x = 0, y = 0, dx = 1, dy = 0, cross = 0;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const std::int64_t nx = x + dx, ny = y + dy;
        cross += x * ny - y * nx;
        x = nx;
        y = ny;
        const int turn = ((2 - word[(i + 1) % word.size()]) % 4 + 4) % 4;
        for (int t = 0; t < turn; ++t) {
            const std::int64_t keep = dx;
            dx = -dy;
            dy = keep;
        }
    }
    if (budget.total() == 0)
        return x == 0 && y == 0 && cross > 0 && cross % 2 == 0 ? static_cast<int>(cross / 2) : -1;
    if ((x + y) % 2 != 0)
        return -1;
    // R turns by -90 degrees for a valence-3, by +90 for a valence-5 vertex; the
    // apex is (I - R)^-1 t, and moving the origin there changes the area by t x apex.
    const std::int64_t s = budget.v3 == 1 ? 1 : -1;
    const std::int64_t ax = (x + s * y) / 2, ay = (y - s * x) / 2;
    cross -= ax * y - ay * x;
    return cross > 0 && cross % 2 == 0 ? static_cast<int>(cross / 2) : -1;
}

int fewest_faces(const Word &word, Budget budget) {
    return static_cast<int>(word.size()) / 2 - 1 + budget.total();
}

bool balanced(const Word &word, Budget budget) { return index(word) == budget.v3 - budget.v5; }

FaceSet sum(const FaceSet &a, const FaceSet &b) {
    FaceSet result;
    for (std::size_t f = 0; f <= most_faces; ++f)
        if (a[f])
            result |= b << f;
    return result;
}

} // namespace

int index(const Word &word) {
    int sum = 4;
    for (const int letter : word)
        sum -= 2 - letter;
    return sum;
}

struct ExactFiller::Memory {
    struct Entry {
        int most;
        FaceSet faces;
    };
    std::unordered_map<Key, Entry, KeyHash> entries;
    std::int64_t nodes = 0, limit = 0;

    FaceSet solve(const Word &word, Budget budget, int most);
    FaceSet solve_parts(const std::vector<Part> &parts, std::size_t first, Budget budget, int most);
    bool build(const Word &word, const std::vector<int> &ids, Budget budget, int faces, std::uint64_t seed,
               Filling &filling);
    bool build_parts(const Branch &branch, const std::vector<int> &ids, Budget budget, int faces,
                     std::uint64_t seed, Filling &filling);
};

FaceSet ExactFiller::Memory::solve(const Word &word, Budget budget, int most) {
    if (!balanced(word, budget) || fewest_faces(word, budget) > most)
        return {};
    if (word.size() == 4 && *std::max_element(word.begin(), word.end()) == 1)
        return FaceSet(budget.total() == 0 ? 2 : 0);
    if (budget.total() <= 1) {
        const int area = developed_area(word, budget);
        if (area < fewest_faces(word, budget) || area > most)
            return {};
    }
    const Key key = canonical(word, budget);
    const auto found = entries.find(key);
    if (found != entries.end() && found->second.most >= most)
        return found->second.faces;
    if (++nodes > limit)
        throw TooHard{};
    FaceSet faces;
    visit_branches(unpack(key), budget, [&](Branch &branch) {
        const Budget rest{budget.v3 - branch.used.v3, budget.v5 - branch.used.v5};
        faces |= solve_parts(branch.parts, 0, rest, most - 1) << 1;
    });
    entries[key] = {most, faces};
    return faces;
}

// Face counts of parts first, first + 1, ... together, over every split of the budget.
FaceSet ExactFiller::Memory::solve_parts(const std::vector<Part> &parts, std::size_t first, Budget budget,
                                         int most) {
    if (first + 1 == parts.size())
        return solve(parts[first].word, budget, most);
    FaceSet faces;
    const int excess = index(parts[first].word);
    for (int v3 = std::max(0, excess); v3 <= budget.v3; ++v3) {
        const Budget own{v3, v3 - excess};
        if (own.v5 > budget.v5)
            break;
        const FaceSet here = solve(parts[first].word, own, most - 1);
        if (here.none())
            continue;
        const Budget rest{budget.v3 - own.v3, budget.v5 - own.v5};
        faces |= sum(here, solve_parts(parts, first + 1, rest, most - 1));
    }
    return faces;
}

bool ExactFiller::Memory::build(const Word &word, const std::vector<int> &ids, Budget budget, int faces,
                                std::uint64_t seed, Filling &filling) {
    if (faces < 1 || !solve(word, budget, faces)[static_cast<std::size_t>(faces)])
        return false;
    if (faces == 1) {
        filling.quads.push_back({ids[0], ids[1], ids[2], ids[3]});
        return true;
    }
    std::vector<Branch> choices;
    visit_branches(word, budget, [&](Branch &branch) { choices.push_back(branch); });
    Random random(seed);
    if (seed != 0)
        random.shuffle(choices);
    for (const Branch &branch : choices) {
        Stop::point();
        const Filling before = filling;
        const Budget rest{budget.v3 - branch.used.v3, budget.v5 - branch.used.v5};
        if (build_parts(branch, ids, rest, faces - 1, seed == 0 ? 0 : random(), filling))
            return true;
        filling = before;
    }
    return false;
}

bool ExactFiller::Memory::build_parts(const Branch &branch, const std::vector<int> &ids, Budget budget,
                                      int faces, std::uint64_t seed, Filling &filling) {
    int fresh[2] = {-1, -1};
    auto id = [&](int position) {
        if (position >= 0)
            return ids[static_cast<std::size_t>(position)];
        int &vertex = fresh[-1 - position];
        if (vertex < 0)
            vertex = filling.vertices++;
        return vertex;
    };
    filling.quads.push_back({id(branch.quad[0]), id(branch.quad[1]), id(branch.quad[2]), id(branch.quad[3])});
    std::vector<std::vector<int>> part_ids;
    for (const Part &part : branch.parts) {
        part_ids.emplace_back();
        for (const int position : part.vertices)
            part_ids.back().push_back(id(position));
    }
    // One part at a time, every share of budget and faces that leaves the others solvable.
    std::function<bool(std::size_t, Budget, int)> place = [&](std::size_t i, Budget left, int remaining) {
        const Word &word = branch.parts[i].word;
        if (i + 1 == branch.parts.size())
            return build(word, part_ids[i], left, remaining, seed, filling);
        const int excess = index(word);
        for (int v3 = std::max(0, excess); v3 <= left.v3; ++v3) {
            const Budget own{v3, v3 - excess};
            if (own.v5 > left.v5)
                break;
            const Budget rest{left.v3 - own.v3, left.v5 - own.v5};
            const FaceSet here = solve(word, own, remaining - 1);
            const FaceSet there = solve_parts(branch.parts, i + 1, rest, remaining - 1);
            for (int f = 1; f < remaining; ++f) {
                if (!here[static_cast<std::size_t>(f)] || !there[static_cast<std::size_t>(remaining - f)])
                    continue;
                const Filling before = filling;
                if (build(word, part_ids[i], own, f, seed, filling) && place(i + 1, rest, remaining - f))
                    return true;
                filling = before;
            }
        }
        return false;
    };
    return place(0, budget, faces);
}

ExactFiller::ExactFiller(std::int64_t node_limit) : memory_(std::make_unique<Memory>()) {
    memory_->limit = node_limit;
}

ExactFiller::~ExactFiller() = default;

FaceSet ExactFiller::faces(const Word &word, int v3, int v5, int most) {
    const int length = static_cast<int>(word.size());
    if (length < 4 || length % 2 != 0 || v3 < 0 || v5 < 0)
        return {};
    const auto [low, high] = std::minmax_element(word.begin(), word.end());
    if (length > longest_word || *low < 1 || *high > 4 || most > most_faces)
        throw TooHard{};
    // With nine valence-3 vertices two vertices could be joined twice, which fronts do not see.
    constexpr int most_v3 = 8;
    if (v3 > most_v3 && balanced(word, {v3, v5}) && fewest_faces(word, {v3, v5}) <= most)
        throw TooHard{};
    FaceSet within; // counts remembered from a wider search do not belong to the answer
    for (int f = 0; f <= most; ++f)
        within.set(static_cast<std::size_t>(f));
    return memory_->solve(word, {v3, v5}, most) & within;
}

std::optional<Filling> ExactFiller::fill(const Word &word, int v3, int v5, int faces, std::uint64_t seed) {
    if (faces < 1 || !this->faces(word, v3, v5, faces)[static_cast<std::size_t>(faces)])
        return std::nullopt;
    Filling filling{static_cast<int>(word.size()), static_cast<int>(word.size()), {}};
    std::vector<int> ids(word.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
        ids[i] = static_cast<int>(i);
    if (!memory_->build(word, ids, {v3, v5}, faces, seed, filling))
        return std::nullopt;
    return filling;
}

std::int64_t ExactFiller::nodes() const { return memory_->nodes; }

} // namespace alphamst::fill
