/* What EFFORT, SIZE_WEIGHT, TRANSITION and LEAST_SIZE change. */
#include <math.h>
#include <stdio.h>

#include "grid.h"

enum { n = 20 };

static int64_t candidates; /* laid out for the patch, by the log */

static void listen(void *user, int32_t level, const char *message) {
    (void)user;
    const char *at = strstr(message, "adapt patch 0, ");
    int faces, tried;
    if (level == AMST_LOG_DEBUG && at != NULL &&
        sscanf(at, "adapt patch 0, %d faces, %d candidates", &faces, &tried) == 2)
        candidates = tried;
}

/* One that has been bent where x exceeds n / 2. */
static amst_mesh *new_bent(amst_context *ctx) {
    enum { side = n + 1 };
    double *places = grid_points(n, n), points[3 * side * side];
    int32_t *faces = grid_faces(n, n, 0);
    for (int v = 0; v < side * side; ++v) {
        const double x = places[2 * v], over = fmax(0, x - n / 2);
        points[3 * v] = x;
        points[3 * v + 1] = places[2 * v + 1];
        points[3 * v + 2] = over * over / n;
    }
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 3, points, side * side, 0, 0, faces, n * n, 0, 0, 4, NULL, &mesh));
    free(places);
    free(faces);
    return mesh;
}

/* Every third vertex inside. */
static void push_aside(amst_mesh *mesh) {
    double *points = points_of(mesh);
    int32_t dim;
    must(amst_mesh_get_dim(mesh, &dim));
    for (int v = n + 2; v < n * (n + 1); v += 3)
        if (v % (n + 1) > 0 && v % (n + 1) < n)
            points[dim * v + 1] += 0.3;
    must(amst_mesh_set_points(mesh, points, (n + 1) * (n + 1)));
    free(points);
}

typedef struct answer {
    amst_status status;
    int64_t faces, unused, checksum;
    double size_error, least, smallest; /* smallest: area of a face of the mesh */
} answer;

/* Of the faces with low <= i, j < high in a grid. */
static answer refill_with(int32_t low, int32_t high, double alpha, const amst_options *options) {
    amst_context *ctx = new_context(0);
    candidates = 0;
    must(amst_context_set_log(ctx, AMST_LOG_DEBUG, listen, NULL));
    amst_mesh *mesh = new_grid(ctx, 0, n, n);
    amst_patches *set = NULL;
    amst_report *report = NULL;
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, n, low, high);
    answer a;
    a.status = amst_adapt(mesh, set, alpha, options, &report);
    assert_true(a.status >= AMST_OK);
    must(amst_mesh_check(mesh));
    a.faces = result(report, 0, AMST_RESULT_FACES_AFTER);
    a.unused = result(report, AMST_ALL, AMST_RESULT_UNUSED_OPTION);
    a.checksum = checksum(mesh);
    a.size_error = real_result(report, 0, AMST_RESULT_SIZE_ERROR_AFTER);
    a.least = real_result(report, 0, AMST_RESULT_LEAST_AREA_AFTER);
    amst_summary summary;
    must(amst_mesh_get_summary(mesh, AMST_METRIC_AREA, &summary));
    a.smallest = summary.min;
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
    return a;
}

static amst_options *new_options(int32_t key, double value) {
    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_real(options, key, value));
    return options;
}

static answer refill(int32_t low, int32_t high, double alpha, int32_t key, double value) {
    amst_options *options = new_options(key, value);
    const answer a = refill_with(low, high, alpha, options);
    amst_options_destroy(options);
    return a;
}

/* Where sizes change over a shorter way, more is left for a core, whose faces need not be so small. */
static void a_shorter_transition_has_larger_faces(void **state) {
    (void)state;
    const double parts[] = {0.1, 0.5, 1};
    double smallest = 1;
    for (int k = 0; k < 3; ++k) {
        const answer a = refill(2, 18, 4, AMST_OPT_TRANSITION, parts[k]);
        assert_int_equal(a.status, AMST_OK);
        assert_int_equal(a.faces, 1024);
        assert_int_equal(a.unused, AMST_OPTION_INVALID);
        assert_true(a.smallest < 0.8 * smallest);
        smallest = a.smallest;
    }
}

static void no_face_is_smaller_than_the_least(void **state) {
    (void)state;
    assert_true(refill(4, 14, 1.5, AMST_OPT_LEAST_SIZE, 0.125).least < 0.5);
    const answer a = refill(4, 14, 1.5, AMST_OPT_LEAST_SIZE, 0.5);
    assert_int_equal(a.status, AMST_OK);
    assert_int_equal(a.faces, 150);
    assert_int_equal(a.unused, AMST_OPTION_INVALID);
    assert_true(a.least >= 0.5);
}

