/* Metrics of faces and their summary. */
#include <math.h>

#include "grid.h"

static void unit_squares_are_ideal(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 3, 2);
    const struct {
        int32_t metric;
        double value;
    } ideal[] = {
        {AMST_METRIC_AREA, 1},         {AMST_METRIC_ASPECT_RATIO, 1},   {AMST_METRIC_CONDITION, 1},
        {AMST_METRIC_DISTORTION, 1},   {AMST_METRIC_EDGE_RATIO, 1},     {AMST_METRIC_JACOBIAN, 1},
        {AMST_METRIC_MAX_ANGLE, 90},   {AMST_METRIC_MIN_ANGLE, 90},     {AMST_METRIC_ODDY, 0},
        {AMST_METRIC_RADIUS_RATIO, 1}, {AMST_METRIC_RELATIVE_SIZE, 1},  {AMST_METRIC_SCALED_JACOBIAN, 1},
        {AMST_METRIC_SHAPE, 1},        {AMST_METRIC_SHAPE_AND_SIZE, 1}, {AMST_METRIC_SHEAR, 1},
        {AMST_METRIC_SKEW, 0},         {AMST_METRIC_SHEAR_AND_SIZE, 1}, {AMST_METRIC_STRETCH, 1},
        {AMST_METRIC_TAPER, 0},        {AMST_METRIC_WARPAGE, 1},
    };
    assert_int_equal(sizeof ideal / sizeof *ideal, 20);
    for (size_t k = 0; k < 20; ++k) {
        double values[6];
        int64_t n;
        amst_summary summary;
        must(amst_mesh_get_quality(mesh, ideal[k].metric, values, 6, &n));
        assert_int_equal(n, 6);
        for (int f = 0; f < 6; ++f)
            if (fabs(values[f] - ideal[k].value) > 1e-12)
                fail_msg("metric %d of face %d is %g", (int)ideal[k].metric, f, values[f]);
        must(amst_mesh_get_summary(mesh, ideal[k].metric, &summary));
        assert_int_equal(summary.count, 6);
        assert_int_equal(summary.acceptable, 6);
        assert_true(fabs(summary.min - ideal[k].value) <= 1e-12);
        assert_true(fabs(summary.max - ideal[k].value) <= 1e-12);
        assert_true(fabs(summary.mean - ideal[k].value) <= 1e-12);
        assert_true(summary.stddev <= 1e-12);
    }
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void summary_is_that_of_the_values(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 4, 1);
    double *points = points_of(mesh), areas[4], sum = 0, squares = 0;
    for (int v = 0; v < 10; ++v)
        points[2 * v] *= points[2 * v]; /* columns of width 1, 3, 5, 7 */
    must(amst_mesh_set_points(mesh, points, 10));
    free(points);
    int64_t n;
    amst_summary summary;
    must(amst_mesh_get_quality(mesh, AMST_METRIC_AREA, areas, 4, &n));
    for (int f = 0; f < 4; ++f) {
        assert_true(fabs(areas[f] - (2 * f + 1)) < 1e-12);
        sum += areas[f];
        squares += areas[f] * areas[f];
    }
    must(amst_mesh_get_summary(mesh, AMST_METRIC_AREA, &summary));
    assert_int_equal(summary.count, 4);
    assert_true(fabs(summary.min - 1) < 1e-12);
    assert_true(fabs(summary.max - 7) < 1e-12);
    assert_true(fabs(summary.mean - sum / 4) < 1e-12);
    assert_true(fabs(summary.stddev - sqrt(squares / 4 - sum * sum / 16)) < 1e-12);
    must(amst_mesh_get_quality(mesh, AMST_METRIC_RELATIVE_SIZE, areas, 4, &n));
    assert_true(fabs(areas[0] - 1.0 / 16) < 1e-12); /* (1 / 4)^2, the mean area is 4 */
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void there_are_no_other_metrics(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 2, 2);
    int64_t n = 77;
    amst_summary summary;
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_quality(mesh, 20, NULL, 0, &n));
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_quality(mesh, AMST_METRIC_INVALID, NULL, 0, &n));
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_summary(mesh, AMST_METRIC_MAX, &summary));
    assert_int_equal(n, 77);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* Its layout is part of the binary interface. */
static void summary_has_48_bytes(void **state) {
    (void)state;
    assert_int_equal(sizeof(amst_summary), 48);
    assert_int_equal(offsetof(amst_summary, count), 0);
    assert_int_equal(offsetof(amst_summary, acceptable), 8);
    assert_int_equal(offsetof(amst_summary, min), 16);
    assert_int_equal(offsetof(amst_summary, max), 24);
    assert_int_equal(offsetof(amst_summary, mean), 32);
    assert_int_equal(offsetof(amst_summary, stddev), 40);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unit_squares_are_ideal),
        cmocka_unit_test(summary_is_that_of_the_values),
        cmocka_unit_test(there_are_no_other_metrics),
        cmocka_unit_test(summary_has_48_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
