/* After every failing call mesh, patches and report are what they were, and no
 * output was written. */
#include <math.h>

#include "grid.h"

typedef struct world {
    amst_context *ctx;
    amst_mesh *mesh;
    amst_patches *set, *stale;
    int64_t mark;
} world;

static world new_world(void) {
    world w = {0};
    const amst_id fixed = 0;
    w.ctx = new_context(0);
    w.mesh = new_grid(w.ctx, 0, 10, 10);
    must(amst_mesh_set_flags(w.mesh, AMST_FACE, &fixed, 1, AMST_FLAG_FIXED, AMST_FLAG_FIXED));
    must(amst_mesh_mark(w.mesh, &w.mark));
    must(amst_patches_create(w.mesh, NULL, &w.stale));
    must(amst_patches_create(w.mesh, NULL, &w.set));
    add_square(w.stale, 10, 1, 4);
    add_square(w.set, 10, 2, 7);
    must(amst_adapt(w.mesh, w.set, 2, NULL, NULL));
    return w;
}

static int64_t patch_digest(const amst_patches *set) {
    int64_t n_patches, n, digest = 17;
    must(amst_patches_get_count(set, &n_patches));
    for (amst_id patch = 0; patch < n_patches; ++patch) {
        must(amst_patches_get_faces(set, patch, NULL, 0, &n));
        amst_id *faces = memory(sizeof(amst_id) * (size_t)n);
        must(amst_patches_get_faces(set, patch, faces, n, &n));
        for (int64_t i = 0; i < n; ++i)
            digest = (digest * 31 + faces[i]) % INT64_C(1000000007);
        free(faces);
        must(amst_patches_get_corners(set, patch, NULL, 0, &n));
        digest = (digest * 31 + n) % INT64_C(1000000007);
    }
    return digest * 1000 + n_patches;
}

#define unchanged(status, call)                                                                              \
    do {                                                                                                     \
        refused(status, call);                                                                               \
        assert_true(checksum(w.mesh) == digest);                                                             \
        assert_int_equal(revision(w.mesh), number);                                                          \
        assert_true(patch_digest(w.set) == patches);                                                         \
        assert_null(report);                                                                                 \
    } while (0)

static void every_failing_call(void **state) {
    (void)state;
    world w = new_world();
    const int64_t digest = checksum(w.mesh), number = revision(w.mesh), patches = patch_digest(w.set);
    const int n_vertices = (int)count_of(w.mesh, AMST_VERTEX), n_faces = (int)count_of(w.mesh, AMST_FACE);
    const amst_id far_faces[2] = {1, n_faces}, far_vertices[3] = {1, 2, n_vertices}, fixed = 0;
    const double nowhere[3] = {NAN, 0, 0}, outside[3] = {99, 99, 0};
    double *points = points_of(w.mesh);
    amst_report *report = NULL;

    points[2 * n_vertices - 1] = INFINITY;
    unchanged(AMST_ERR_NOT_FINITE, amst_mesh_set_points(w.mesh, points, n_vertices));
    unchanged(AMST_ERR_RANGE, amst_mesh_set_points(w.mesh, points, n_vertices - 1));
    unchanged(AMST_ERR_RANGE, amst_mesh_set_flags(w.mesh, AMST_FACE, far_faces, 2, 1, 1));
    unchanged(AMST_ERR_RANGE, amst_mesh_set_flags(w.mesh, AMST_VERTEX, NULL, 0, 64, 64));
    unchanged(AMST_ERR_ARGUMENT, amst_mesh_set_flags(w.mesh, 9, NULL, 0, 1, 1));
    unchanged(AMST_ERR_RANGE, amst_mesh_set_markers(w.mesh, AMST_FACE, far_faces, 2, 1));
    unchanged(AMST_ERR_ARGUMENT, amst_mesh_set_marker_name(w.mesh, AMST_FACE, 0, "a"));
    unchanged(AMST_ERR_RANGE, amst_mesh_detect_features(w.mesh, 181, NULL));
    unchanged(AMST_ERR_RANGE, amst_mesh_set_surface(w.mesh, nowhere, 1, far_vertices, 1));
    unchanged(AMST_ERR_NOT_FOUND, amst_mesh_rollback(w.mesh, number + 5));
    unchanged(AMST_ERR_NOT_FOUND, amst_mesh_forget(w.mesh, number + 5));

    unchanged(AMST_ERR_RANGE, amst_patches_add_faces(w.set, far_faces, 2, NULL));
    unchanged(AMST_ERR_PATCH, amst_patches_add_faces(w.set, &fixed, 1, NULL));
    unchanged(AMST_ERR_RANGE, amst_patches_add_rings(w.set, n_vertices, 1, NULL));
    unchanged(AMST_ERR_NOT_FINITE, amst_patches_add_ball(w.set, nowhere, 1, NULL));
    unchanged(AMST_ERR_NOT_FINITE, amst_patches_add_box(w.set, nowhere, outside, NULL));
    unchanged(AMST_ERR_PATCH, amst_patches_add_box(w.set, outside, outside, NULL));
    unchanged(AMST_ERR_ARGUMENT, amst_patches_decompose(w.set, 5, NULL));
    unchanged(AMST_ERR_RANGE, amst_patches_set_corners(w.set, 0, far_vertices, 3));
    unchanged(AMST_ERR_RANGE, amst_patches_set_corners(w.set, 0, far_vertices, 2));
    unchanged(AMST_ERR_ARGUMENT, amst_patches_set_alpha(w.set, 0, -1));

    unchanged(AMST_ERR_STALE, amst_adapt(w.mesh, w.stale, 2, NULL, &report));
    unchanged(AMST_ERR_STALE, amst_reduce_singularities(w.mesh, w.stale, NULL, &report));
    unchanged(AMST_ERR_STALE, amst_smooth(w.mesh, w.stale, NULL, &report));
    unchanged(AMST_ERR_STALE, amst_patches_set_alpha(w.stale, 0, 1));
    unchanged(AMST_ERR_ARGUMENT, amst_adapt(w.mesh, w.set, 0, NULL, &report));
    unchanged(AMST_ERR_NOT_FINITE, amst_adapt(w.mesh, w.set, NAN, NULL, &report));
    must(amst_context_set_cancel(w.ctx, 1));
    unchanged(AMST_ERR_CANCELLED, amst_adapt(w.mesh, w.set, 2, NULL, &report));
    unchanged(AMST_ERR_CANCELLED, amst_reduce_singularities(w.mesh, w.set, NULL, &report));
    unchanged(AMST_ERR_CANCELLED, amst_smooth(w.mesh, w.set, NULL, &report));
    unchanged(AMST_ERR_CANCELLED, amst_clean(w.mesh, NULL, &report));
    unchanged(AMST_ERR_CANCELLED, amst_collapse_chord(w.mesh, 0, NULL, &report));
    unchanged(AMST_ERR_CANCELLED, amst_split_chord(w.mesh, 0, 1, NULL, &report));
    must(amst_context_set_cancel(w.ctx, 0));

    must(amst_mesh_rollback(w.mesh, w.mark)); /* still there */
    free(points);
    amst_patches_destroy(w.set);
    amst_patches_destroy(w.stale);
    amst_mesh_destroy(w.mesh);
    amst_context_destroy(w.ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_failing_call)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
