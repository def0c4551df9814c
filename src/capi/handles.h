// What the handles point to. A handle owns a share of its object; children own a
// share of their parent's, so that handles can be destroyed in any order.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "adapt/adapt.h"
#include "alphamst/alphamst.h"
#include "capi/options.h"
#include "mesh/quad_mesh.h"

namespace alphamst::capi {

struct Context {
    explicit Context(int index_base) : index_base(index_base) {}

    const int index_base;
    int threads = 1;
    amst_progress_fn progress = nullptr;
    void *progress_user = nullptr;
    amst_log_fn log = nullptr;
    void *log_user = nullptr;
    std::int32_t log_level = AMST_LOG_OFF;
    std::atomic<bool> cancel{false};
    std::atomic<double> fraction{0};
    std::atomic<bool> busy{false};       // an operation is under way
    std::atomic<std::thread::id> worker; // on the thread that called it

    // Failure (state) while an operation is under way.
    void require_idle() const;
    [[noreturn]] void refuse_while_busy() const;
    // To the caller's function, if he wants messages of this level.
    void say(std::int32_t level, const std::string &message) const;
};

// Of the faces given, while quads were made of triangles.
struct EdgeChanges {
    std::vector<std::array<std::int32_t, 2>> crossed; // vertices, smaller first, ascending
    std::vector<std::array<std::int32_t, 3>> split;   // and the vertex at the midpoint
};

struct Mesh {
    Mesh(std::shared_ptr<Context> context, std::shared_ptr<mesh::QuadMesh> current)
        : context(std::move(context)), current(std::move(current)) {}

    struct Savepoint {
        std::int64_t revision;
        std::shared_ptr<mesh::QuadMesh> mesh;
    };

    std::shared_ptr<Context> context;
    std::shared_ptr<mesh::QuadMesh> current; // a savepoint may share it
    std::int64_t revision = 0;
    std::int64_t last_revision = 0; // the largest ever given out
    std::vector<Savepoint> savepoints;
    amst_projection_fn projection = nullptr; // of the boundary
    void *projection_user = nullptr;
    EdgeChanges at_creation;

    // The current mesh, to be changed in place: no savepoint shares it afterwards.
    mesh::QuadMesh &writable();
    // Without savepoints and projection.
    std::shared_ptr<Mesh> clone(const std::shared_ptr<Context> &into) const;
};

struct Patches {
    std::shared_ptr<Mesh> mesh;
    std::int64_t revision = 0;
    Options options;
    std::vector<Patch> regions;

    // Failure (stale) if the mesh has another revision.
    void require_current() const;
};

// The face field that adapt and reduce_singularities write log2(area / wanted area) to, if there is one,
// and that pictures show in colour.
inline constexpr const char *size_error_field = "size error";

struct Report {
    struct Row {
        amst_status status = AMST_OK;
        std::int64_t faces_before = 0, faces_after = 0, faces_wanted = 0;
        std::int64_t singular_before = 0, singular_after = 0, singular_bound = 0;
        std::int64_t candidate = 0;
        std::int64_t unused_option = AMST_OPTION_INVALID;
        double quality_before = 0, quality_after = 0, seconds = 0;
        double size_error_before = std::numeric_limits<double>::quiet_NaN();
        double size_error_after = size_error_before;
        double least_area_before = size_error_before, least_area_after = size_error_before;
        double shortest_edge_before = size_error_before, shortest_edge_after = size_error_before;
        double aspect_ratio_before = 0, aspect_ratio_after = 0;
        double time_step = 1, area_gained = 0;
        std::map<int, std::int64_t> valences_before, valences_after;
    };
    struct Origin {
        std::int64_t count = 0;
        std::vector<std::int32_t> from; // empty: every entity is where it was
    };

    int index_base = 0;
    Row all;
    std::vector<Row> patches;
    Origin vertices, edges, faces;
};

} // namespace alphamst::capi

struct amst_context {
    std::shared_ptr<alphamst::capi::Context> impl;
};

struct amst_options {
    alphamst::capi::Options impl;
};

struct amst_mesh {
    std::shared_ptr<alphamst::capi::Mesh> impl;
};

struct amst_patches {
    std::shared_ptr<alphamst::capi::Patches> impl;
};

struct amst_report {
    alphamst::capi::Report impl;
};

namespace alphamst::capi {

// The numbering behind a handle, 0 for NULL.
inline int index_base(const amst_context *handle) noexcept {
    return handle == nullptr ? 0 : handle->impl->index_base;
}
inline int index_base(const amst_mesh *handle) noexcept {
    return handle == nullptr ? 0 : handle->impl->context->index_base;
}
inline int index_base(const amst_patches *handle) noexcept {
    return handle == nullptr ? 0 : handle->impl->mesh->context->index_base;
}
inline int index_base(const amst_report *handle) noexcept {
    return handle == nullptr ? 0 : handle->impl.index_base;
}

} // namespace alphamst::capi
