// The sets and surfaces of an Abaqus input, which become markers.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/arrays.h"
#include "io/tags.h"

namespace alphamst::io {

class InputSets {
public:
    enum class Kind { nodes, elements, sides };
    struct Range { // of numbers in the file
        std::int64_t first, last, step;
    };
    struct Side {
        std::string set;      // of elements, or "":
        std::int64_t tag = 0; // this one
        int side = -1;        // from corner to corner; -1: all of the face
    };
    struct Set {
        std::string name;
        Kind kind;
        std::vector<Range> ranges;
        std::vector<std::string> sets; // that are part of it
        std::vector<Side> sides;
    };
    struct Element {
        std::array<std::int32_t, 4> vertices; // the last of a triangle -1
        std::int32_t face;                    // -1: a line
    };

    // A new one if there is none of that name, in either case of letters.
    Set &named(std::string_view name, Kind kind);

    // The k-th set is number k of its faces and lines, of its sides, or of its nodes: of one node a point, of
    // several, but not all, the edges of the boundary between them. Of several sets the first counts. Adds to
    // mesh.remarks.
    void add_markers(const Tags &nodes, const Tags &elements, const std::vector<Element> &of_elements,
                     Arrays &mesh) const;

private:
    class Adder;

    const Set *find(std::string_view name, Kind kind) const;
    std::vector<bool> members(const Set &set, const Tags &tags, std::int64_t &missing) const;

    std::deque<Set> sets_; // stay where they are
};

} // namespace alphamst::io
