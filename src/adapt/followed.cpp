#include "adapt/followed.h"

#include "index.h"

namespace alphamst::adapt {

Followed::Followed(const mesh::QuadMesh &mesh, const std::vector<Patch> &patches,
                   const std::vector<Patch> &around)
    : faces_(mesh.n_faces()), vertices_(mesh.n_vertices()), names_(patches), around_(around) {
    if (around_.empty())
        return;
    owner_.assign(at(mesh.n_faces()), -1);
    for (std::size_t p = 0; p < around_.size(); ++p)
        for (const int f : around_[p].faces)
            owner_[at(f)] = static_cast<int>(p);
}

Patch Followed::now(Patch names) const {
    for (int &f : names.faces)
        f = faces_.now(f);
    for (int &v : names.corners)
        v = vertices_.now(v);
    return names;
}

Patch Followed::now(std::size_t patch) const { return now(names_[patch]); }

std::vector<Patch> Followed::around() const {
    std::vector<Patch> patches;
    for (Patch names : around_) {
        std::erase_if(names.faces, [&](int name) { return faces_.now(name) < 0; });
        patches.push_back(now(std::move(names)));
    }
    return patches;
}

void Followed::follow(std::size_t patch, const refill::Replacement &replacement,
                      const mesh::QuadMesh::Replaced &replaced) {
    const int owner = owner_.empty() ? -1 : owner_[at(names_[patch].faces.front())];
    for (const int f : replacement.window.faces)
        faces_.remove(f);
    for (const int v : replacement.window.interior)
        vertices_.remove(v);
    names_[patch].faces.clear();
    for (const int f : replaced.faces) {
        names_[patch].faces.push_back(faces_.add(f));
        if (owner_.empty())
            continue;
        owner_.push_back(owner);
        if (owner >= 0)
            around_[at(owner)].faces.push_back(names_[patch].faces.back());
    }
    for (const int v : replaced.vertices)
        vertices_.add(v);
    for (const auto &[from, to] : replaced.moved_faces)
        faces_.move(from, to);
    for (const auto &[from, to] : replaced.moved_vertices)
        vertices_.move(from, to);
}

} // namespace alphamst::adapt