/* Some face is always below what is wanted. */
static void what_cannot_have_the_least_size_is_left(void **state) {
    (void)state;
    const answer left = refill(8, 14, 4, AMST_OPT_LEAST_SIZE, 1);
    assert_int_equal(left.status, AMST_PARTIAL);
    assert_non_null(strstr(amst_last_error(), "AMST_OPT_LEAST_SIZE"));
    assert_int_equal(left.faces, 36);
    assert_true(left.smallest == 1);
    assert_int_equal(refill(8, 14, 4, AMST_OPT_LEAST_SIZE, 0).faces, 144);
}

static void sizes_are_the_better_the_more_they_weigh(void **state) {
    (void)state;
    const answer none = refill(2, 18, 4, AMST_OPT_SIZE_WEIGHT, 0);
    const answer all = refill(2, 18, 4, AMST_OPT_SIZE_WEIGHT, 1);
    assert_int_equal(none.faces, 1024);
    assert_int_equal(all.faces, 1024);
    assert_true(all.size_error < 0.5 * none.size_error);
}

static void little_effort_gives_the_exact_count_too(void **state) {
    (void)state;
    for (int k = 1; k < 5; ++k) {
        const answer a = refill(4, 14, 0.75 * k, AMST_OPT_EFFORT, 0.01);
        assert_int_equal(a.status, AMST_OK);
        assert_int_equal(a.faces, 75 * k);
        assert_int_equal(a.unused, AMST_OPTION_INVALID);
        assert_true(a.smallest > 0);
    }
}

/* Where none has the least size. */
static void with_more_effort_more_fillings_are_tried(void **state) {
    (void)state;
    const double efforts[] = {0.01, 0.1, 0.4};
    int64_t fewer = 0;
    for (int k = 0; k < 3; ++k) {
        amst_options *options = new_options(AMST_OPT_LEAST_SIZE, 1);
        must(amst_options_set_real(options, AMST_OPT_EFFORT, efforts[k]));
        assert_int_equal(refill_with(8, 14, 4, options).status, AMST_PARTIAL);
        assert_true(candidates > fewer);
        fewer = candidates;
        amst_options_destroy(options);
    }
}

static void fillings_of_curved_patches_weigh_sizes_too(void **state) {
    (void)state;
    const int32_t keys[] = {AMST_OPT_SIZE_WEIGHT, AMST_OPT_TRANSITION};
    amst_context *ctx = new_context(0);
    for (int i = 0; i < 2; ++i) {
        int64_t digest[2];
        for (int k = 0; k < 2; ++k) {
            amst_mesh *mesh = new_bent(ctx);
            amst_patches *set = NULL;
            amst_options *options = new_options(keys[i], k == 0 ? 0.1 : 1);
            amst_report *report = NULL;
            must(amst_patches_create(mesh, NULL, &set));
            add_square(set, n, 11, 19);
            must(amst_adapt(mesh, set, 2, options, &report));
            digest[k] = checksum(mesh);
            assert_int_equal(result(report, AMST_ALL, AMST_RESULT_UNUSED_OPTION), AMST_OPTION_INVALID);
            amst_report_destroy(report);
            amst_options_destroy(options);
            amst_patches_destroy(set);
            amst_mesh_destroy(mesh);
        }
        assert_true(digest[0] != digest[1]);
    }
    amst_context_destroy(ctx);
}

/* Smooths a mesh, or a square of it, with one option; what is unused. */
static int64_t smoothed(amst_mesh *mesh, int32_t low, int32_t high, int32_t key, double value,
                        int64_t *digest) {
    amst_patches *set = NULL;
    amst_options *options = new_options(key, value);
    amst_report *report = NULL;
    if (high > 0) {
        must(amst_patches_create(mesh, NULL, &set));
        add_square(set, n, low, high);
    }
    must(amst_smooth(mesh, set, options, &report));
    const int64_t unused = result(report, AMST_ALL, AMST_RESULT_UNUSED_OPTION);
    *digest = checksum(mesh);
    amst_report_destroy(report);
    amst_options_destroy(options);
    amst_patches_destroy(set);
    return unused;
}

