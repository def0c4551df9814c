// Nodes or elements by the numbers that a file gives them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace alphamst::io {

// May be sparse and in any order. What was added first is number 0.
class Tags {
public:
    void add(std::int64_t tag) {
        const auto number = static_cast<std::int32_t>(tags_.size());
        ascending_ = ascending_ && (tags_.empty() || tags_.back().first < tag);
        tags_.emplace_back(tag, number);
    }
    // Returns false if a tag comes twice.
    bool close() {
        if (!ascending_)
            std::sort(tags_.begin(), tags_.end());
        return std::adjacent_find(tags_.begin(), tags_.end(), [](const auto &a, const auto &b) {
                   return a.first == b.first;
               }) == tags_.end();
    }
    std::int32_t find(std::int64_t tag) const {
        // Tags 1, 2, 3, ... are the rule.
        const auto size = static_cast<std::int64_t>(tags_.size());
        if (tag >= 1 && tag <= size && tags_[static_cast<std::size_t>(tag - 1)].first == tag)
            return tags_[static_cast<std::size_t>(tag - 1)].second;
        const auto at = std::lower_bound(tags_.begin(), tags_.end(), std::pair{tag, std::int32_t{-1}});
        return at != tags_.end() && at->first == tag ? at->second : -1;
    }

    std::size_t size() const { return tags_.size(); }
    // Those from first to last, each with its number.
    std::span<const std::pair<std::int64_t, std::int32_t>> between(std::int64_t first,
                                                                   std::int64_t last) const {
        const auto begin =
            std::ranges::lower_bound(tags_, first, {}, &std::pair<std::int64_t, std::int32_t>::first);
        const auto end =
            std::ranges::upper_bound(tags_, last, {}, &std::pair<std::int64_t, std::int32_t>::first);
        return {begin, std::max(begin, end)};
    }
    std::int64_t tag_of(std::int32_t number) const {
        return std::ranges::find(tags_, number, &std::pair<std::int64_t, std::int32_t>::second)->first;
    }

private:
    std::vector<std::pair<std::int64_t, std::int32_t>> tags_;
    bool ascending_ = true;
};

} // namespace alphamst::io
