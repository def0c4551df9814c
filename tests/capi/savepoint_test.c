/* mark, rollback, forget. */
#include "grid.h"

static void adapt_middle(amst_mesh *mesh, double alpha) {
    amst_patches *set = NULL;
    must(amst_patches_create(mesh, NULL, &set));
    must(amst_patches_add_rings(set, 60, 2, NULL));
    assert_true(amst_adapt(mesh, set, alpha, NULL, NULL) >= 0);
    amst_patches_destroy(set);
}

static void rollback_returns_to_the_mesh_and_its_number(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 10, 10);
    const int64_t before = checksum(mesh);
    int64_t mark = -1;
    must(amst_mesh_mark(mesh, &mark));
    assert_int_equal(mark, revision(mesh));
    adapt_middle(mesh, 2);
    const int64_t first = revision(mesh);
    assert_true(first > mark);
    must(amst_mesh_rollback(mesh, mark));
    assert_true(checksum(mesh) == before);
    assert_int_equal(revision(mesh), mark);
    adapt_middle(mesh, 2);
    assert_true(revision(mesh) > first);  /* a number is never used twice */
    must(amst_mesh_rollback(mesh, mark)); /* the savepoint stays */
    assert_true(checksum(mesh) == before);
    must(amst_mesh_forget(mesh, mark));
    refused(AMST_ERR_NOT_FOUND, amst_mesh_rollback(mesh, mark));
    refused(AMST_ERR_NOT_FOUND, amst_mesh_forget(mesh, mark));
    assert_true(checksum(mesh) == before);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void savepoints_nest(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 10, 10);
    int64_t outer, inner;
    const int64_t at_outer = checksum(mesh);
    must(amst_mesh_mark(mesh, &outer));
    adapt_middle(mesh, 2);
    const int64_t at_inner = checksum(mesh);
    must(amst_mesh_mark(mesh, &inner));
    adapt_middle(mesh, 1.5);
    must(amst_mesh_rollback(mesh, inner));
    assert_true(checksum(mesh) == at_inner);
    must(amst_mesh_rollback(mesh, outer));
    assert_true(checksum(mesh) == at_outer);
    refused(AMST_ERR_NOT_FOUND, amst_mesh_rollback(mesh, inner)); /* later ones are forgotten */
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void points_and_flags_come_back(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 4, 4);
    double *points = points_of(mesh);
    int64_t first, second;
    const int64_t at_first = checksum(mesh);
    must(amst_mesh_mark(mesh, &first));
    points[2 * 6] += 0.125;
    must(amst_mesh_set_points(mesh, points, 25));
    must(amst_mesh_set_flags(mesh, AMST_FACE, NULL, 0, 1, 1));
    const int64_t at_second = checksum(mesh);
    must(amst_mesh_mark(mesh, &second));
    assert_int_equal(first, second); /* the connectivity is the same; the inner one answers first */
    points[2 * 6] += 0.125;
    must(amst_mesh_set_points(mesh, points, 25));
    must(amst_mesh_rollback(mesh, second));
    assert_true(checksum(mesh) == at_second);
    must(amst_mesh_forget(mesh, second));
    must(amst_mesh_rollback(mesh, first));
    assert_true(checksum(mesh) == at_first);
    free(points);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void patches_are_stale_until_their_revision_returns(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 10, 10);
    amst_patches *set = NULL;
    int64_t mark, n;
    int32_t defects;
    must(amst_patches_create(mesh, NULL, &set));
    must(amst_patches_add_rings(set, 24, 1, NULL));
    must(amst_mesh_mark(mesh, &mark));
    adapt_middle(mesh, 2);
    refused(AMST_ERR_STALE, amst_patches_get_faces(set, 0, NULL, 0, &n));
    refused(AMST_ERR_STALE, amst_patches_check(set, 0, &defects, NULL));
    refused(AMST_ERR_STALE, amst_patches_add_rings(set, 24, 1, NULL));
    refused(AMST_ERR_STALE, amst_adapt(mesh, set, 2, NULL, NULL));
    refused(AMST_ERR_STALE, amst_smooth(mesh, set, NULL, NULL));
    must(amst_mesh_rollback(mesh, mark));
    must(amst_patches_get_faces(set, 0, NULL, 0, &n));
    assert_int_equal(n, 4);
    assert_true(amst_adapt(mesh, set, 2, NULL, NULL) >= 0);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rollback_returns_to_the_mesh_and_its_number),
        cmocka_unit_test(savepoints_nest),
        cmocka_unit_test(points_and_flags_come_back),
        cmocka_unit_test(patches_are_stale_until_their_revision_returns),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
