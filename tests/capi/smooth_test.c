/* amst_smooth: only positions of interior vertices that are free. */
#include "grid.h"

enum { n = 8, row = n + 1 };

static amst_context *ctx;
static amst_mesh *mesh;

/* Every second interior vertex is pushed aside. */
static int setup(void **state) {
    (void)state;
    ctx = new_context(0);
    mesh = new_grid(ctx, 0, n, n);
    double *points = points_of(mesh);
    for (int j = 1; j < n; ++j)
        for (int i = 1; i < n; ++i)
            if ((i + j) % 2 == 0) {
                points[2 * (j * row + i)] += 0.35;
                points[2 * (j * row + i) + 1] -= 0.3;
            }
    must(amst_mesh_set_points(mesh, points, row * row));
    free(points);
    return 0;
}

static int teardown(void **state) {
    (void)state;
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
    return 0;
}

static void a_whole_mesh_improves(void **state) {
    (void)state;
    amst_report *report = NULL;
    const double before = worst_scaled_jacobian(mesh);
    const amst_id held = 4 * row + 4;
    must(amst_mesh_set_flags(mesh, AMST_VERTEX, &held, 1, AMST_FLAG_FIXED, AMST_FLAG_FIXED));
    snapshot taken = take_snapshot(mesh);
    must(amst_smooth(mesh, NULL, NULL, &report));
    assert_true(worst_scaled_jacobian(mesh) > before);
    assert_int_equal(revision(mesh), 0);
    amst_id *faces = faces_of(mesh), *origin = origin_of(report, AMST_VERTEX);
    double *points = points_of(mesh);
    assert_memory_equal(faces, taken.faces, sizeof(amst_id) * 4 * n * n);
    for (int v = 0; v < row * row; ++v) {
        const int i = v % row, j = v / row;
        assert_int_equal(origin[v], v);
        if (i == 0 || j == 0 || i == n || j == n || v == held)
            assert_memory_equal(points + 2 * v, taken.points + 2 * v, 2 * sizeof(double));
    }
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_BEFORE), n * n);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_AFTER), n * n);
    assert_true(real_result(report, AMST_ALL, AMST_RESULT_ALPHA) == 1);
    int64_t value;
    refused(AMST_ERR_RANGE, amst_report_get_int(report, 0, AMST_RESULT_STATUS, &value)); /* no patches */
    free(faces);
    free(origin);
    free(points);
    free_snapshot(&taken);
    amst_report_destroy(report);
}

static void only_the_inside_of_patches_moves(void **state) {
    (void)state;
    amst_patches *set = NULL;
    amst_report *report = NULL;
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, n, 2, 6);
    snapshot taken = take_snapshot(mesh);
    must(amst_smooth(mesh, set, NULL, &report));
    must(amst_mesh_check(mesh));
    double *points = points_of(mesh);
    int moved = 0;
    for (int v = 0; v < row * row; ++v) {
        const int i = v % row, j = v / row;
        const int same = memcmp(points + 2 * v, taken.points + 2 * v, 2 * sizeof(double)) == 0;
        if (i > 2 && i < 6 && j > 2 && j < 6)
            moved += !same;
        else
            assert_true(same);
    }
    assert_true(moved > 0);
    int32_t defects; /* the set is still current */
    must(amst_patches_check(set, 0, &defects, NULL));
    assert_true(real_result(report, 0, AMST_RESULT_QUALITY_AFTER) >=
                real_result(report, 0, AMST_RESULT_QUALITY_BEFORE));
    free(points);
    free_snapshot(&taken);
    amst_report_destroy(report);
    amst_patches_destroy(set);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_whole_mesh_improves, setup, teardown),
        cmocka_unit_test_setup_teardown(only_the_inside_of_patches_moves, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
