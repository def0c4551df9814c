// Which ids the entities of one kind have after some go and others come.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace alphamst::mesh {

// Ids for those that come: first of those that go (ascending), then new ones.
struct Ids {
    std::vector<int> ids;
    std::vector<std::array<int, 2>> moves; // from the end of the mesh into a gap
    std::size_t during, after;             // number of entities

    Ids(const std::vector<int> &gone, std::size_t wanted, std::size_t before)
        : during(before + (wanted > gone.size() ? wanted - gone.size() : 0)),
          after(before + wanted - gone.size()) {
        const std::size_t kept = std::min(wanted, gone.size());
        ids.assign(gone.begin(), gone.begin() + static_cast<std::ptrdiff_t>(kept));
        for (std::size_t id = before; ids.size() < wanted; ++id)
            ids.push_back(static_cast<int>(id));
        // Every gap is behind every id used again, so what is new never moves.
        std::size_t last_gap = gone.size();
        for (std::size_t from = before, gap = kept; from > after; --from) {
            if (last_gap > kept && static_cast<std::size_t>(gone[last_gap - 1]) == from - 1)
                --last_gap;
            else
                moves.push_back({static_cast<int>(from - 1), gone[gap++]});
        }
    }
};

} // namespace alphamst::mesh
