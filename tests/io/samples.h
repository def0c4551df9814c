// Meshes and expectations shared by the tests of the formats.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "failure.h"
#include "io/arrays.h"

namespace alphamst::io::samples {

// n x n unit squares with coordinates that need all 17 digits.
inline Arrays grid(int n, int dim) {
    Arrays mesh;
    mesh.dim = dim;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = i / 3.0 + 1e-17 * j, y = j / 7.0 - 1.0 / (3 + i);
            mesh.points.insert(mesh.points.end(), {x, y, dim == 2 ? 0.0 : x * y + 0.1});
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int v = j * (n + 1) + i;
            mesh.faces.insert(mesh.faces.end(), {v, v + 1, v + n + 2, v + n + 1});
        }
    return mesh;
}

// Six squares, all corners of valence 3.
inline Arrays cube() {
    Arrays mesh;
    for (int v = 0; v < 8; ++v)
        mesh.points.insert(mesh.points.end(), {double(v & 1), double(v >> 1 & 1), double(v >> 2 & 1)});
    mesh.faces = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    return mesh;
}

// A cube of n x n squares a side, blown up to a sphere of radius 1.
inline Arrays sphere(int n) {
    Arrays mesh;
    std::map<std::array<int, 3>, std::int32_t> vertices;
    const auto vertex = [&](const std::array<int, 3> &at) {
        const auto [place, is_new] = vertices.try_emplace(at, static_cast<std::int32_t>(vertices.size()));
        if (is_new) {
            const double x = at[0] - n / 2.0, y = at[1] - n / 2.0, z = at[2] - n / 2.0;
            const double r = std::sqrt(x * x + y * y + z * z);
            mesh.points.insert(mesh.points.end(), {x / r, y / r, z / r});
        }
        return place->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int side : {0, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    std::array<int, 3> at;
                    at[axis] = side;
                    const auto corner = [&](int u, int v) {
                        at[(axis + 1) % 3] = side == 0 ? v : u;
                        at[(axis + 2) % 3] = side == 0 ? u : v;
                        return vertex(at);
                    };
                    for (std::int32_t v :
                         {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)})
                        mesh.faces.push_back(v);
                }
    return mesh;
}

// A directory of its own for a test, gone with it.
class Folder {
public:
    Folder() {
        const auto *test = ::testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::path(::testing::TempDir()) /
                ("alphamst_" + std::string(test->test_suite_name()) + "_" + test->name());
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string operator/(const std::string &name) const { return (path_ / name).string(); }
    std::size_t size() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
    }

private:
    std::filesystem::path path_;
};

inline std::string contents(const std::string &path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

template <class Call> Failure failure_of(Call call) {
    try {
        call();
    } catch (const Failure &failure) {
        return failure;
    }
    ADD_FAILURE() << "no failure";
    return Failure(Fault::internal, "none");
}

// Bit for bit, so that -0 and 0 differ.
inline bool same_bits(const std::vector<double> &a, const std::vector<double> &b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
}

// Ends and marker of each.
inline std::vector<std::array<std::int32_t, 3>> edges_of(const Arrays &mesh) {
    std::vector<std::array<std::int32_t, 3>> edges;
    for (const Arrays::MarkedEdge &edge : mesh.marked_edges)
        edges.push_back({edge.vertices[0], edge.vertices[1], edge.marker});
    return edges;
}

} // namespace alphamst::io::samples
