// How far every node of a dual graph is from the nearest of some sources, where sources come
// in one after another: each floods only the nodes that are nearer to it.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "patch/decompose.h"

namespace alphamst::patch {

class Flood {
public:
    using Start = std::tuple<double, std::size_t, std::size_t>; // distance, node, source

    explicit Flood(const FaceDual &dual, const Pace &pace = {})
        : dual_(dual), pace_(pace), distance_(dual.size(), std::numeric_limits<double>::infinity()),
          source_(dual.size(), 0) {}

    double distance(std::size_t node) const { return distance_[node]; }
    std::size_t source(std::size_t node) const { return source_[node]; }

    // measure(node, next, source): how far `next` is from a source that reached it from `node`.
    template <class Measure> void add(std::span<const Start> starts, Measure measure) {
        std::priority_queue<Start, std::vector<Start>, std::greater<>> front;
        const auto reach = [&](double distance, std::size_t node, std::size_t source) {
            if (!(distance < distance_[node]))
                return;
            distance_[node] = distance;
            source_[node] = source;
            front.push({distance, node, source});
            far_.push({distance, ~node});
        };
        for (const auto &[distance, node, source] : starts)
            reach(distance, node, source);
        while (!front.empty()) {
            const auto [distance, node, source] = front.top();
            front.pop();
            pace_.step();
            if (distance > distance_[node] || source != source_[node])
                continue;
            for (const std::int32_t link : dual_.neighbours(node)) {
                const auto next = static_cast<std::size_t>(link);
                reach(measure(node, next, source), next, source);
            }
        }
    }

    // No source comes nearer to this node, nor past it.
    void close(std::size_t node) { distance_[node] = 0; }

    // The node that is farthest from all sources, the first of equals; each node once for
    // every distance it had. None when all were told.
    std::optional<std::size_t> farthest() {
        while (!far_.empty()) {
            const auto [distance, mirrored] = far_.top();
            far_.pop();
            if (distance == distance_[~mirrored])
                return ~mirrored;
        }
        return std::nullopt;
    }

private:
    const FaceDual &dual_;
    Pace pace_;
    std::vector<double> distance_;
    std::vector<std::size_t> source_;
    std::priority_queue<std::pair<double, std::size_t>> far_; // distances only fall: these are bounds
};

} // namespace alphamst::patch
