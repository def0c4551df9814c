/* Options mean the same for patches and whole meshes; those without effect on a call are told. */
#include <math.h>

#include "grid.h"

enum { n = 16 };

static int64_t warnings, stages, cavities;
static char last_warning[200];

static void listen(void *user, int32_t level, const char *message) {
    (void)user;
    warnings += level == AMST_LOG_WARNING;
    stages += level == AMST_LOG_INFO;
    cavities += level == AMST_LOG_DEBUG;
    if (level == AMST_LOG_WARNING) {
        strncpy(last_warning, message, sizeof last_warning - 1);
        last_warning[sizeof last_warning - 1] = 0;
    }
}

static amst_context *new_listened(void) {
    amst_context *ctx = new_context(0);
    warnings = stages = cavities = 0;
    last_warning[0] = 0;
    must(amst_context_set_log(ctx, AMST_LOG_DEBUG, listen, NULL));
    return ctx;
}

/* The disturbed grid as a bell. */
static amst_mesh *new_bell(amst_context *ctx) {
    amst_mesh *flat = new_disturbed(ctx, n), *bell = NULL;
    const int64_t n_points = count_of(flat, AMST_VERTEX);
    double *places = points_of(flat), *points = memory((size_t)n_points * 3 * sizeof *points);
    amst_id *faces = faces_of(flat);
    for (int64_t v = 0; v < n_points; ++v) {
        const double x = places[2 * v] - 0.5 * n, y = places[2 * v + 1] - 0.5 * n;
        points[3 * v] = x;
        points[3 * v + 1] = y;
        points[3 * v + 2] = 0.5 * n * exp(-18 * (x * x + y * y) / (n * n));
    }
    must(amst_mesh_create(ctx, 3, points, n_points, 0, 0, faces, count_of(flat, AMST_FACE), 0, 0, 4, NULL,
                          &bell));
    free(places);
    free(points);
    free(faces);
    amst_mesh_destroy(flat);
    return bell;
}

static int64_t unused_of(const amst_report *report) {
    int64_t key = 0;
    must(amst_report_get_int(report, AMST_ALL, AMST_RESULT_UNUSED_OPTION, &key));
    return key;
}

/* Adapts the ball around the middle, or the whole mesh. */
static amst_status adapt(amst_mesh *mesh, int whole, double alpha, const amst_options *options,
                         int64_t *unused) {
    amst_patches *set = NULL;
    amst_report *report = NULL;
    int32_t dim;
    must(amst_mesh_get_dim(mesh, &dim));
    /* The bell is around the origin, with its tip well above. */
    const double middle[3] = {dim == 2 ? 0.5 * n : 0, dim == 2 ? 0.5 * n : 0, dim == 2 ? 0 : 0.4 * n};
    if (!whole) {
        must(amst_patches_create(mesh, NULL, &set));
        must(amst_patches_add_ball(set, middle, 0.35 * n, NULL));
    }
    const amst_status status = amst_adapt(mesh, set, alpha, options, &report);
    *unused = status >= AMST_OK ? unused_of(report) : 0;
    amst_report_destroy(report);
    amst_patches_destroy(set);
    return status;
}

static void what_cannot_apply_is_told(void **state) {
    (void)state;
    amst_context *ctx = new_listened();
    amst_options *options = NULL;
    int64_t unused;
    for (int whole = 0; whole < 2; ++whole)
        for (int curved = 0; curved < 2; ++curved) {
            const struct {
                int32_t key;
                int in_use;
            } cases[] = {{AMST_OPT_CANDIDATES, 1},
                         {AMST_OPT_NODE_LIMIT, 1},
                         {AMST_OPT_EDIT_BOUNDARY, whole || !curved},
                         {AMST_OPT_ALIGN, curved},
                         {AMST_OPT_CHART, curved},
                         {AMST_OPT_STARTS, whole},
                         {AMST_OPT_TOLERANCE, curved},
                         {AMST_OPT_EFFORT, 1},
                         {AMST_OPT_SIZE_WEIGHT, 1},
                         {AMST_OPT_TRANSITION, 1},
                         {AMST_OPT_LEAST_SIZE, 1}};
            for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
                amst_mesh *mesh = curved ? new_bell(ctx) : new_disturbed(ctx, n);
                must(amst_options_create(&options));
                /* Which is always in use, and saves time. */
                must(amst_options_set_real(options, AMST_OPT_EFFORT, 0.01));
                if (cases[i].key < 1000)
                    must(
                        amst_options_set_int(options, cases[i].key, cases[i].key == AMST_OPT_STARTS ? 2 : 1));
                else
                    must(amst_options_set_real(options, cases[i].key, 0.6));
                warnings = 0;
                assert_true(adapt(mesh, whole, 1, options, &unused) >= AMST_OK);
                assert_int_equal(unused, cases[i].in_use ? AMST_OPTION_INVALID : cases[i].key);
                if (!cases[i].in_use)
                    assert_non_null(strstr(last_warning, "has no effect"));
                amst_options_destroy(options);
                amst_mesh_destroy(mesh);
            }
        }
    amst_context_destroy(ctx);
}

static void the_default_is_never_unused(void **state) {
    (void)state;
    amst_context *ctx = new_listened();
    amst_mesh *mesh = new_disturbed(ctx, n);
    int64_t unused;
    assert_true(adapt(mesh, 0, 2, NULL, &unused) >= AMST_OK);
    assert_int_equal(unused, AMST_OPTION_INVALID);
    assert_true(cavities >= 1);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* A bell cut off by coarse faces is far from its surface: a small tolerance does not allow it. */
static void tolerance_counts_in_patches(void **state) {
    (void)state;
    amst_context *ctx = new_listened();
    int64_t digest[2], unused;
    amst_status status[2];
    for (int wide = 0; wide < 2; ++wide) {
        amst_mesh *mesh = new_bell(ctx);
        amst_options *options = NULL;
        must(amst_options_create(&options));
        must(amst_options_set_real(options, AMST_OPT_TOLERANCE, wide ? 100 : 0.01));
        status[wide] = adapt(mesh, 0, 0.5, options, &unused);
        must(amst_mesh_get_checksum(mesh, &digest[wide]));
        amst_options_destroy(options);
        amst_mesh_destroy(mesh);
    }
    assert_true(status[0] != status[1] || digest[0] != digest[1]);
    amst_context_destroy(ctx);
}

static void stages_and_cavities_are_told(void **state) {
    (void)state;
    amst_context *ctx = new_listened();
    amst_mesh *mesh = new_disturbed(ctx, n);
    int64_t unused;
    assert_true(adapt(mesh, 1, 1, NULL, &unused) >= AMST_OK);
    assert_true(stages > 1);
    assert_true(cavities > stages);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_cannot_apply_is_told),
        cmocka_unit_test(the_default_is_never_unused),
        cmocka_unit_test(tolerance_counts_in_patches),
        cmocka_unit_test(stages_and_cavities_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
