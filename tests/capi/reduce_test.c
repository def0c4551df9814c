/* amst_reduce_singularities. */
#include "grid.h"

/* alpha = 2 needs singularities in a square; the square itself needs none. */
static void a_refined_square_becomes_a_grid_again(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 10, 10);
    amst_patches *set = NULL;
    amst_report *report = NULL;
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 10, 2, 7);
    must(amst_adapt(mesh, set, 2, NULL, NULL));
    const int64_t before = n_singular(mesh), old_revision = revision(mesh);
    assert_true(before >= 4);
    snapshot taken = take_snapshot(mesh);
    must(amst_reduce_singularities(mesh, set, NULL, &report));
    must(amst_mesh_check(mesh));
    assert_true(revision(mesh) > old_revision);
    assert_int_equal(n_singular(mesh), 0);
    assert_int_equal(count_of(mesh, AMST_FACE), 100);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_SINGULAR_BEFORE), before);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_SINGULAR_AFTER), 0);
    assert_int_equal(result(report, 0, AMST_RESULT_SINGULAR_BOUND), 0);
    assert_int_equal(result(report, 0, AMST_RESULT_FACES_BEFORE), 50);
    assert_int_equal(result(report, 0, AMST_RESULT_FACES_AFTER), 25);
    assert_outside_same(&taken, mesh, report, 50);
    assert_true(worst_scaled_jacobian(mesh) > 0);
    free_snapshot(&taken);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void a_regular_patch_gets_no_singularity(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 10, 10);
    amst_patches *set = NULL;
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 10, 0, 5); /* at the boundary of the mesh */
    add_square(set, 10, 6, 9);
    must(amst_reduce_singularities(mesh, set, NULL, NULL));
    must(amst_mesh_check(mesh));
    assert_int_equal(n_singular(mesh), 0);
    assert_int_equal(count_of(mesh, AMST_FACE), 100);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_refined_square_becomes_a_grid_again),
        cmocka_unit_test(a_regular_patch_gets_no_singularity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
