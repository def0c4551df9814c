/* What a report tells, and that it outlives everything. */
#include <math.h>

#include "grid.h"

static const int32_t integer_keys[] = {
    AMST_RESULT_STATUS,         AMST_RESULT_FACES_BEFORE,    AMST_RESULT_FACES_AFTER,
    AMST_RESULT_FACES_WANTED,   AMST_RESULT_SINGULAR_BEFORE, AMST_RESULT_SINGULAR_AFTER,
    AMST_RESULT_SINGULAR_BOUND, AMST_RESULT_CANDIDATE,       AMST_RESULT_UNUSED_OPTION,
};
static const int32_t real_keys[] = {AMST_RESULT_ALPHA,
                                    AMST_RESULT_QUALITY_BEFORE,
                                    AMST_RESULT_QUALITY_AFTER,
                                    AMST_RESULT_SECONDS,
                                    AMST_RESULT_SIZE_ERROR_BEFORE,
                                    AMST_RESULT_SIZE_ERROR_AFTER,
                                    AMST_RESULT_LEAST_AREA_BEFORE,
                                    AMST_RESULT_LEAST_AREA_AFTER,
                                    AMST_RESULT_TIME_STEP,
                                    AMST_RESULT_SHORTEST_EDGE_BEFORE,
                                    AMST_RESULT_SHORTEST_EDGE_AFTER,
                                    AMST_RESULT_ASPECT_RATIO_BEFORE,
                                    AMST_RESULT_ASPECT_RATIO_AFTER};
static const int32_t size_keys[] = {AMST_RESULT_SIZE_ERROR_BEFORE,    AMST_RESULT_SIZE_ERROR_AFTER,
                                    AMST_RESULT_LEAST_AREA_BEFORE,    AMST_RESULT_LEAST_AREA_AFTER,
                                    AMST_RESULT_SHORTEST_EDGE_BEFORE, AMST_RESULT_SHORTEST_EDGE_AFTER};

static void it_outlives_mesh_and_patches(void **state) {
    (void)state;
    for (int32_t base = 0; base <= 1; ++base) {
        amst_context *ctx = new_context(base);
        amst_mesh *mesh = new_grid(ctx, base, 10, 10);
        amst_patches *set = NULL;
        amst_report *report = NULL;
        const double low[3] = {2, 2, 0}, high[3] = {8, 8, 0};
        must(amst_patches_create(mesh, NULL, &set));
        must(amst_patches_add_box(set, low, high, NULL));
        must(amst_adapt(mesh, set, 2, NULL, &report));
        const int64_t n_faces = count_of(mesh, AMST_FACE), singular = n_singular(mesh);
        amst_patches_destroy(set);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);

        int64_t value, valence3, valence4, valence5, n;
        double real;
        for (size_t k = 0; k < sizeof integer_keys / sizeof *integer_keys; ++k) {
            must(amst_report_get_int(report, base, integer_keys[k], &value));
            must(amst_report_get_int(report, AMST_ALL, integer_keys[k], &value));
            refused(AMST_ERR_NOT_FOUND, amst_report_get_real(report, AMST_ALL, integer_keys[k], &real));
        }
        for (size_t k = 0; k < sizeof real_keys / sizeof *real_keys; ++k) {
            must(amst_report_get_real(report, base, real_keys[k], &real));
            assert_true(isfinite(real));
            must(amst_report_get_real(report, AMST_ALL, real_keys[k], &real));
            assert_true(isfinite(real));
            refused(AMST_ERR_NOT_FOUND, amst_report_get_int(report, AMST_ALL, real_keys[k], &value));
        }
        assert_true(real_result(report, base, AMST_RESULT_ALPHA) == 2);
        assert_true(real_result(report, AMST_ALL, AMST_RESULT_ALPHA) == 2);
        assert_true(fabs(real_result(report, base, AMST_RESULT_QUALITY_BEFORE) - 1) < 1e-12);
        assert_true(real_result(report, base, AMST_RESULT_QUALITY_AFTER) > 0);
        assert_true(real_result(report, AMST_ALL, AMST_RESULT_SECONDS) >= 0);
        assert_int_equal(result(report, AMST_ALL, AMST_RESULT_SINGULAR_BEFORE), 0);
        assert_int_equal(result(report, AMST_ALL, AMST_RESULT_SINGULAR_AFTER), singular);
        must(amst_report_get_valence(report, AMST_ALL, 0, 4, &valence4));
        assert_int_equal(valence4, 81);
        must(amst_report_get_valence(report, AMST_ALL, 1, 3, &valence3));
        must(amst_report_get_valence(report, AMST_ALL, 1, 5, &valence5));
        assert_int_equal(valence3, valence5); /* the mesh around is flat */
        assert_int_equal(valence3 + valence5, singular);
        must(amst_report_get_valence(report, base, 0, 3, &valence3));
        assert_int_equal(valence3, 0);
        must(amst_report_get_valence(report, base, 1, -8, &valence3));
        assert_int_equal(valence3, 0);
        must(amst_report_get_origin(report, AMST_FACE, NULL, 0, &n));
        assert_int_equal(n, n_faces);
        refused(AMST_ERR_ARGUMENT, amst_report_get_origin(report, 4, NULL, 0, &n));
        refused(AMST_ERR_RANGE, amst_report_get_int(report, base + 1, AMST_RESULT_STATUS, &value));
        refused(AMST_ERR_RANGE, amst_report_get_int(report, base - 1, AMST_RESULT_STATUS, &value));
        refused(AMST_ERR_NOT_FOUND, amst_report_get_int(report, base, 999, &value));
        refused(AMST_ERR_NOT_FOUND, amst_report_get_real(report, base, 1999, &real));
        amst_report_destroy(report);
    }
}

