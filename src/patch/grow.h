// Disks of faces grown around a place, face by face: windows for operations that choose
// where to work themselves.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/quad_mesh.h"

namespace alphamst::patch {

// How near a face is: what is nearest joins first.
enum class Nearness {
    ball,    // distance to the start
    rings,   // number of steps across edges
    path,    // distance to the segment from the start to another vertex
    ellipse, // distance to the start, one direction counting less
};

struct GrowthPlan {
    int start = 0; // a vertex
    int most = 0;  // faces
    Nearness nearness = Nearness::ball;
    int other = -1;       // path: the vertex at its end
    double direction = 0; // ellipse: angle of the long axis in the xy-plane
};

// Grows one disk after another on a mesh that may change in between. Costs O(disk log disk).
class Growth {
public:
    explicit Growth(const mesh::QuadMesh &mesh) : mesh_(mesh) {}

    // Ascending faces of a disk without flagged or marked entities inside; corners between
    // two faces of the disk are filled up at the end.
    std::vector<int> disk(const GrowthPlan &plan);

    // The faces with a vertex in common with these, and so on; with the faces themselves.
    std::vector<int> surround(const std::vector<int> &faces, int layers);

private:
    bool in(int face) const { return face >= 0 && face_mark_[static_cast<std::size_t>(face)] == epoch_; }
    bool fits(int face) const;
    void add(int face);
    void begin();
    void fill_corners(std::size_t most);

    const mesh::QuadMesh &mesh_;
    std::vector<int> face_mark_, vertex_mark_;
    int epoch_ = 0;
    std::vector<int> faces_;
};

} // namespace alphamst::patch
