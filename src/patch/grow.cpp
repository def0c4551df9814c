#include "patch/grow.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "index.h"
#include "patch/region.h"

namespace alphamst::patch {
namespace {

OpenMesh::Vec3d middle(const mesh::QuadMesh &mesh, int face) {
    OpenMesh::Vec3d sum(0, 0, 0);
    for (const int v : mesh.corners(face))
        sum += mesh.point(v);
    return sum / 4.0;
}

// Squared distance of p in the metric of the plan.
double distance(const mesh::QuadMesh &mesh, const GrowthPlan &plan, double cosine, double sine,
                const OpenMesh::Vec3d &p) {
    const OpenMesh::Vec3d away = p - mesh.point(plan.start);
    if (plan.nearness == Nearness::path) {
        const OpenMesh::Vec3d along = mesh.point(plan.other) - mesh.point(plan.start);
        const double length = along.sqrnorm();
        const double t = length > 0 ? std::clamp((away | along) / length, 0.0, 1.0) : 0.0;
        return (away - along * t).sqrnorm();
    }
    if (plan.nearness == Nearness::ellipse) {
        constexpr double slenderness = 2.5;
        const double along = away[0] * cosine + away[1] * sine;
        return away.sqrnorm() - along * along * (1 - 1 / (slenderness * slenderness));
    }
    return away.sqrnorm();
}

} // namespace

void Growth::begin() {
    face_mark_.resize(std::max(face_mark_.size(), at(mesh_.n_faces())), 0);
    vertex_mark_.resize(std::max(vertex_mark_.size(), at(mesh_.n_vertices())), 0);
    ++epoch_;
    faces_.clear();
}

void Growth::add(int face) {
    face_mark_[at(face)] = epoch_;
    for (const int v : mesh_.corners(face))
        vertex_mark_[at(v)] = epoch_;
    faces_.push_back(face);
}

// A disk and a face make a disk if they meet in one path of 1 to 3 edges and nowhere else; the
// vertices within the path come to lie inside.
bool Growth::fits(int face) const {
    if ((mesh_.face_flags[at(face)] & mesh::fixed) != 0)
        return false;
    if (faces_.empty())
        return true;
    const auto edges = halfedges_of(mesh_, face);
    int shared = 0, starts = 0, touched = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const bool here = in(right(mesh_, edges[k])), before = in(right(mesh_, edges[(k + 3) % 4]));
        const int corner = from(mesh_, edges[k]);
        if (here && barrier(mesh_, edges[k]))
            return false;
        if (here && before && held(mesh_, corner))
            return false;
        shared += here;
        starts += here && !before;
        touched += vertex_mark_[at(corner)] == epoch_;
    }
    return starts == 1 && touched == shared + 1;
}

// Faces with two or more sides on the disk would be corners that turn inwards.
void Growth::fill_corners(std::size_t most) {
    for (std::size_t i = 0; i < faces_.size(); ++i)
        for (const int next : mesh_.neighbours(faces_[i])) {
            if (next < 0 || in(next) || faces_.size() >= most)
                continue;
            int sides = 0;
            for (const int other : mesh_.neighbours(next))
                sides += in(other);
            if (sides >= 2 && fits(next))
                add(next);
        }
}

std::vector<int> Growth::disk(const GrowthPlan &plan) {
    begin();
    using Step = std::tuple<int, double, int>; // steps across edges, distance, face
    std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
    const double cosine = std::cos(plan.direction), sine = std::sin(plan.direction);
    const bool by_steps = plan.nearness == Nearness::rings;
    auto offer = [&](int steps, int face) {
        front.push({by_steps ? steps : 0, distance(mesh_, plan, cosine, sine, middle(mesh_, face)), face});
    };
    for (const int f : mesh_.faces_around(plan.start))
        offer(0, f);
    while (!front.empty() && static_cast<int>(faces_.size()) < plan.most) {
        const auto [steps, away, face] = front.top();
        front.pop();
        if (in(face) || !fits(face))
            continue;
        add(face);
        for (const int next : mesh_.neighbours(face))
            if (next >= 0 && !in(next))
                offer(steps + 1, next);
    }
    fill_corners(at(plan.most) + at(plan.most) / 2);
    std::vector<int> disk = faces_;
    std::sort(disk.begin(), disk.end());
    return disk;
}

std::vector<int> Growth::surround(const std::vector<int> &faces, int layers) {
    begin();
    for (const int f : faces)
        if (!in(f)) {
            face_mark_[at(f)] = epoch_;
            faces_.push_back(f);
        }
    std::size_t first = 0;
    for (int layer = 0; layer < layers; ++layer) {
        const std::size_t last = faces_.size();
        for (std::size_t i = first; i < last; ++i)
            for (const int v : mesh_.corners(faces_[i])) {
                if (vertex_mark_[at(v)] == epoch_)
                    continue; // its faces are here
                vertex_mark_[at(v)] = epoch_;
                for (const int f : mesh_.faces_around(v))
                    if (!in(f)) {
                        face_mark_[at(f)] = epoch_;
                        faces_.push_back(f);
                    }
            }
        first = last;
    }
    return faces_;
}

} // namespace alphamst::patch