/* Smallest area over perimeter, of the faces of a patch or of all. */
static double step_of(const amst_mesh *mesh, const amst_patches *set, amst_id patch) {
    int64_t n = count_of(mesh, AMST_FACE);
    double *points = points_of(mesh), least = HUGE_VAL;
    amst_id *corners = faces_of(mesh), *chosen = memory(sizeof(amst_id) * (size_t)n);
    for (int64_t f = 0; f < n; ++f)
        chosen[f] = (amst_id)f;
    if (set != NULL)
        must(amst_patches_get_faces(set, patch, chosen, n, &n));
    for (int64_t i = 0; i < n; ++i) {
        double area = 0, perimeter = 0;
        for (int k = 0; k < 4; ++k) {
            const double *a = points + 2 * corners[4 * chosen[i] + k];
            const double *b = points + 2 * corners[4 * chosen[i] + (k + 1) % 4];
            area += (a[0] * b[1] - a[1] * b[0]) / 2;
            perimeter += hypot(a[0] - b[0], a[1] - b[1]);
        }
        least = fmin(least, area / perimeter);
    }
    free(chosen);
    free(corners);
    free(points);
    return least;
}

/* Three patches, of which the last is left, as it is in two pieces. */
static amst_patches *three_patches(const amst_mesh *mesh) {
    const amst_id apart[2] = {11, 143};
    amst_options *options = NULL;
    amst_patches *set = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_REPAIR_PATCHES, 0));
    must(amst_patches_create(mesh, options, &set));
    add_square(set, 12, 1, 6);
    add_square(set, 12, 7, 11);
    must(amst_patches_add_faces(set, apart, 2, NULL));
    amst_options_destroy(options);
    return set;
}

