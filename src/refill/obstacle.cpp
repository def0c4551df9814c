#include "refill/obstacle.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/star.h"

namespace alphamst::refill {
namespace {

constexpr std::size_t reach = 4; // steps across edges from the boundary edge

// The quad left of the edge from -> to.
const geometry::Sector *left_of(const geometry::Stars &stars, int from, int to) {
    for (const geometry::Sector &s : stars.at(from))
        if (s.next == to)
            return &s;
    return nullptr;
}

// The quads within reach of the boundary edge from `vertex`, written down so that equal pieces
// read equal: in the order met, new vertices numbered in the order met.
std::vector<int> piece_at(const geometry::Stars &stars, int boundary, int vertex) {
    struct Step {
        int from, to;
        std::size_t distance;
    };
    std::vector<int> piece{vertex}, quads, vertices;
    std::vector<Step> steps{{vertex, (vertex + 1) % boundary, 0}};
    auto name = [&](int v) {
        if (v < boundary)
            return v;
        const auto at = std::find(vertices.begin(), vertices.end(), v);
        const int number = boundary + static_cast<int>(at - vertices.begin());
        if (at == vertices.end())
            vertices.push_back(v);
        return number;
    };
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Step step = steps[i];
        const geometry::Sector *s = left_of(stars, step.from, step.to);
        if (!s || std::find(quads.begin(), quads.end(), s->quad) != quads.end())
            continue;
        quads.push_back(s->quad);
        const int corners[] = {step.from, s->next, s->opposite, s->previous};
        for (const int v : corners)
            piece.push_back(name(v));
        if (step.distance < reach)
            for (std::size_t k = 1; k < 4; ++k)
                steps.push_back({corners[(k + 1) % 4], corners[k], step.distance + 1});
    }
    return piece;
}

} // namespace

void Obstacles::learn(const fill::Filling &filling, int quad) {
    const geometry::Stars stars(filling.quads, filling.vertices);
    const auto &corners = filling.quads[static_cast<std::size_t>(quad)];
    std::vector<int> near(corners.begin(), corners.end());
    for (const int v : corners)
        for (const geometry::Sector &s : stars.at(v))
            near.insert(near.end(), {s.next, s.opposite, s.previous});
    const auto found = std::find_if(near.begin(), near.end(), [&](int v) { return v < filling.boundary; });
    if (found != near.end())
        pieces_.insert(piece_at(stars, filling.boundary, *found));
}

bool Obstacles::met_by(const fill::Filling &filling) const {
    if (pieces_.empty())
        return false;
    const geometry::Stars stars(filling.quads, filling.vertices);
    return std::any_of(pieces_.begin(), pieces_.end(), [&](const std::vector<int> &piece) {
        return piece_at(stars, filling.boundary, piece.front()) == piece;
    });
}

} // namespace alphamst::refill
