// What one patch of a set is asked.
#include <algorithm>
#include <string>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/ids.h"
#include "capi/limits.h"
#include "patch/window.h"

namespace alphamst::capi {
namespace {

static_assert(int{AMST_DEFECT_EMPTY} == int{patch::empty} &&
              int{AMST_DEFECT_NOT_CONNECTED} == int{patch::not_connected} &&
              int{AMST_DEFECT_NOT_DISK} == int{patch::not_disk} &&
              int{AMST_DEFECT_PINCHED} == int{patch::pinched} &&
              int{AMST_DEFECT_OVERLAP} == int{patch::overlap} &&
              int{AMST_DEFECT_CROSSES_FEATURE} == int{patch::crosses_feature} &&
              int{AMST_DEFECT_ODD_BOUNDARY} == int{patch::odd_boundary} &&
              int{AMST_DEFECT_CORNERS} == int{patch::corners} &&
              int{AMST_DEFECT_NOT_CONVEX} == int{patch::not_convex});

// With these a patch has no boundary loop.
constexpr std::int32_t no_loop = patch::empty | patch::not_connected | patch::not_disk | patch::pinched;

struct Asked {
    const Patches &set;
    const Patch &region;
    int id;
    int base;

    const mesh::QuadMesh &mesh() const { return *set.mesh->current; }
};

Asked ask(const amst_patches *handle, amst_id patch) {
    const Patches &set = *required(handle, "patches").impl;
    set.require_current();
    const int base = index_base(handle);
    const int p = in(base, patch, static_cast<std::int64_t>(set.regions.size()), Entity::none);
    return {set, set.regions[static_cast<std::size_t>(p)], p, base};
}

patch::Window window_of(const Asked &asked) {
    const std::int32_t found = patch::defects(asked.mesh(), asked.region.faces);
    if ((found & no_loop) == 0)
        return patch::make_window(asked.mesh(), asked.region.faces);
    Failure failure(Fault::patch,
                    std::string("patch {} is not a disk: it ") +
                        ((found & patch::empty) != 0           ? "is empty"
                         : (found & patch::not_connected) != 0 ? "is not connected"
                         : (found & patch::not_disk) != 0      ? "has a hole or a handle"
                                                               : "touches itself in a vertex"),
                    Entity::none, {asked.id});
    failure.patch = asked.id;
    throw failure;
}

Prediction predict(const Asked &asked, double alpha, const Settings &settings) {
    try {
        return adapt::predict(asked.mesh(), asked.region, alpha, settings);
    } catch (Failure &failure) {
        failure.patch = asked.id;
        throw;
    }
}

// On the loop, and met in the order given when it is walked once.
bool usable_corners(const std::vector<int> &loop, const std::vector<int> &corners) {
    std::vector<std::ptrdiff_t> places;
    for (const int corner : corners) {
        const auto found = std::find(loop.begin(), loop.end(), corner);
        if (found == loop.end())
            return false;
        places.push_back(found - loop.begin());
    }
    std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
    return std::adjacent_find(places.begin(), places.end(), std::greater_equal<>()) == places.end();
}

// Those that were given; otherwise the vertices of the loop where one face fits.
std::vector<int> corners_of(const Patch &region, const patch::Window &window) {
    if (!region.corners.empty())
        return region.corners;
    std::vector<int> corners;
    for (std::size_t i = 0; i < window.loop.size(); ++i)
        if (window.wanted[i] == 1)
            corners.push_back(window.loop[i]);
    return corners;
}

void write_ids(const std::vector<int> &indices, int base, amst_id *out, std::int64_t capacity,
               std::int64_t *needed) {
    if (answer(out, capacity, needed, static_cast<std::int64_t>(indices.size())))
        std::transform(indices.begin(), indices.end(), out,
                       [base](int index) { return capi::out(base, index); });
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_patches_get_count(const amst_patches *patches, std::int64_t *count) {
    return guarded(index_base(patches), [&] {
        const auto n = static_cast<std::int64_t>(required(patches, "patches").impl->regions.size());
        required(count, "count") = n;
    });
}

amst_status amst_patches_get_faces(const amst_patches *patches, amst_id patch, amst_id *out,
                                   std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(patches), [&] {
        const Asked asked = ask(patches, patch);
        write_ids(asked.region.faces, asked.base, out, capacity, needed);
    });
}

amst_status amst_patches_get_boundary(const amst_patches *patches, amst_id patch, amst_id *out,
                                      std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(patches), [&] {
        const Asked asked = ask(patches, patch);
        patch::Window window = window_of(asked);
        const std::vector<int> corners = corners_of(asked.region, window);
        if (!corners.empty()) {
            const auto first = std::find(window.loop.begin(), window.loop.end(), corners.front());
            if (first != window.loop.end())
                std::rotate(window.loop.begin(), first, window.loop.end());
        }
        write_ids(window.loop, asked.base, out, capacity, needed);
    });
}

amst_status amst_patches_get_corners(const amst_patches *patches, amst_id patch, amst_id *out,
                                     std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(patches), [&] {
        const Asked asked = ask(patches, patch);
        const std::vector<int> corners =
            asked.region.corners.empty() ? corners_of(asked.region, window_of(asked)) : asked.region.corners;
        write_ids(corners, asked.base, out, capacity, needed);
    });
}

amst_status amst_patches_check(const amst_patches *patches, amst_id patch, std::int32_t *defects,
                               double *convexity) {
    return guarded(index_base(patches), [&] {
        const Asked asked = ask(patches, patch);
        std::int32_t &told = required(defects, "defects");
        std::int32_t found = patch::defects(asked.mesh(), asked.region.faces);
        double shape = 0;
        if ((found & no_loop) == 0) {
            const patch::Window window = patch::make_window(asked.mesh(), asked.region.faces);
            shape = patch::convexity(asked.mesh(), window);
            if (!usable_corners(window.loop, asked.region.corners))
                found |= patch::corners;
            if (shape < asked.set.options.min_convexity)
                found |= patch::not_convex;
        }
        told = found;
        if (convexity != nullptr)
            *convexity = shape;
    });
}

amst_status amst_patches_predict(const amst_patches *patches, amst_id patch, double alpha,
                                 const amst_options *options, std::int64_t *faces,
                                 std::int64_t *singularities) {
    return guarded(index_base(patches), [&] {
        const Asked asked = ask(patches, patch);
        require_real(alpha, 0, true, "alpha");
        require_wanted_in_patch(static_cast<std::size_t>(asked.id), asked.region.faces.size(), alpha);
        const Settings settings = settings_of(options_of(options), asked.set.mesh->context->threads);
        const Prediction prediction = predict(asked, alpha, settings);
        if (faces != nullptr)
            *faces = prediction.faces;
        if (singularities != nullptr)
            *singularities = prediction.singularities;
    });
}