static void sizes_of_patches_are_summed_up(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 12, 12);
    amst_patches *set = three_patches(mesh);
    amst_report *report = NULL;
    const double whole = step_of(mesh, NULL, 0);
    double before[2], squares = 0, least = HUGE_VAL, edge = HUGE_VAL, aspect = 0;
    for (amst_id p = 0; p < 2; ++p)
        before[p] = step_of(mesh, set, p);
    assert_int_equal(amst_adapt(mesh, set, 2, NULL, &report), AMST_PARTIAL);
    for (amst_id p = 0; p < 2; ++p) {
        const double error = real_result(report, p, AMST_RESULT_SIZE_ERROR_AFTER);
        assert_true(error > 0 && error < real_result(report, p, AMST_RESULT_SIZE_ERROR_BEFORE));
        squares += error * error * (double)result(report, p, AMST_RESULT_FACES_AFTER);
        least = fmin(least, real_result(report, p, AMST_RESULT_LEAST_AREA_AFTER));
        edge = fmin(edge, real_result(report, p, AMST_RESULT_SHORTEST_EDGE_AFTER));
        aspect = fmax(aspect, real_result(report, p, AMST_RESULT_ASPECT_RATIO_AFTER));
        assert_true(real_result(report, p, AMST_RESULT_LEAST_AREA_BEFORE) > 0.9); /* all are too large */
        assert_true(fabs(real_result(report, p, AMST_RESULT_TIME_STEP) - step_of(mesh, set, p) / before[p]) <
                    1e-9);
    }
    for (size_t k = 0; k < sizeof size_keys / sizeof *size_keys; ++k)
        assert_true(isnan(real_result(report, 2, size_keys[k]))); /* it came to no wanted sizes */
    assert_true(real_result(report, 2, AMST_RESULT_TIME_STEP) == 1);
    const double faces =
        (double)(result(report, 0, AMST_RESULT_FACES_AFTER) + result(report, 1, AMST_RESULT_FACES_AFTER));
    assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_SIZE_ERROR_AFTER) - sqrt(squares / faces)) <
                1e-12);
    assert_true(real_result(report, AMST_ALL, AMST_RESULT_LEAST_AREA_AFTER) == least);
    assert_true(real_result(report, AMST_ALL, AMST_RESULT_SHORTEST_EDGE_AFTER) == edge);
    assert_true(edge > 0.2 && edge < 1);
    assert_true(real_result(report, AMST_ALL, AMST_RESULT_ASPECT_RATIO_AFTER) == aspect);
    assert_true(fabs(real_result(report, 2, AMST_RESULT_ASPECT_RATIO_AFTER) - 1) < 1e-12);
    assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_ASPECT_RATIO_BEFORE) - 1) < 1e-12);
    assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_TIME_STEP) - step_of(mesh, NULL, 0) / whole) <
                1e-9);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* Largest aspect ratio of the mesh. */
static double aspect_of(const amst_mesh *mesh) {
    amst_summary summary;
    must(amst_mesh_get_summary(mesh, AMST_METRIC_ASPECT_RATIO, &summary));
    return summary.max;
}

/* Without patches they are those of the whole mesh, whose wanted sizes do not change. */
static void sizes_of_a_whole_mesh(void **state) {
    (void)state;
    const double alphas[] = {1, 2, 0.5};
    amst_context *ctx = new_context(0);
    for (int k = 0; k < 4; ++k) { /* the last time fewer singular vertices */
        amst_mesh *mesh = new_disturbed(ctx, 16);
        amst_report *report = NULL;
        const double step = step_of(mesh, NULL, 0), aspect = aspect_of(mesh);
        assert_true((k < 3 ? amst_adapt(mesh, NULL, alphas[k], NULL, &report)
                           : amst_reduce_singularities(mesh, NULL, NULL, &report)) >= 0);
        for (size_t i = 0; i < sizeof real_keys / sizeof *real_keys; ++i)
            assert_true(isfinite(real_result(report, AMST_ALL, real_keys[i])));
        const double error = real_result(report, AMST_ALL, AMST_RESULT_SIZE_ERROR_AFTER);
        const double least = real_result(report, AMST_ALL, AMST_RESULT_LEAST_AREA_AFTER);
        const double edge = real_result(report, AMST_ALL, AMST_RESULT_SHORTEST_EDGE_AFTER);
        assert_true(error >= 0 && error < 1);
        assert_true(least > 0 && least <= 1.5);
        assert_true(edge > 0 && edge <= 1.5);
        assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_ASPECT_RATIO_BEFORE) - aspect) < 1e-12);
        assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_ASPECT_RATIO_AFTER) - aspect_of(mesh)) <
                    1e-12);
        assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_TIME_STEP) -
                         step_of(mesh, NULL, 0) / step) < 1e-9);
        if (k == 1) /* what was there is twice as large as what is wanted */
            assert_true(real_result(report, AMST_ALL, AMST_RESULT_SIZE_ERROR_BEFORE) > 0.9);
        amst_report_destroy(report);
        amst_mesh_destroy(mesh);
    }
    amst_context_destroy(ctx);
}

