// Work on many things that do not depend on each other, in pieces that make up for a change of thread.
#pragma once

#include <algorithm>
#include <cstddef>

#include "geometry/embed.h"

namespace alphamst::geometry {

// Calls work(i) for each i < n, by `run` if there is one; see EmbedOptions.
template <class Work> void in_pieces(std::size_t n, const Run &run, const Work &work) {
    constexpr std::size_t piece = 256;
    const auto look = [&](std::size_t i) {
        for (std::size_t k = i * piece; k < std::min(n, (i + 1) * piece); ++k)
            work(k);
    };
    const std::size_t pieces = (n + piece - 1) / piece;
    if (run)
        run(pieces, look);
    else
        for (std::size_t i = 0; i < pieces; ++i)
            look(i);
}

} // namespace alphamst::geometry
