/* What a mesh is asked, its new points, its clone and its check. */
#include <math.h>

#include "grid.h"

enum { nx = 4, ny = 3, n_vertices = 20, n_faces = 12 };

static amst_status create(amst_context *ctx, int32_t dim, const double *points, int64_t nv,
                          const int32_t *faces, int64_t nf, amst_mesh **out) {
    return amst_mesh_create(ctx, dim, points, nv, 0, 0, faces, nf, 0, 0, 4, NULL, out);
}

static void arrays_come_back(void **state) {
    (void)state;
    for (int32_t dim = 2; dim <= 3; ++dim) {
        amst_context *ctx = new_context(0);
        double *flat = grid_points(nx, ny), points[3 * n_vertices];
        int32_t *faces = grid_faces(nx, ny, 0), told = 0;
        for (int v = 0; v < n_vertices; ++v) {
            points[dim * v] = flat[2 * v] + 0.125;
            points[dim * v + 1] = flat[2 * v + 1];
            if (dim == 3)
                points[dim * v + 2] = 0.25 * flat[2 * v];
        }
        amst_mesh *mesh = NULL;
        must(create(ctx, dim, points, n_vertices, faces, n_faces, &mesh));
        must(amst_mesh_get_dim(mesh, &told));
        assert_int_equal(told, dim);
        assert_int_equal(count_of(mesh, AMST_VERTEX), n_vertices);
        assert_int_equal(count_of(mesh, AMST_EDGE), nx * (ny + 1) + ny * (nx + 1));
        assert_int_equal(count_of(mesh, AMST_FACE), n_faces);
        double *back = points_of(mesh);
        amst_id *faces_back = faces_of(mesh);
        assert_memory_equal(back, points, sizeof(double) * (size_t)dim * n_vertices);
        assert_memory_equal(faces_back, faces, sizeof(int32_t) * 4 * n_faces);
        must(amst_mesh_check(mesh));
        assert_int_equal(revision(mesh), 0);
        free(back);
        free(faces_back);
        free(flat);
        free(faces);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

static void new_points_keep_the_rest(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, nx, ny);
    double *points = points_of(mesh);
    const int64_t before = checksum(mesh);
    points[2 * 6] += 0.25;
    must(amst_mesh_set_points(mesh, points, n_vertices));
    assert_int_equal(revision(mesh), 0);
    assert_true(checksum(mesh) != before);
    double *back = points_of(mesh);
    assert_memory_equal(back, points, sizeof(double) * 2 * n_vertices);
    const int64_t moved = checksum(mesh);
    points[2 * n_vertices - 1] = NAN;
    refused(AMST_ERR_NOT_FINITE, amst_mesh_set_points(mesh, points, n_vertices));
    assert_error_names(AMST_VERTEX, n_vertices - 1);
    refused(AMST_ERR_RANGE, amst_mesh_set_points(mesh, points, n_vertices - 1));
    refused(AMST_ERR_RANGE, amst_mesh_set_points(mesh, points, -1));
    refused(AMST_ERR_NULL, amst_mesh_set_points(mesh, NULL, n_vertices));
    assert_true(checksum(mesh) == moved);
    free(back);
    free(points);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void a_clone_goes_its_own_way(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, nx, ny), *copy = NULL;
    must(amst_mesh_clone(mesh, &copy));
    assert_true(checksum(copy) == checksum(mesh));
    must(amst_mesh_set_flags(copy, AMST_VERTEX, NULL, 0, AMST_FLAG_FIXED, AMST_FLAG_FIXED));
    int32_t flags[n_vertices];
    int64_t n;
    must(amst_mesh_get_flags(mesh, AMST_VERTEX, flags, n_vertices, &n));
    for (int v = 0; v < n_vertices; ++v)
        assert_int_equal(flags[v], 0);
    amst_mesh_destroy(mesh);
    must(amst_mesh_check(copy));
    amst_mesh_destroy(copy);
    amst_context_destroy(ctx);
}

static void check_finds_a_face_turned_over(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    amst_mesh *mesh = new_grid(ctx, 1, nx, ny);
    must(amst_mesh_check(mesh));
    double *points = points_of(mesh);
    points[2 * 6] = 40; /* vertex 7 far outside */
    must(amst_mesh_set_points(mesh, points, n_vertices));
    assert_true(amst_mesh_check(mesh) < 0);
    int32_t entity;
    must(amst_last_error_where(&entity, NULL, NULL));
    assert_int_equal(entity, AMST_FACE);
    assert_non_null(strstr(amst_last_error(), "at vertex "));
    points[2 * 6] = points[2 * 7]; /* vertices 7 and 8 */
    points[2 * 6 + 1] = points[2 * 7 + 1];
    must(amst_mesh_set_points(mesh, points, n_vertices));
    assert_true(amst_mesh_check(mesh) < 0);
    assert_non_null(strstr(amst_last_error(), "has an edge without length, between vertices "));
    free(points);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrays_come_back),
        cmocka_unit_test(new_points_keep_the_rest),
        cmocka_unit_test(a_clone_goes_its_own_way),
        cmocka_unit_test(check_finds_a_face_turned_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
