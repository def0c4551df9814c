// Every allocation of every call fails once: the call says NO_MEMORY, no exception leaves
// and nothing has changed.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>
#include <utility>
#include <vector>

#include "alphamst/alphamst.h"

namespace {

std::atomic<long> until_failure{-1}; // allocations that still succeed; negative: all do

void *allocate(std::size_t size, std::size_t alignment) {
    if (until_failure.load() >= 0 && until_failure.fetch_sub(1) == 0)
        throw std::bad_alloc();
    void *p = alignment <= alignof(std::max_align_t)
                  ? std::malloc(size)
                  : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (p == nullptr)
        throw std::bad_alloc();
    return p;
}

} // namespace

// OpenMesh up to 9 loses the properties copied so far when copying one more fails.
extern "C" const char *__lsan_default_suppressions() { return "leak:OpenMesh::PropertyContainer"; }

// The library asks these too, since the program's definitions come first. Not inline:
// g++ 12 would take malloc and delete for a mismatch.
[[gnu::noinline]] void *operator new(std::size_t size) { return allocate(size > 0 ? size : 1, 1); }
[[gnu::noinline]] void *operator new(std::size_t size, std::align_val_t alignment) {
    return allocate(size > 0 ? size : 1, static_cast<std::size_t>(alignment));
}
// Who asks this way can do without, as std::stable_sort.
[[gnu::noinline]] void *operator new(std::size_t size, const std::nothrow_t &) noexcept {
    return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void operator delete(void *p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void *p, std::size_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void *p, std::align_val_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void *p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace {

class Allocation : public testing::Test {
protected:
    static constexpr int side = 8;
    static constexpr const char *long_name = "a name too long for a string without memory";

    void SetUp() override {
        for (int j = 0; j <= side; ++j)
            for (int i = 0; i <= side; ++i) {
                points.push_back(i);
                points.push_back(j);
            }
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const int v = j * (side + 1) + i;
                faces.insert(faces.end(), {v, v + 1, v + side + 2, v + side + 1});
                if (i >= 2 && i < 6 && j >= 2 && j < 6)
                    square.push_back(j * side + i);
            }
        ASSERT_EQ(amst_context_create(0, &ctx), AMST_OK);
        ASSERT_EQ(create(&mesh), AMST_OK);
        ASSERT_EQ(amst_patches_create(mesh, nullptr, &set), AMST_OK);
        ASSERT_EQ(amst_patches_add_faces(set, square.data(), std::ssize(square), nullptr), AMST_OK);
    }

    void TearDown() override {
        amst_patches_destroy(set);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }

    amst_status create(amst_mesh **out) {
        return amst_mesh_create(ctx, 2, points.data(), std::ssize(points) / 2, 0, 0, faces.data(),
                                std::ssize(faces) / 4, 0, 0, 4, nullptr, out);
    }

    std::vector<std::int64_t> state() const {
        std::int64_t digest = 0, revision = 0, patches = 0, size = 0;
        EXPECT_EQ(amst_mesh_get_checksum(mesh, &digest), AMST_OK);
        EXPECT_EQ(amst_mesh_get_revision(mesh, &revision), AMST_OK);
        EXPECT_EQ(amst_patches_get_count(set, &patches), AMST_OK);
        if (amst_patches_get_faces(set, 0, nullptr, 0, &size) <
            0) // after an adaption was rolled back it is stale
            size = -1;
        std::vector<std::int64_t> told{digest, revision, patches, size};
        for (const auto &[entity, name] : fields) {
            std::int64_t n = -1;
            const amst_status status = amst_mesh_get_field(mesh, entity, name, nullptr, 0, &n);
            told.push_back(status == AMST_OK ? n : -1);
        }
        return told;
    }

    // Lets the first, second, ... allocation of call fail until it succeeds; of a call with
    // very many, not every one.
    void fail_each(const std::function<amst_status()> &call) {
        const std::vector<std::int64_t> before = state();
        for (long n = 0;; n += 1 + n / 50) {
            until_failure = n;
            const amst_status status = call();
            const bool reached = until_failure.exchange(-1) < 0;
            if (status >= 0) {
                EXPECT_FALSE(reached) << "allocation " << n << " failed unnoticed";
                EXPECT_GT(n, 0) << "the call allocates nothing";
                return;
            }
            ASSERT_EQ(status, AMST_ERR_NO_MEMORY) << "allocation " << n << ": " << amst_last_error();
            ASSERT_STREQ(amst_last_error(), "not enough memory");
            ASSERT_EQ(state(), before) << "allocation " << n;
        }
    }

    std::vector<double> points;
    std::vector<std::int32_t> faces;
    std::vector<amst_id> square;
    const std::vector<std::pair<std::int32_t, const char *>> fields{
        {AMST_VERTEX, long_name}, {AMST_FACE, "faces"}, {AMST_EDGE, "edges"}, {AMST_VERTEX, "gone"}};
    amst_context *ctx = nullptr;
    amst_mesh *mesh = nullptr;
    amst_patches *set = nullptr;
};

TEST_F(Allocation, InMakingHandles) {
    amst_context *other = nullptr;
    fail_each([&] { return amst_context_create(1, &other); });
    amst_context_destroy(other);
    amst_options *options = nullptr;
    fail_each([&] { return amst_options_create(&options); });
    amst_options_destroy(options);
    amst_mesh *made = nullptr;
    fail_each([&] { return create(&made); });
    amst_mesh_destroy(made);
    const double corners[10] = {0, 0, 1, 0, 1, 1, 0, 1, 2, 1};
    const std::int32_t triangles[9] = {0, 1, 2, 0, 2, 3, 1, 4, 2}; // one is left over
    fail_each(
        [&] { return amst_mesh_create(ctx, 2, corners, 5, 0, 0, triangles, 3, 0, 0, 3, nullptr, &made); });
    amst_mesh_destroy(made);
    fail_each([&] { return amst_mesh_clone(mesh, &made); });
    amst_mesh_destroy(made);
    fail_each([&] { return amst_mesh_clone_into(mesh, ctx, &made); });
    amst_mesh_destroy(made);
    amst_patches *empty = nullptr;
    fail_each([&] { return amst_patches_create(mesh, nullptr, &empty); });
    amst_patches_destroy(empty);
}

TEST_F(Allocation, InFiles) {
    amst_mesh *back = nullptr;
    fail_each([&] { return amst_mesh_write(mesh, "allocation_test.vtk"); });
    fail_each([&] { return amst_mesh_read(ctx, "allocation_test.vtk", nullptr, &back); });
    fail_each([&] { return amst_patches_write(set, "allocation_test.svg"); });
    std::remove("allocation_test.vtk");
    amst_mesh_destroy(std::exchange(back, nullptr));
    const amst_id first = 0;
    for (const std::int32_t entity : {AMST_VERTEX, AMST_EDGE, AMST_FACE})
        ASSERT_EQ(amst_mesh_set_markers(mesh, entity, &first, 1, 7), AMST_OK);
    ASSERT_EQ(amst_mesh_set_marker_name(mesh, AMST_EDGE, 7, long_name), AMST_OK);
    for (const char *path : {"allocation_test.msh", "allocation_test.su2"}) {
        fail_each([&] { return amst_mesh_write(mesh, path); });
        fail_each([&] { return amst_mesh_read(ctx, path, nullptr, &back); });
        amst_mesh_destroy(std::exchange(back, nullptr));
        std::remove(path);
    }
    std::remove("allocation_test.svg");
}

TEST_F(Allocation, InAdding) {
    const amst_id pair[2] = {0, 1};
    const double center[3] = {1, 7, 0};
    fail_each([&] { return amst_patches_add_faces(set, pair, 2, nullptr); });
    fail_each([&] { return amst_patches_add_ball(set, center, 1.2, nullptr); });
    fail_each([&] { return amst_patches_add_rings(set, 8, 1, nullptr); });
}

TEST_F(Allocation, InDecompositions) {
    amst_patches *patches = nullptr;
    amst_options *options = nullptr;
    ASSERT_EQ(amst_options_create(&options), AMST_OK);
    ASSERT_EQ(amst_options_set_real(options, AMST_OPT_PATCH_FACES, 16), AMST_OK);
    for (std::int32_t method = AMST_DECOMPOSE_CLUSTERS; method <= AMST_DECOMPOSE_MEDIAL; ++method) {
        ASSERT_EQ(amst_patches_create(mesh, options, &patches), AMST_OK);
        fail_each([&] { return amst_patches_decompose(patches, method, nullptr); });
        amst_patches_destroy(patches);
    }
    amst_options_destroy(options);
}

TEST_F(Allocation, InFeaturesCrossFieldAndSurface) {
    const std::int32_t triangles[6] = {0, 1, side + 2, 0, side + 2, side + 1};
    std::int64_t mark = 0, found = 0;
    fail_each([&] { return amst_mesh_detect_features(mesh, 30, &found); });
    const amst_id first = 0;
    for (const std::int32_t entity : {AMST_VERTEX, AMST_EDGE, AMST_FACE})
        fail_each([&] { return amst_mesh_set_markers(mesh, entity, &first, 1, 7); });
    fail_each([&] { return amst_mesh_set_marker_name(mesh, AMST_EDGE, 7, long_name); });
    fail_each([&] { return amst_mesh_compute_cross_field(mesh, nullptr); });
    fail_each([&] { return amst_mesh_set_surface(mesh, points.data(), side + 3, triangles, 2); });
    ASSERT_EQ(amst_mesh_mark(mesh, &mark), AMST_OK);
    fail_each([&] { return amst_mesh_set_surface(mesh, nullptr, 0, nullptr, 0); });
}

TEST_F(Allocation, InFields) {
    const std::vector<double> values(2 * side * (side + 1), 1);
    const auto set_field = [&](std::int32_t entity, const char *name, std::int32_t carry, std::int64_t n) {
        return amst_mesh_set_field(mesh, entity, name, 1, carry, values.data(), n);
    };
    const std::int64_t n_vertices = (side + 1) * (side + 1), n_faces = side * side,
                       n_edges = std::ssize(values);
    fail_each([&] { return set_field(AMST_VERTEX, long_name, AMST_CARRY_LINEAR, n_vertices); });
    ASSERT_EQ(set_field(AMST_FACE, "faces", AMST_CARRY_CONSERVE, n_faces), AMST_OK);
    ASSERT_EQ(set_field(AMST_EDGE, "edges", AMST_CARRY_INHERIT, n_edges), AMST_OK);
    ASSERT_EQ(set_field(AMST_VERTEX, "gone", AMST_CARRY_DROP, n_vertices), AMST_OK);
    ASSERT_EQ(set_field(AMST_VERTEX, "vertices", AMST_CARRY_CONSERVE, n_vertices), AMST_OK);
    std::vector<amst_id> olds(n_faces), news(n_faces);
    std::vector<double> areas(n_faces);
    std::int64_t mark = 0, rows = 0;
    fail_each([&] {
        return amst_mesh_get_overlap(mesh, mesh, olds.data(), news.data(), areas.data(), n_faces, &rows);
    });
    ASSERT_EQ(amst_mesh_mark(mesh, &mark), AMST_OK);
    fail_each([&] {
        return amst_mesh_size_from_indicator(mesh, values.data(), n_faces, 0, n_faces, nullptr, nullptr);
    });
    ASSERT_EQ(amst_mesh_rollback(mesh, mark), AMST_OK);
    fail_each([&] { return amst_mesh_remove_field(mesh, AMST_FACE, "faces"); });
    ASSERT_EQ(amst_mesh_rollback(mesh, mark), AMST_OK);
    fail_each([&] { return amst_adapt(mesh, set, 2, nullptr, nullptr); });
    EXPECT_EQ(amst_mesh_rollback(mesh, mark), AMST_OK);
}

TEST_F(Allocation, InOperations) {
    std::int64_t mark = 0;
    ASSERT_EQ(amst_mesh_mark(mesh, &mark), AMST_OK);
    amst_report *report = nullptr;
    fail_each([&] { return amst_smooth(mesh, set, nullptr, &report); });
    amst_report_destroy(report);
    fail_each([&] { return amst_clean(mesh, nullptr, nullptr); });
    EXPECT_EQ(amst_mesh_rollback(mesh, mark), AMST_OK);
    amst_options *options = nullptr;
    ASSERT_EQ(amst_options_create(&options), AMST_OK);
    ASSERT_EQ(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1), AMST_OK);
    fail_each([&] { return amst_split_chord(mesh, 0, 2, options, nullptr); });
    fail_each([&] { return amst_collapse_chord(mesh, 0, options, nullptr); });
    EXPECT_EQ(amst_mesh_rollback(mesh, mark), AMST_OK);
    fail_each([&] { return amst_insert_chords(mesh, set, 1, nullptr, nullptr); });
    amst_options_destroy(options);
    fail_each([&] { return amst_adapt(mesh, set, 2, nullptr, &report); });
    amst_report_destroy(report);
    EXPECT_EQ(amst_mesh_check(mesh), AMST_OK);
    EXPECT_EQ(amst_mesh_rollback(mesh, mark), AMST_OK);
}

} // namespace
