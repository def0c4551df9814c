/* FIXED, FEATURE and CORNER on vertices, edges and faces. */
#include "grid.h"

static void bits_are_set_under_the_mask(void **state) {
    (void)state;
    const int32_t entities[] = {AMST_VERTEX, AMST_EDGE, AMST_FACE};
    amst_context *ctx = new_context(1);
    amst_mesh *mesh = new_grid(ctx, 1, 3, 3);
    for (size_t k = 0; k < 3; ++k) {
        const int32_t entity = entities[k];
        const int64_t n = count_of(mesh, entity);
        int64_t needed;
        int32_t *flags = memory(sizeof(int32_t) * (size_t)n);
        const amst_id ids[2] = {1, 9};
        must(amst_mesh_set_flags(mesh, entity, ids, 2, AMST_FLAG_FIXED | AMST_FLAG_CORNER,
                                 AMST_FLAG_FIXED | AMST_FLAG_CORNER | AMST_FLAG_FEATURE));
        must(amst_mesh_get_flags(mesh, entity, flags, n, &needed));
        assert_int_equal(needed, n);
        for (int64_t i = 0; i < n; ++i)
            assert_int_equal(flags[i], i == 0 || i == 8 ? AMST_FLAG_FIXED | AMST_FLAG_CORNER : 0);
        must(amst_mesh_set_flags(mesh, entity, NULL, 0, AMST_FLAG_FEATURE, AMST_FLAG_FEATURE));
        must(amst_mesh_set_flags(mesh, entity, ids, 1, AMST_FLAG_FIXED, 0));
        must(amst_mesh_get_flags(mesh, entity, flags, n, &needed));
        assert_int_equal(flags[0], AMST_FLAG_CORNER | AMST_FLAG_FEATURE);
        assert_int_equal(flags[1], AMST_FLAG_FEATURE);
        assert_int_equal(flags[8], AMST_FLAG_CORNER | AMST_FLAG_FEATURE | AMST_FLAG_FIXED);
        free(flags);
    }
    assert_int_equal(revision(mesh), 0);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void bad_arguments_change_nothing(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    amst_mesh *mesh = new_grid(ctx, 1, 3, 3);
    const int64_t before = checksum(mesh);
    const amst_id last_is_bad[3] = {1, 2, 17}, zero[1] = {0};
    refused(AMST_ERR_RANGE, amst_mesh_set_flags(mesh, AMST_VERTEX, last_is_bad, 3, 1, 1));
    assert_error_names(AMST_VERTEX, 17);
    refused(AMST_ERR_RANGE, amst_mesh_set_flags(mesh, AMST_FACE, zero, 1, 1, 1));
    assert_error_names(AMST_FACE, 0);
    refused(AMST_ERR_RANGE, amst_mesh_set_flags(mesh, AMST_FACE, last_is_bad, -1, 1, 1));
    refused(AMST_ERR_RANGE, amst_mesh_set_flags(mesh, AMST_FACE, NULL, 0, 8, 8));
    refused(AMST_ERR_RANGE, amst_mesh_set_flags(mesh, AMST_FACE, NULL, 0, 1, 256));
    refused(AMST_ERR_RANGE, amst_mesh_set_flags(mesh, AMST_FACE, NULL, 0, -1, 1));
    refused(AMST_ERR_ARGUMENT, amst_mesh_set_flags(mesh, 3, NULL, 0, 1, 1));
    refused(AMST_ERR_ARGUMENT, amst_mesh_set_flags(mesh, AMST_ENTITY_NONE, NULL, 0, 1, 1));
    must(amst_mesh_set_flags(mesh, AMST_VERTEX, last_is_bad, 0, 1, 1));
    assert_true(checksum(mesh) == before);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bits_are_set_under_the_mask),
        cmocka_unit_test(bad_arguments_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
