// Which filling to take: every way the library knows to fill a boundary word with a wanted
// number of faces, by the numbers alone, best first.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "fill/filling.h"

namespace alphamst::fill {

struct Request {
    Word word;                  // letters that the mesh around and the boundary's shape want
    std::vector<int> regular;   // [word] letter that makes the vertex regular; 0: none counts
    std::vector<double> angles; // [word] interior angle in degrees; empty: combinatorics only
    double least_sine = 0;      // of the angle that each face at a boundary vertex gets
    std::int64_t faces = 0;     // wanted
    bool any_count = false;     // fewest irregular vertices first, faces only as near as possible
    std::int64_t fewest = 0;    // any_count: faces in this range; 0: from half to twice as many
    std::int64_t most_faces = 0;
    std::int64_t tolerance = 2; // largest miss that is still offered when the count is not free
    int fewer_than = 1 << 20;   // irregular vertices
    int most = 16;              // candidates
    std::int64_t node_limit = 1000;
    std::uint64_t seed = 0;
};

struct Candidate {
    std::int64_t faces = 0;
    int singularities = 0; // irregular vertices: singular ones inside, boundary ones with another letter
    double stretch = 0;    // among equal numbers: larger is likely to be less well shaped
    std::function<Filling()> build;
};

// Groups of candidates, made as they are asked for: exact face count first, then fewest
// irregular vertices (any_count: the other way round); within a group the likely best shape first.
class Plan {
public:
    explicit Plan(Request request);
    ~Plan();
    Plan(Plan &&) noexcept;

    // Empty when nothing more is known.
    std::vector<Candidate> next();

private:
    class Search;
    std::unique_ptr<Search> search_;
};

// The first candidates of all groups, request.most of them.
std::vector<Candidate> plan(const Request &request);

} // namespace alphamst::fill