/* A mesh that stays as it is has after = before. */
static void sizes_of_a_whole_mesh_that_stays(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 6, 6);
    amst_report *report = NULL;
    must(amst_adapt(mesh, NULL, 1, NULL, &report));
    for (size_t k = 0; k < sizeof size_keys / sizeof *size_keys; k += 2)
        assert_true(real_result(report, AMST_ALL, size_keys[k]) ==
                    real_result(report, AMST_ALL, size_keys[k + 1]));
    assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_SIZE_ERROR_AFTER)) < 1e-9);
    assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_SHORTEST_EDGE_AFTER) - 1) < 1e-9);
    assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_ASPECT_RATIO_AFTER) - 1) < 1e-12);
    amst_report_destroy(report);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* Other operations want no sizes, but tell aspect ratio and time step. */
static void without_wanted_sizes_they_are_nan(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_options *chords = NULL;
    must(amst_options_create(&chords));
    must(amst_options_set_int(chords, AMST_OPT_STRATEGY, 1));
    for (int operation = 0; operation < 5; ++operation) {
        amst_mesh *mesh = operation == 1 ? new_grid(ctx, 0, 16, 16) : new_disturbed(ctx, 16);
        const double aspect = aspect_of(mesh);
        amst_patches *set = NULL;
        amst_report *report = NULL;
        must(amst_patches_create(mesh, NULL, &set));
        const double centre[3] = {5, 5, 0};
        if (operation == 0)
            must(amst_patches_add_ball(set, centre, 3, NULL));
        if (operation == 1)
            add_square(set, 16, 3, 9);
        const double whole = step_of(mesh, NULL, 0), part = operation < 2 ? step_of(mesh, set, 0) : 1;
        const amst_status status = operation == 0   ? amst_smooth(mesh, set, NULL, &report)
                                   : operation == 1 ? amst_insert_chords(mesh, set, 1, NULL, &report)
                                   : operation == 2 ? amst_smooth(mesh, NULL, NULL, &report)
                                   : operation == 3 ? amst_adapt(mesh, NULL, 1.5, chords, &report)
                                                    : amst_clean(mesh, NULL, &report);
        assert_true(status >= 0);
        for (size_t k = 0; k < sizeof size_keys / sizeof *size_keys; ++k)
            assert_true(isnan(real_result(report, AMST_ALL, size_keys[k])));
        assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_TIME_STEP) -
                         step_of(mesh, NULL, 0) / whole) < 1e-9);
        if (operation >= 2) {
            assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_ASPECT_RATIO_BEFORE) - aspect) <
                        1e-12);
            assert_true(fabs(real_result(report, AMST_ALL, AMST_RESULT_ASPECT_RATIO_AFTER) -
                             aspect_of(mesh)) < 1e-12);
        } else {
            assert_true(real_result(report, 0, AMST_RESULT_ASPECT_RATIO_AFTER) >= 1);
            assert_true(isnan(real_result(report, 0, AMST_RESULT_SIZE_ERROR_AFTER)));
            assert_true(real_result(report, 0, AMST_RESULT_TIME_STEP) != 1);
            assert_true(fabs(real_result(report, 0, AMST_RESULT_TIME_STEP) - step_of(mesh, set, 0) / part) <
                        1e-9);
        }
        amst_report_destroy(report);
        amst_patches_destroy(set);
        amst_mesh_destroy(mesh);
    }
    amst_options_destroy(chords);
    amst_context_destroy(ctx);
}

