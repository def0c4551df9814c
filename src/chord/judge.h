// Whether a chord may be collapsed or split, and what comes of it: known before anything is done.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "chord/trace.h"
#include "disjoint_sets.h"
#include "failure.h"

namespace alphamst::chord {

// Why not. Bits, equal to those of enum amst_refusal.
enum Reason : std::int32_t {
    crosses_itself = 1, // a face would be crushed to a point
    closes_up = 2,      // its edges join to a ring, or no face would be left beside it
    at_boundary = 4,    // an edge between two boundary vertices, or one that may not be changed
    is_fixed = 8,       // a FIXED entity would go or move
    at_feature = 16,    // two curves, or two corners of one, would be merged
    bad_valence = 32,   // a vertex would get a valence below 3 (a doublet) or above 6
    doubles_edge = 64   // two edges would have the same vertices, or a face one twice
};

struct Rules {
    bool boundary = false; // the mesh boundary may be changed, and features lose vertices
    double straight = 30;  // degrees they may turn at a vertex that goes
    // If given, features lose just the vertices for which it holds, whatever they turn there.
    std::function<bool(const mesh::QuadMesh &mesh, int vertex)> spared = nullptr;
};

// Vertices that become one.
struct Group {
    int survivor = -1;
    bool held = false; // the survivor stays where it is; else it goes to the mean of all
    std::vector<int> others;
};

struct Verdict {
    std::int32_t reasons = 0; // 0: allowed
    Entity entity = Entity::none;
    int where = -1; // a place of the first reason found
    Reason first = crosses_itself;

    void refuse(Reason reason, Entity kind, int place) {
        if (reasons == 0) {
            entity = kind;
            where = place;
            first = reason;
        }
        reasons |= reason;
    }
    // The first reason found, as the end of a sentence; {} stands for its place.
    std::string text() const;
};

struct Collapse : Verdict {
    std::vector<Group> groups;
    int singular_change = 0; // of the mesh, if allowed
};

// Cutting it into copies + 1 chords side by side changes no valence of a vertex that is there.
Verdict judge_split(const mesh::QuadMesh &mesh, const Chord &chord, const Rules &rules);
std::int64_t faces_added(const Chord &chord, int copies);

// Judges collapses on one mesh, one after the other; the mesh may shrink in between.
class Judge {
public:
    Judge(const mesh::QuadMesh &mesh, const Rules &rules);

    // Merging the two ends of every edge of the chord. What is allowed leaves a manifold of quads
    // with four vertices each and no two edges between the same vertices, has as many faces less as
    // the chord is long and singular_change more singular vertices. Costs O(length log length).
    Collapse operator()(const Chord &chord);

private:
    struct Count { // of a group
        int edges = 0, boundary_edges = 0, curve_edges = 0;
    };

    void merge(const Chord &chord, Collapse &result);
    void glue(const Chord &chord, Collapse &result);
    std::vector<Count> gather(const Chord &chord, Collapse &result);
    void accept_or_roll_back(Group &group, const Count &count, Collapse &result) const;
    void test_curves(Group &group, const Count &count, Collapse &result) const;
    void test_surroundings(const Group &group, Collapse &result);
    void clear(const Chord &chord);

    const mesh::QuadMesh &mesh_;
    const Rules rules_;
    // Workspace, as at the start between two calls.
    DisjointSets vertices_, edges_;      // merged, glued
    std::vector<int> group_;             // [vertex, stands for others] of result.groups, else -1
    std::vector<char> crossed_, passed_; // [edge], [face] of the chord
    std::vector<char> outside_;          // [edge, stands for others] a face beyond the glued rails
    std::vector<std::array<int, 2>> neighbours_;
};

} // namespace alphamst::chord
