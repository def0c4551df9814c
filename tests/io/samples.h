// Meshes and expectations shared by the tests of the formats.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
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

} // namespace alphamst::io::samples