/* Edges whose vertices both stayed come from the edge between the old ones. */
static void edge_origins_fit_vertex_origins(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 8, 8), *old = NULL;
    amst_patches *set = NULL;
    amst_report *report = NULL;
    must(amst_mesh_clone(mesh, &old));
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 8, 2, 6);
    must(amst_adapt(mesh, set, 1.5, NULL, &report));
    const int64_t n_edges = count_of(mesh, AMST_EDGE), n_old = count_of(old, AMST_EDGE);
    int64_t n, kept = 0;
    amst_id *vertex_origin = origin_of(report, AMST_VERTEX), *edge_origin = origin_of(report, AMST_EDGE);
    amst_id *edges = memory(sizeof(amst_id) * 2 * (size_t)n_edges);
    must(amst_report_get_origin(report, AMST_EDGE, NULL, 0, &n));
    assert_int_equal(n, n_edges);
    must(amst_mesh_get_edges(mesh, edges, 2 * n_edges, &n));
    for (int64_t e = 0; e < n_edges; ++e)
        if (edge_origin[e] != -1) {
            amst_id pair[2] = {vertex_origin[edges[2 * e]], vertex_origin[edges[2 * e + 1]]}, found = -1;
            must(amst_mesh_find_edges(old, pair, 1, &found));
            assert_int_equal(edge_origin[e], found);
            ++kept;
        }
    assert_int_equal(kept, n_old - 24); /* all but those inside the 4 x 4 square */
    free(edges);
    free(vertex_origin);
    free(edge_origin);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(old);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* Whatever is done, no origin is named twice, and what has one has the vertices that it had. */
static void nothing_is_named_twice(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    for (int operation = 0; operation < 5; ++operation) {
        amst_mesh *mesh = new_grid(ctx, 0, 8, 8);
        amst_report *report = NULL;
        amst_id *before = faces_of(mesh);
        const amst_status status = operation == 0   ? amst_split_chord(mesh, 0, 2, options, &report)
                                   : operation == 1 ? amst_collapse_chord(mesh, 0, options, &report)
                                   : operation == 2 ? amst_adapt(mesh, NULL, 2, options, &report)
                                   : operation == 3 ? amst_adapt(mesh, NULL, 0.5, options, &report)
                                                    : amst_smooth(mesh, NULL, options, &report);
        assert_true(status >= 0);
        const int32_t entities[3] = {AMST_VERTEX, AMST_EDGE, AMST_FACE};
        for (int k = 0; k < 3; ++k) {
            amst_id *origin = origin_of(report, entities[k]);
            char named[144] = {0};
            for (int64_t i = 0; i < count_of(mesh, entities[k]); ++i)
                if (origin[i] != -1) {
                    assert_int_equal(named[origin[i]], 0);
                    named[origin[i]] = 1;
                }
            free(origin);
        }
        amst_id *faces = faces_of(mesh), *face = origin_of(report, AMST_FACE),
                *vertex = origin_of(report, AMST_VERTEX);
        for (int64_t f = 0; f < count_of(mesh, AMST_FACE); ++f)
            for (int k = 0; face[f] != -1 && k < 4; ++k)
                assert_int_equal(vertex[faces[4 * f + k]], before[4 * face[f] + k]);
        free(before);
        free(faces);
        free(face);
        free(vertex);
        amst_report_destroy(report);
        amst_mesh_destroy(mesh);
    }
    amst_options_destroy(options);
    amst_context_destroy(ctx);
}

/* A patch that its boundary does not allow the count: the nearest, and the words for it. */
static void what_was_in_the_way_is_told(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 12, 12);
    amst_patches *set = NULL;
    amst_report *report = NULL;
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 12, 0, 2);
    add_square(set, 12, 4, 10);
    must(amst_patches_set_alpha(set, 0, 1));
    assert_int_equal(amst_adapt(mesh, set, 0.01, NULL, &report), AMST_PARTIAL);
    assert_int_equal((int)result(report, 1, AMST_RESULT_STATUS), AMST_PARTIAL);
    assert_non_null(strstr(amst_last_error(), "patch 1: "));
    assert_non_null(strstr(amst_last_error(), "the nearest number of faces is"));
    int32_t entity;
    amst_id id, patch;
    must(amst_last_error_where(&entity, &id, &patch));
    assert_int_equal(entity, AMST_ENTITY_NONE);
    assert_int_equal(patch, 1);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_outlives_mesh_and_patches),
        cmocka_unit_test(what_was_in_the_way_is_told),
        cmocka_unit_test(sizes_of_patches_are_summed_up),
        cmocka_unit_test(sizes_of_a_whole_mesh),
        cmocka_unit_test(sizes_of_a_whole_mesh_that_stays),
        cmocka_unit_test(without_wanted_sizes_they_are_nan),
        cmocka_unit_test(edge_origins_fit_vertex_origins),
        cmocka_unit_test(nothing_is_named_twice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
