// Patches that go on through commits: their faces and corners by names that stay.
#pragma once

#include <vector>

#include "mesh/renumbered.h"
#include "refill/evaluate.h"

namespace alphamst::adapt {

class Followed {
public:
    // patches: those that are refilled. around: others that only go along; a patch may lie within one of
    // them.
    Followed(const mesh::QuadMesh &mesh, const std::vector<Patch> &patches, const std::vector<Patch> &around);

    Patch now(std::size_t patch) const;
    // All that go along; of each the faces that were there first, in the order they were given, then new
    // ones.
    std::vector<Patch> around() const;

    // The patch was refilled. replacement: in the numbers of the mesh just before.
    void follow(std::size_t patch, const refill::Replacement &replacement,
                const mesh::QuadMesh::Replaced &replaced);

private:
    Patch now(Patch names) const;

    mesh::Renumbered faces_, vertices_;
    std::vector<Patch> names_, around_;
    std::vector<int> owner_; // [name of a face] place in around_, or -1
};

} // namespace alphamst::adapt
