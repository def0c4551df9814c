#include "fill/library.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <mutex>
#include <numeric>

#include "fill/closed_form.h"
#include "fill/exact.h"
#include "fill/start.h"

namespace alphamst::fill {
namespace {

// The polygons whose fillings are searched for one (N, k).
struct Sample {
    int sides, singularities;
    int shortest, longest, perimeter; // bounds on side lengths and their sum
    int faces;                        // largest face count
    int counts;                       // face counts taken from each polygon
    int seeds;                        // fillings taken of each count
};

// Wider ranges were found to add no type with up to three singularities; of the richer families
// these hold those with few chords.
constexpr std::array samples{
    Sample{1, 3, 6, 12, 12, 40, 40, 2}, Sample{2, 2, 3, 6, 12, 40, 40, 2}, Sample{2, 4, 2, 8, 14, 40, 8, 1},
    Sample{3, 1, 2, 4, 10, 30, 4, 1},   Sample{3, 3, 2, 8, 16, 50, 40, 2}, Sample{4, 0, 1, 2, 4, 4, 1, 1},
    Sample{4, 2, 2, 5, 16, 40, 40, 2},  Sample{4, 4, 2, 7, 18, 36, 40, 1}, Sample{5, 1, 2, 3, 12, 30, 4, 1},
    Sample{5, 3, 2, 6, 20, 45, 40, 2},  Sample{5, 5, 2, 9, 18, 36, 2, 1},  Sample{6, 2, 2, 4, 18, 45, 40, 2},
    Sample{6, 4, 2, 9, 22, 40, 2, 1},   Sample{6, 6, 2, 9, 20, 34, 2, 1},
};

Word polygon_word(const Sides &sides) {
    Word word;
    for (const int n : sides) {
        word.push_back(1);
        word.insert(word.end(), static_cast<std::size_t>(n - 1), 2);
    }
    return word;
}

std::vector<int> polygon_corners(const Sides &sides) {
    std::vector<int> corners{0};
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
        corners.push_back(corners.back() + sides[i]);
    return corners;
}

// No rotation or reflection of the sides is lexicographically larger.
bool canonical(const Sides &sides) {
    Sides turned = sides;
    for (int mirror = 0; mirror < 2; ++mirror, std::reverse(turned.begin(), turned.end()))
        for (std::size_t i = 0; i < sides.size(); ++i) {
            std::rotate(turned.begin(), turned.begin() + 1, turned.end());
            if (turned > sides)
                return false;
        }
    return true;
}

// Small integer vectors z with incidence z = 0, shortest first: steps between
// multiplicities of equal side lengths.
std::vector<Move> moves_of(const Layout &layout) {
    const auto chords = static_cast<std::size_t>(layout.chords);
    const int reach = layout.chords - layout.sides > 6 ? 1 : 2;
    // What the chords from one on can still add to a side.
    std::vector<std::vector<int>> later(layout.incidence.size(), std::vector<int>(chords + 1, 0));
    for (std::size_t i = 0; i < later.size(); ++i)
        for (std::size_t j = chords; j-- > 0;)
            later[i][j] = later[i][j + 1] + reach * layout.incidence[i][j];
    std::vector<Multiplicities> moves;
    Multiplicities z(chords, 0);
    std::vector<int> sum(layout.incidence.size(), 0);
    auto visit = [&](auto &self, std::size_t j) -> void {
        if (j == chords) {
            const auto first = std::find_if(z.begin(), z.end(), [](int a) { return a != 0; });
            if (first != z.end() && *first > 0)
                moves.push_back(z);
            return;
        }
        for (int value = -reach; value <= reach; ++value) {
            bool open = true;
            for (std::size_t i = 0; i < sum.size(); ++i)
                open = open && std::abs(sum[i] + layout.incidence[i][j] * value) <= later[i][j + 1];
            if (!open)
                continue;
            z[j] = value;
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += layout.incidence[i][j] * value;
            self(self, j + 1);
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] -= layout.incidence[i][j] * value;
        }
        z[j] = 0;
    };
    visit(visit, 0);
    auto length = [](const Multiplicities &m) {
        return std::inner_product(m.begin(), m.end(), m.begin(), 0);
    };
    std::stable_sort(moves.begin(), moves.end(),
                     [&](const auto &a, const auto &b) { return length(a) < length(b); });
    constexpr std::size_t kept = 48;
    if (moves.size() > kept)
        moves.resize(kept);
    std::vector<Move> result;
    for (const Multiplicities &move : moves)
        result.emplace_back(move, layout.product);
    return result;
}

std::vector<Layout> generate(const Sample &sample) {
    std::map<std::vector<int>, Layout> found;
    const int index = 4 - sample.sides;
    const int v3 = (sample.singularities + index) / 2, v5 = (sample.singularities - index) / 2;
    Sides sides(static_cast<std::size_t>(sample.sides), sample.shortest);
    ExactFiller filler(100000000); // one for all: what they share is searched once
    auto search = [&] {
        const int perimeter = std::accumulate(sides.begin(), sides.end(), 0);
        if (perimeter % 2 != 0 || perimeter > sample.perimeter || !canonical(sides))
            return;
        const Word word = polygon_word(sides);
        const FaceSet counts = filler.faces(word, v3, v5, sample.faces);
        int taken = 0;
        for (int f = 1; f <= sample.faces && taken < sample.counts; ++f) {
            if (!counts[static_cast<std::size_t>(f)])
                continue;
            ++taken;
            for (int seed = 0; seed < sample.seeds; ++seed) {
                const auto filling = filler.fill(word, v3, v5, f, static_cast<std::uint64_t>(seed));
                Layout layout = extract(*filling, polygon_corners(sides));
                found.emplace(signature(layout), std::move(layout));
            }
        }
    };
    for (bool more = true; more;) {
        search();
        std::size_t i = sides.size();
        while (i > 0 && sides[i - 1] == sample.longest)
            sides[--i] = sample.shortest;
        more = i > 0;
        if (more)
            ++sides[i - 1];
    }
    std::vector<Layout> layouts;
    for (auto &[key, layout] : found) {
        if (layout.chords > static_cast<int>(most_chords))
            continue;
        layout.order = start_order(layout);
        layout.moves = moves_of(layout);
        layouts.push_back(std::move(layout));
    }
    // Types with more chords are more general; the others are their limits.
    std::stable_sort(layouts.begin(), layouts.end(),
                     [](const Layout &a, const Layout &b) { return a.chords > b.chords; });
    return layouts;
}

std::size_t sample_of(int sides, int singularities) {
    std::size_t i = 0;
    while (i < samples.size() && (samples[i].sides != sides || samples[i].singularities != singularities))
        ++i;
    return i;
}

} // namespace

bool has_types(int sides, int singularities) { return sample_of(sides, singularities) < samples.size(); }

const std::vector<Layout> &types(int sides, int singularities) {
    static std::array<std::once_flag, samples.size()> once;
    static std::array<std::vector<Layout>, samples.size()> made;
    static const std::vector<Layout> none;
    const std::size_t i = sample_of(sides, singularities);
    if (i == samples.size())
        return none;
    std::call_once(once[i], [&] { made[i] = generate(samples[i]); });
    return made[i];
}

} // namespace alphamst::fill
