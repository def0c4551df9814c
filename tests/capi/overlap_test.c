/* What the faces of two meshes share. */
#include <math.h>

#include "grid.h"

typedef struct {
    amst_id *before, *after;
    double *areas;
    int64_t n;
} rows;

static rows rows_of(const amst_mesh *before, const amst_mesh *after) {
    rows all = {NULL, NULL, NULL, -1};
    must(amst_mesh_get_overlap(before, after, NULL, NULL, NULL, 0, &all.n));
    const size_t n = (size_t)all.n;
    all.before = memory(sizeof(amst_id) * n);
    all.after = memory(sizeof(amst_id) * n);
    all.areas = memory(sizeof(double) * n);
    must(amst_mesh_get_overlap(before, after, all.before, all.after, all.areas, all.n, &all.n));
    return all;
}

static void release(rows all) {
    free(all.before);
    free(all.after);
    free(all.areas);
}

/* The rows of each face sum up to its area. */
static void assert_sums(const amst_mesh *mesh, const amst_id *faces, const double *areas, int64_t n,
                        int base) {
    int64_t count = count_of(mesh, AMST_FACE);
    double *wanted = memory(sizeof(double) * (size_t)count), *sums = memory(sizeof(double) * (size_t)count);
    must(amst_mesh_get_quality(mesh, AMST_METRIC_AREA, wanted, count, &count));
    for (int64_t f = 0; f < count; ++f)
        sums[f] = 0;
    for (int64_t i = 0; i < n; ++i) {
        assert_true(areas[i] > 0);
        sums[faces[i] - base] += areas[i];
    }
    for (int64_t f = 0; f < count; ++f)
        assert_true(fabs(sums[f] - wanted[f]) <= 1e-12 * wanted[f]);
    free(wanted);
    free(sums);
}

static void rows_sum_up_to_areas(void **state) {
    (void)state;
    for (int32_t base = 0; base < 2; ++base) {
        amst_context *ctx = new_context(base);
        amst_mesh *mesh = new_grid(ctx, base, 10, 10), *old = NULL;
        must(amst_mesh_clone(mesh, &old));
        assert_true(amst_adapt(mesh, NULL, 2, NULL, NULL) >= 0);
        rows all = rows_of(old, mesh);
        assert_sums(old, all.before, all.areas, all.n, base);
        assert_sums(mesh, all.after, all.areas, all.n, base);
        for (int64_t i = 1; i < all.n; ++i)
            assert_true(all.after[i - 1] < all.after[i] ||
                        (all.after[i - 1] == all.after[i] && all.before[i - 1] < all.before[i]));
        release(all);
        amst_mesh_destroy(old);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

/* Each id counts from the base of its own mesh. */
static void meshes_may_be_of_two_contexts(void **state) {
    (void)state;
    amst_context *one = new_context(0), *other = new_context(1);
    amst_mesh *before = new_grid(one, 0, 3, 2), *after = new_grid(other, 1, 3, 2);
    rows all = rows_of(before, after);
    assert_int_equal(all.n, 6);
    for (int i = 0; i < 6; ++i) {
        assert_int_equal(all.before[i], i);
        assert_int_equal(all.after[i], i + 1);
        assert_true(fabs(all.areas[i] - 1) <= 1e-15);
    }
    release(all);
    amst_mesh_destroy(before);
    amst_mesh_destroy(after);
    amst_context_destroy(one);
    amst_context_destroy(other);
}

static void what_is_wrong_is_refused(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    const double space[12] = {0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 1, 1};
    const int32_t corners[4] = {0, 1, 2, 3};
    amst_mesh *mesh = new_grid(ctx, 0, 3, 2), *curved = NULL;
    amst_id before[6] = {-7, -7, -7, -7, -7, -7}, after[6] = {-7, -7, -7, -7, -7, -7};
    double areas[6] = {-7, -7, -7, -7, -7, -7};
    int64_t n = -7;
    must(amst_mesh_create(ctx, 3, space, 4, 0, 0, corners, 1, 0, 0, 4, NULL, &curved));
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_overlap(mesh, curved, before, after, areas, 6, &n));
    assert_string_equal(amst_last_error(),
                        "before has dim 2, after has dim 3; give two meshes of one domain");
    refused(AMST_ERR_NULL, amst_mesh_get_overlap(NULL, mesh, before, after, areas, 6, &n));
    refused(AMST_ERR_NULL, amst_mesh_get_overlap(mesh, NULL, before, after, areas, 6, &n));
    refused(AMST_ERR_NULL, amst_mesh_get_overlap(mesh, mesh, NULL, after, areas, 6, &n));
    refused(AMST_ERR_NULL, amst_mesh_get_overlap(mesh, mesh, before, NULL, areas, 6, &n));
    refused(AMST_ERR_NULL, amst_mesh_get_overlap(mesh, mesh, before, after, NULL, 6, &n));
    refused(AMST_ERR_NULL, amst_mesh_get_overlap(mesh, mesh, before, after, areas, 6, NULL));
    refused(AMST_ERR_RANGE, amst_mesh_get_overlap(mesh, mesh, before, after, areas, -1, &n));
    assert_int_equal(n, -7);
    refused(AMST_ERR_BUFFER_TOO_SMALL, amst_mesh_get_overlap(mesh, mesh, before, after, areas, 5, &n));
    assert_int_equal(n, 6);
    for (int i = 0; i < 6; ++i) {
        assert_int_equal(before[i], -7);
        assert_int_equal(after[i], -7);
        assert_true(areas[i] == -7);
    }
    amst_mesh_destroy(mesh);
    amst_mesh_destroy(curved);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_sum_up_to_areas),
        cmocka_unit_test(meshes_may_be_of_two_contexts),
        cmocka_unit_test(what_is_wrong_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
