// The groups of a file of Gmsh: which numbers the entities of its model have, and what they are called.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "io/msh_numbers.h"
#include "io/scanner.h"
#include "names.h"

namespace alphamst::io {

// Each read_ begins behind the word that opens its section and ends before the one that closes it.
class PhysicalGroups {
public:
    void read_names(Scanner &scan);
    void read_entities(MshNumbers &from);   // of MSH 4
    void read_partitions(MshNumbers &from); // of MSH 4: parts of those entities, and borders between them

    bool points_have_boxes = false; // in version 4.0, as other entities have; later they have coordinates

    // Of points, lines and faces. Of a partitioned mesh without those that Gmsh makes up for its parts.
    Names names() const;
    // The physical groups that an entity is in; a part is in those of the whole.
    std::vector<std::int32_t> of(std::int64_t dim, std::int64_t entity) const;
    // The curve that this one is part of; 0: it is a border between parts.
    std::int64_t whole_curve(std::int64_t entity) const;

private:
    using Key = std::pair<std::int64_t, std::int64_t>; // dimension and tag

    std::vector<std::int32_t> read_groups(MshNumbers &from, int dim);

    std::map<Key, std::vector<std::int32_t>> groups_;
    std::map<Key, Key> parents_;
    Names names_;
    bool partitioned_ = false;
};

// A tag as it is kept. Failure (unsupported) if it is too large.
std::int32_t small_tag(const Scanner &at, std::int64_t tag);

} // namespace alphamst::io
