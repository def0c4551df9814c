#include "adapt/mend_sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "index.h"
#include "reference/size_error.h"
#include "reference/sizing_field.h"
#include "run.h"

namespace alphamst::adapt {
namespace {

// A square of 16 by 16 faces whose middle 4 by 4 faces are a web instead: rings around four faces.
mesh::QuadMesh web(int rings) {
    mesh::QuadMesh mesh = samples::grid(16, 16);
    const std::vector<int> faces = samples::block(16, 6, 6, 10, 10);
    const patch::Window window = patch::make_window(mesh, faces);
    const int n = static_cast<int>(window.loop.size());
    const OpenMesh::Vec3d middle(8, 8, 0);
    std::vector<std::array<int, 4>> quads;
    std::vector<OpenMesh::Vec3d> points;
    for (int k = 0; k < rings; ++k)
        for (int i = 0; i < n; ++i) {
            quads.push_back({k * n + i, k * n + (i + 1) % n, (k + 1) * n + (i + 1) % n, (k + 1) * n + i});
            points.push_back(middle + (mesh.point(window.loop[at(i)]) - middle) * std::pow(0.6, k + 1));
        }
    // The core: the same 4 by 4 faces, shrunk.
    const auto core = [&](int v) {
        const auto found = std::find(window.loop.begin(), window.loop.end(), v);
        return found != window.loop.end() ? rings * n + static_cast<int>(found - window.loop.begin()) : -1;
    };
    std::map<int, int> inside;
    for (const int f : faces) {
        std::array<int, 4> quad = mesh.corners(f);
        for (int &v : quad) {
            const int old = v;
            v = core(old);
            if (v >= 0)
                continue;
            const auto [it, fresh] = inside.emplace(old, (rings + 1) * n + static_cast<int>(inside.size()));
            if (fresh)
                points.push_back(middle + (mesh.point(old) - middle) * std::pow(0.6, rings));
            v = it->second;
        }
        quads.push_back(quad);
    }
    mesh.replace_disk(window.faces, window.loop, quads, points);
    return mesh;
}

TEST(MendSizes, RefillsAWebAndKeepsTheCount) {
    mesh::QuadMesh mesh = web(5);
    ASSERT_NO_THROW(mesh.check());
    mesh::QuadMesh even = samples::grid(16, 16);
    reference::Reference of_even = reference::reference_of(even), reference = reference::reference_of(mesh);
    const auto sizes = reference::SizingField::of(even, of_even, mesh.n_faces());
    reference.sizes = &*sizes;
    reference.face_weight = sizes->total(mesh) / mesh.n_faces();
    const auto least = [&] {
        const std::vector<double> weights = sizes->weights(mesh, samples::all_faces(mesh));
        return std::log2(*std::min_element(weights.begin(), weights.end()) / reference.face_weight);
    };
    EXPECT_LT(least(), -3);
    const int faces = mesh.n_faces();
    EXPECT_GT(mend_sizes(mesh, reference, {}), 0);
    EXPECT_GT(least(), -3);
    EXPECT_EQ(mesh.n_faces(), faces);
    EXPECT_NO_THROW(mesh.check());
    const std::uint64_t now = mesh.checksum();
    EXPECT_EQ(mend_sizes(mesh, reference, {}), 0); // nothing is left to do
    EXPECT_EQ(mesh.checksum(), now);
}

} // namespace
} // namespace alphamst::adapt
