/* Whole meshes: amst_adapt and amst_reduce_singularities without patches. */
#include <math.h>

#include "grid.h"

static double *boundary_of(const amst_mesh *mesh, int64_t *n) {
    const int64_t edges = count_of(mesh, AMST_EDGE);
    amst_id *faces = memory((size_t)edges * 2 * sizeof *faces);
    amst_id *ends = memory((size_t)edges * 2 * sizeof *ends);
    int64_t needed;
    must(amst_mesh_get_edge_faces(mesh, faces, 2 * edges, &needed));
    must(amst_mesh_get_edges(mesh, ends, 2 * edges, &needed));
    double *points = points_of(mesh), *sum = memory(3 * sizeof *sum);
    sum[0] = sum[1] = sum[2] = 0;
    *n = 0;
    for (int64_t e = 0; e < edges; ++e)
        if (faces[2 * e] < 0 || faces[2 * e + 1] < 0) {
            ++*n;
            for (int k = 0; k < 2; ++k) {
                const double *p = points + 2 * ends[2 * e + k];
                sum[0] += p[0];
                sum[1] += p[1];
                sum[2] += p[0] * p[0] + 3 * p[1] * p[1];
            }
        }
    free(faces);
    free(ends);
    free(points);
    return sum;
}

static void the_count_is_exact_and_the_boundary_stays(void **state) {
    (void)state;
    const double alphas[] = {0.8, 1, 1.5};
    for (size_t k = 0; k < sizeof alphas / sizeof *alphas; ++k) {
        amst_context *ctx = new_context(0);
        amst_mesh *mesh = new_disturbed(ctx, 24);
        amst_report *report = NULL;
        const int64_t faces = count_of(mesh, AMST_FACE), singular = n_singular(mesh);
        const int64_t wanted = (int64_t)lround(alphas[k] * (double)faces);
        int64_t n_before, n_after;
        double *before = boundary_of(mesh, &n_before);
        must(amst_adapt(mesh, NULL, alphas[k], NULL, &report));
        must(amst_mesh_check(mesh));
        double *after = boundary_of(mesh, &n_after);
        assert_int_equal(n_after, n_before);
        for (int i = 0; i < 3; ++i)
            assert_true(fabs(after[i] - before[i]) < 1e-9);
        assert_int_equal(count_of(mesh, AMST_FACE), wanted);
        assert_int_equal(result(report, AMST_ALL, AMST_RESULT_STATUS), AMST_OK);
        assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_BEFORE), faces);
        assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_WANTED), wanted);
        assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_AFTER), wanted);
        assert_int_equal(result(report, AMST_ALL, AMST_RESULT_SINGULAR_BEFORE), singular);
        assert_int_equal(result(report, AMST_ALL, AMST_RESULT_SINGULAR_AFTER), n_singular(mesh));
        if (alphas[k] == 1)
            assert_true(n_singular(mesh) < singular);
        assert_true(worst_scaled_jacobian(mesh) > 0.2);
        int64_t value;
        assert_int_equal(amst_report_get_int(report, 0, AMST_RESULT_STATUS, &value), AMST_ERR_RANGE);
        free(before);
        free(after);
        amst_report_destroy(report);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

static void reduction_takes_singularities_away(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_disturbed(ctx, 20);
    const int64_t faces = count_of(mesh, AMST_FACE), singular = n_singular(mesh);
    must(amst_reduce_singularities(mesh, NULL, NULL, NULL));
    must(amst_mesh_check(mesh));
    assert_true(n_singular(mesh) < singular);
    assert_true(llabs(count_of(mesh, AMST_FACE) - faces) <= faces / 25 + 8);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void equal_for_any_number_of_threads(void **state) {
    (void)state;
    int64_t digests[3];
    const int32_t threads[] = {1, 2, 8};
    for (int k = 0; k < 3; ++k) {
        amst_context *ctx = new_context(0);
        must(amst_context_set_threads(ctx, threads[k]));
        amst_mesh *mesh = new_disturbed(ctx, 30);
        must(amst_adapt(mesh, NULL, 1, NULL, NULL));
        digests[k] = checksum(mesh);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
    assert_true(digests[1] == digests[0]);
    assert_true(digests[2] == digests[0]);
}

static int stop_at(void *user, double fraction, const char *stage) {
    (void)stage;
    return fraction >= *(const double *)user;
}

static void a_cancelled_call_leaves_the_mesh(void **state) {
    (void)state;
    const double stops[] = {0, 0.05, 0.4, 0.9, 1};
    for (size_t k = 0; k < sizeof stops / sizeof *stops; ++k) {
        double stop = stops[k];
        amst_context *ctx = new_context(0);
        amst_mesh *mesh = new_disturbed(ctx, 20);
        const int64_t digest = checksum(mesh), at = revision(mesh);
        must(amst_context_set_progress(ctx, stop_at, &stop));
        refused(AMST_ERR_CANCELLED, amst_adapt(mesh, NULL, 1.5, NULL, NULL));
        assert_true(checksum(mesh) == digest);
        assert_int_equal(revision(mesh), at);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

static void a_curved_mesh_keeps_to_itself(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = NULL;
    const double points[] = {0, 0, 0, 1, 0, 0, 2, 0, 1, 0, 1, 0, 1, 1, 0, 2, 1, 1};
    const int32_t faces[] = {0, 1, 4, 3, 1, 2, 5, 4};
    must(amst_mesh_create(ctx, 3, points, 6, 0, 0, faces, 2, 0, 0, 4, NULL, &mesh));
    must(amst_reduce_singularities(mesh, NULL, NULL, NULL));
    double after[18];
    int64_t needed = 0;
    must(amst_mesh_get_points(mesh, after, 18, &needed));
    for (int i = 0; i < 18; ++i)
        assert_true(after[i] == points[i]);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_count_is_exact_and_the_boundary_stays),
        cmocka_unit_test(reduction_takes_singularities_away),
        cmocka_unit_test(equal_for_any_number_of_threads),
        cmocka_unit_test(a_cancelled_call_leaves_the_mesh),
        cmocka_unit_test(a_curved_mesh_keeps_to_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
