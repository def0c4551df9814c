#include "fill/start.h"

#include <algorithm>
#include <array>

namespace alphamst::fill {
namespace {

constexpr std::size_t most_sides = 6;

// Chord after chord takes copies from what is left of its sides. Thousands are tried for one
// filling, so nothing here asks for memory.
class Search {
public:
    explicit Search(const Layout &type) : type_(type) { x_.fill(1); }

    std::optional<Multiplicities> run(const Sides &sides) {
        std::copy(sides.begin(), sides.end(), rest_.begin());
        for (const Layout::Turn &turn : type_.order)
            for (const Layout::Turn::End &end : turn.ends)
                if ((rest_[end.side] -= end.count) < 0)
                    return std::nullopt;
        if (!visit(0))
            return std::nullopt;
        return Multiplicities(x_.begin(), x_.begin() + type_.chords);
    }

private:
    bool visit(std::size_t position) {
        if (position == type_.order.size())
            return std::all_of(rest_.begin(), rest_.end(), [](int r) { return r == 0; });
        if (--budget_ < 0)
            return false;
        const Layout::Turn &turn = type_.order[position];
        constexpr int unknown = 1 << 20;
        int most = turn.ends.empty() ? 0 : unknown, low = 0, sharing = 1; // a cyclic chord: one copy
        for (const Layout::Turn::End &end : turn.ends) {
            const int left = rest_[end.side];
            most = std::min(most, left / end.count);
            sharing = std::max(sharing, end.later + 1);
            if (end.later == 0)
                low = std::max(low, left % end.count == 0 ? left / end.count : 2 * unknown);
        }
        const int middle = std::clamp(most / sharing, low, std::max(low, most));
        for (int step = 0; low <= most && step <= 2 * (most - low); ++step) {
            const int value = middle + (step % 2 == 0 ? step / 2 : -(step + 1) / 2);
            if (value < low || value > most)
                continue;
            change(turn, value);
            if (visit(position + 1))
                return true;
            change(turn, -value);
        }
        return false;
    }

    void change(const Layout::Turn &turn, int by) {
        x_[turn.chord] += by;
        for (const Layout::Turn::End &end : turn.ends)
            rest_[end.side] -= end.count * by;
    }

    const Layout &type_;
    std::array<int, most_chords> x_;
    std::array<int, most_sides> rest_{}; // of the sides, beyond one copy of each chord
    int budget_ = 60;
};

} // namespace

std::vector<Layout::Turn> start_order(const Layout &type) {
    const auto chords = static_cast<std::size_t>(type.chords);
    std::vector<char> used(chords, 0);
    std::vector<Layout::Turn> order;
    while (order.size() < chords) {
        // A side with few open chords is the tightest; its chords come first.
        const std::vector<int> *tightest = nullptr;
        int fewest = type.chords + 1;
        for (const std::vector<int> &side : type.incidence) {
            int open = 0;
            for (std::size_t j = 0; j < chords; ++j)
                open += !used[j] && side[j] != 0;
            if (open > 0 && open < fewest) {
                fewest = open;
                tightest = &side;
            }
        }
        for (std::size_t j = 0; j < chords; ++j)
            if (!used[j] && (tightest == nullptr || (*tightest)[j] != 0)) {
                used[j] = 1;
                order.push_back({j, {}});
            }
    }
    for (std::size_t position = 0; position < order.size(); ++position)
        for (std::size_t i = 0; i < type.incidence.size(); ++i) {
            const std::vector<int> &side = type.incidence[i];
            if (side[order[position].chord] == 0)
                continue;
            int later = 0;
            for (std::size_t p = position + 1; p < order.size(); ++p)
                later += side[order[p].chord] != 0;
            order[position].ends.push_back({i, side[order[position].chord], later});
        }
    return order;
}

std::optional<Multiplicities> start(const Layout &type, const Sides &sides) {
    return Search(type).run(sides);
}

} // namespace alphamst::fill
