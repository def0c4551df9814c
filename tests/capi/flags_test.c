/* FIXED, FEATURE and CORNER on vertices, edges and faces. */
#include <math.h>

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

/* 4 x 3 squares, folded upwards by 45 degrees along the third column of vertices. */
static amst_mesh *new_fold(amst_context *ctx) {
    double points[60];
    int32_t *faces = grid_faces(4, 3, 1);
    amst_mesh *mesh = NULL;
    for (int v = 0; v < 20; ++v) {
        const int beyond = v % 5 > 2 ? v % 5 - 2 : 0;
        points[3 * v] = v % 5;
        points[3 * v + 1] = v / 5;
        points[3 * v + 2] = beyond;
    }
    must(amst_mesh_create(ctx, 3, points, 20, 0, 0, faces, 12, 0, 0, 4, NULL, &mesh));
    free(faces);
    return mesh;
}

static void assert_fold(const amst_mesh *mesh, int32_t fixed_edges) {
    int32_t vertices[20], edges[31];
    amst_id ends[62];
    int64_t n;
    must(amst_mesh_get_flags(mesh, AMST_VERTEX, vertices, 20, &n));
    for (int v = 0; v < 20; ++v)
        assert_int_equal(vertices[v], v == 2 || v == 17 ? AMST_FLAG_CORNER : 0);
    must(amst_mesh_get_flags(mesh, AMST_EDGE, edges, 31, &n));
    must(amst_mesh_get_edges(mesh, ends, 62, &n));
    for (int e = 0; e < 31; ++e) {
        const int on_fold = ends[2 * e] % 5 == 3 && ends[2 * e + 1] % 5 == 3;
        assert_int_equal(edges[e], fixed_edges | (on_fold ? AMST_FLAG_FEATURE : 0));
    }
}

static void features_are_where_faces_meet_at_an_angle(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    amst_mesh *mesh = new_fold(ctx);
    int64_t found = -1, mark;
    const int64_t before = checksum(mesh);
    must(amst_mesh_mark(mesh, &mark));
    must(amst_mesh_detect_features(mesh, 46, &found));
    assert_int_equal(found, 0);
    assert_true(checksum(mesh) == before);
    must(amst_mesh_detect_features(mesh, 44, &found));
    assert_int_equal(found, 3);
    assert_fold(mesh, 0);
    must(amst_mesh_rollback(mesh, mark));
    assert_true(checksum(mesh) == before);
    must(amst_mesh_set_flags(mesh, AMST_EDGE, NULL, 0, AMST_FLAG_FIXED, AMST_FLAG_FIXED));
    must(amst_mesh_detect_features(mesh, 0, NULL)); /* other flags stay, and the plane parts have none */
    assert_fold(mesh, AMST_FLAG_FIXED);
    must(amst_mesh_detect_features(mesh, 180, &found)); /* flags of before stay */
    assert_int_equal(found, 0);
    assert_fold(mesh, AMST_FLAG_FIXED);
    assert_int_equal(revision(mesh), 0);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void an_angle_is_between_0_and_180(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    amst_mesh *mesh = new_fold(ctx);
    const int64_t before = checksum(mesh);
    int64_t found = -7;
    refused(AMST_ERR_RANGE, amst_mesh_detect_features(mesh, -1e-9, &found));
    refused(AMST_ERR_RANGE, amst_mesh_detect_features(mesh, 180.5, &found));
    refused(AMST_ERR_NOT_FINITE, amst_mesh_detect_features(mesh, NAN, &found));
    refused(AMST_ERR_NOT_FINITE, amst_mesh_detect_features(mesh, INFINITY, &found));
    assert_int_equal(found, -7);
    assert_true(checksum(mesh) == before);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bits_are_set_under_the_mask),
        cmocka_unit_test(bad_arguments_change_nothing),
        cmocka_unit_test(features_are_where_faces_meet_at_an_angle),
        cmocka_unit_test(an_angle_is_between_0_and_180),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
