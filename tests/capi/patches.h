/* A set of patches in a grid of 10 by 10 squares, and questions about it. */
#ifndef ALPHAMST_TESTS_CAPI_PATCHES_H
#define ALPHAMST_TESTS_CAPI_PATCHES_H

#include "grid.h"

static amst_context *ctx;
static amst_mesh *mesh;
static amst_patches *set;

static inline int setup_with(const amst_options *options) {
    ctx = new_context(0);
    mesh = new_grid(ctx, 0, 10, 10);
    must(amst_patches_create(mesh, options, &set));
    return 0;
}

static inline int setup(void **state) {
    (void)state;
    return setup_with(NULL);
}

static inline int setup_plain(void **state) {
    (void)state;
    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_REPAIR_PATCHES, 0));
    setup_with(options);
    amst_options_destroy(options);
    return 0;
}

static inline int teardown(void **state) {
    (void)state;
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
    return 0;
}

static inline int64_t n_patches(void) {
    int64_t n = -1;
    must(amst_patches_get_count(set, &n));
    return n;
}

static inline int64_t n_faces(amst_id patch) {
    int64_t n = -1;
    must(amst_patches_get_faces(set, patch, NULL, 0, &n));
    return n;
}

static inline int32_t defects_of(amst_id patch) {
    int32_t defects = -1;
    must(amst_patches_check(set, patch, &defects, NULL));
    return defects;
}

#endif