static void smoothing_weighs_sizes_in_a_plane(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    int64_t digest[2];
    const int32_t others[] = {AMST_OPT_EFFORT, AMST_OPT_TRANSITION, AMST_OPT_LEAST_SIZE};
    for (int k = 0; k < 2; ++k) {
        amst_mesh *mesh = new_disturbed(ctx, n);
        assert_int_equal(smoothed(mesh, 0, 0, AMST_OPT_SIZE_WEIGHT, k, &digest[k]), AMST_OPTION_INVALID);
        amst_mesh_destroy(mesh);
    }
    assert_true(digest[0] != digest[1]);
    for (int k = 0; k < 3; ++k) {
        amst_mesh *mesh = new_grid(ctx, 0, n, n);
        assert_int_equal(smoothed(mesh, 0, 0, others[k], 0.3, digest), others[k]);
        amst_mesh_destroy(mesh);
    }
    amst_context_destroy(ctx);
}

/* And in plane patches of a curved mesh, but not on a surface. */
static void smoothing_weighs_no_sizes_on_a_surface(void **state) {
    (void)state;
    const struct {
        int32_t low, high, unused;
    } cases[] = {{0, 0, AMST_OPT_SIZE_WEIGHT}, {11, 19, AMST_OPT_SIZE_WEIGHT}, {1, 9, AMST_OPTION_INVALID}};
    amst_context *ctx = new_context(0);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        int64_t digest[2];
        for (int k = 0; k < 2; ++k) {
            amst_mesh *mesh = new_bent(ctx);
            push_aside(mesh);
            assert_int_equal(smoothed(mesh, cases[i].low, cases[i].high, AMST_OPT_SIZE_WEIGHT, k, &digest[k]),
                             cases[i].unused);
            amst_mesh_destroy(mesh);
        }
        assert_int_equal(digest[0] == digest[1], cases[i].unused == AMST_OPT_SIZE_WEIGHT);
    }
    amst_context_destroy(ctx);
}

static void chords_weigh_sizes_in_a_plane(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    for (int curved = 0; curved < 2; ++curved) {
        int64_t digest[2];
        for (int k = 0; k < 2; ++k) {
            amst_mesh *mesh = curved ? new_bent(ctx) : new_disturbed(ctx, n);
            amst_options *options = new_options(AMST_OPT_SIZE_WEIGHT, k);
            amst_report *report = NULL;
            must(amst_options_set_int(options, AMST_OPT_STRATEGY, 1));
            must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
            assert_true(amst_adapt(mesh, NULL, 0.8, options, &report) >= AMST_OK);
            digest[k] = checksum(mesh);
            assert_int_equal(result(report, AMST_ALL, AMST_RESULT_UNUSED_OPTION),
                             curved ? AMST_OPT_SIZE_WEIGHT : AMST_OPTION_INVALID);
            amst_report_destroy(report);
            amst_options_destroy(options);
            amst_mesh_destroy(mesh);
        }
        assert_int_equal(digest[0] == digest[1], curved);
    }
    amst_context_destroy(ctx);
}

static void an_edited_chord_weighs_sizes_in_a_plane(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    for (int split = 0; split < 2; ++split) {
        int64_t digest[2];
        for (int k = 0; k < 2; ++k) {
            amst_mesh *mesh = new_grid(ctx, 0, n, n);
            push_aside(mesh);
            amst_options *options = new_options(AMST_OPT_SIZE_WEIGHT, k);
            amst_report *report = NULL;
            const amst_id ends[2] = {n / 2, n / 2 + 1};
            amst_id edge;
            must(amst_mesh_find_edges(mesh, ends, 1, &edge));
            must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
            must(split ? amst_split_chord(mesh, edge, 1, options, &report)
                       : amst_collapse_chord(mesh, edge, options, &report));
            digest[k] = checksum(mesh);
            assert_int_equal(result(report, AMST_ALL, AMST_RESULT_UNUSED_OPTION), AMST_OPTION_INVALID);
            amst_report_destroy(report);
            amst_options_destroy(options);
            amst_mesh_destroy(mesh);
        }
        assert_true(digest[0] != digest[1]);
    }
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_shorter_transition_has_larger_faces),
        cmocka_unit_test(no_face_is_smaller_than_the_least),
        cmocka_unit_test(what_cannot_have_the_least_size_is_left),
        cmocka_unit_test(sizes_are_the_better_the_more_they_weigh),
        cmocka_unit_test(little_effort_gives_the_exact_count_too),
        cmocka_unit_test(with_more_effort_more_fillings_are_tried),
        cmocka_unit_test(fillings_of_curved_patches_weigh_sizes_too),
        cmocka_unit_test(smoothing_weighs_sizes_in_a_plane),
        cmocka_unit_test(smoothing_weighs_no_sizes_on_a_surface),
        cmocka_unit_test(chords_weigh_sizes_in_a_plane),
        cmocka_unit_test(an_edited_chord_weighs_sizes_in_a_plane),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
