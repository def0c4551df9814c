#include "io/msh_groups.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>

#include "io/markers.h"
#include "io/number.h"

namespace alphamst::io {

std::int32_t small_tag(const Scanner &at, std::int64_t tag) {
    if (tag < std::numeric_limits<std::int32_t>::min() || tag > std::numeric_limits<std::int32_t>::max())
        at.fail(Fault::unsupported, "the tag " + std::to_string(tag) + " does not fit in 32 bits");
    return static_cast<std::int32_t>(tag);
}

// dimension, number, "name". Version 2.0 has no dimension, so that nobody knows whose name it is.
void PhysicalGroups::read_names(Scanner &scan) {
    const std::int64_t n = scan.count("names", 4);
    scan.line();
    for (std::int64_t i = 0; i < n; ++i) {
        const std::int64_t dim = scan.integer();
        const std::string_view line = scan.line();
        const std::size_t open = line.find('"'), close = line.rfind('"');
        if (open == std::string_view::npos || close == open)
            scan.malformed("the name of a physical group is not in quotes: " + quoted(line));
        const std::size_t begin = line.find_first_not_of(" \t"), end = line.find_last_not_of(" \t", open - 1);
        if (begin == open)
            continue;
        std::int64_t tag = 0;
        if (parse(line.substr(begin, end + 1 - begin), tag) != Parsed::number)
            scan.malformed("found " + quoted(line) +
                           " in place of the number and the name of a physical group");
        if (dim >= 0 && dim <= 2 && tag != 0 && close > open + 1)
            names_[{static_cast<Entity>(dim), small_tag(scan, tag)}] =
                clean_name(line.substr(open + 1, close - open - 1));
    }
}

// Behind the coordinates, or those of the box. Then, except of points, what bounds the entity.
std::vector<std::int32_t> PhysicalGroups::read_groups(MshNumbers &from, int dim) {
    for (int k = dim == 0 && !points_have_boxes ? 3 : 6; k > 0; --k)
        from.real();
    std::vector<std::int32_t> groups;
    const std::int64_t n = from.count("physical tags", 2, 4);
    for (std::int64_t i = 0; i < n; ++i) {
        // The sign of a physical tag is an orientation.
        constexpr std::int64_t least = -std::numeric_limits<std::int32_t>::max();
        if (const std::int32_t tag = std::abs(small_tag(from.scan(), std::max(from.integer(), least)));
            tag != 0)
            groups.push_back(tag);
    }
    if (from.binary() && dim > 0)
        for (std::int64_t left = from.count("bounds", 2, 4); left > 0; --left)
            from.integer();
    from.end_line();
    return groups;
}

void PhysicalGroups::read_entities(MshNumbers &from) {
    from.begin();
    std::array<std::int64_t, 4> n{};
    for (std::int64_t &count : n)
        count = from.count("entities", 8, 36);
    for (int dim = 0; dim < 4; ++dim)
        for (std::int64_t i = 0; i < n[static_cast<std::size_t>(dim)]; ++i) {
            const std::int64_t tag = from.integer();
            groups_[{dim, tag}] = read_groups(from, dim);
        }
}

void PhysicalGroups::read_partitions(MshNumbers &from) {
    partitioned_ = true;
    from.begin();
    from.long_integer(); // the number of parts
    const std::int64_t n_ghosts = from.count("ghost entities", 4, 8);
    for (std::int64_t i = 0; i < 2 * n_ghosts; ++i)
        from.integer();
    std::array<std::int64_t, 4> n{};
    for (std::int64_t &count : n)
        count = from.count("entities of parts", 8, 52);
    for (int dim = 0; dim < 4; ++dim)
        for (std::int64_t i = 0; i < n[static_cast<std::size_t>(dim)]; ++i) {
            const Key part{dim, from.integer()};
            const std::int64_t parent_dim = from.integer(), parent = from.integer();
            const std::int64_t n_parts = from.count("parts", 2, 4);
            for (std::int64_t k = 0; k < n_parts; ++k)
                from.integer();
            const std::vector<std::int32_t> own = read_groups(from, dim);
            parents_[part] = {parent_dim, parent};
            if (parent_dim == dim && !groups_.contains({parent_dim, parent}))
                groups_[{parent_dim, parent}] = own; // the file has parts alone
        }
}

Names PhysicalGroups::names() const {
    if (!partitioned_)
        return names_;
    std::set<std::pair<Entity, std::int32_t>> whole;
    for (const auto &[entity, groups] : groups_)
        for (const std::int32_t group : groups)
            whole.insert({static_cast<Entity>(entity.first), group});
    Names names = names_;
    std::erase_if(names, [&](const auto &name) { return !whole.contains(name.first); });
    return names;
}

std::vector<std::int32_t> PhysicalGroups::of(std::int64_t dim, std::int64_t entity) const {
    const auto part = parents_.find({dim, entity});
    if (part != parents_.end() && part->second.first != dim)
        return {}; // a border between parts
    const auto found = groups_.find(part == parents_.end() ? Key{dim, entity} : part->second);
    return found == groups_.end() ? std::vector<std::int32_t>() : found->second;
}

std::int64_t PhysicalGroups::whole_curve(std::int64_t entity) const {
    const auto part = parents_.find({1, entity});
    if (part == parents_.end())
        return entity;
    return part->second.first == 1 ? part->second.second : 0;
}

} // namespace alphamst::io
