/* A mesh read from .amst is the one that was written: whatever follows is the same to the last bit. */
#include <stdio.h>

#include "grid.h"

static const char path[] = "capi_checkpoint.amst";

static amst_mesh *written_and_read(amst_context *ctx, const amst_mesh *mesh) {
    amst_mesh *back = NULL;
    must(amst_mesh_write(mesh, path));
    must(amst_mesh_read(ctx, path, NULL, &back));
    assert_int_equal(remove(path), 0);
    return back;
}

typedef amst_status (*ids_function)(const amst_mesh *, amst_id *, int64_t, int64_t *);

static void assert_same_ids(const amst_mesh *a, const amst_mesh *b, ids_function get) {
    int64_t n = 0, same = 0;
    must(get(a, NULL, 0, &n));
    must(get(b, NULL, 0, &same));
    assert_int_equal(n, same);
    amst_id *first = memory(sizeof(amst_id) * (size_t)n), *second = memory(sizeof(amst_id) * (size_t)n);
    must(get(a, first, n, &n));
    must(get(b, second, n, &n));
    assert_memory_equal(first, second, sizeof(amst_id) * (size_t)n);
    free(first);
    free(second);
}

static void assert_same_field(const amst_mesh *a, const amst_mesh *b, int32_t entity, const char *name) {
    int64_t n = 0, same = 0;
    must(amst_mesh_get_field(a, entity, name, NULL, 0, &n));
    must(amst_mesh_get_field(b, entity, name, NULL, 0, &same));
    assert_int_equal(n, same);
    double *first = memory(sizeof(double) * (size_t)n), *second = memory(sizeof(double) * (size_t)n);
    must(amst_mesh_get_field(a, entity, name, first, n, &n));
    must(amst_mesh_get_field(b, entity, name, second, n, &n));
    assert_memory_equal(first, second, sizeof(double) * (size_t)n);
    free(first);
    free(second);
}

static void assert_same(const amst_mesh *a, const amst_mesh *b) {
    assert_true(checksum(a) == checksum(b));
    assert_int_equal(revision(a), revision(b));
    assert_same_ids(a, b, amst_mesh_get_faces);
    assert_same_ids(a, b, amst_mesh_get_edges);
    assert_same_ids(a, b, amst_mesh_get_edge_faces);
    assert_same_ids(a, b, amst_mesh_get_crossed_edges);
}

static void adapt_both(amst_mesh *a, amst_mesh *b, double alpha, const amst_options *options) {
    const amst_status first = amst_adapt(a, NULL, alpha, options, NULL);
    assert_true(first >= 0);
    assert_int_equal(amst_adapt(b, NULL, alpha, options, NULL), first);
    assert_same(a, b);
}

static void in_a_plane_with_a_boundary_that_changes(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    amst_options *options = NULL;
    amst_mesh *mesh = new_grid(ctx, 1, 12, 9), *back;
    const amst_id rim[2] = {1, 2}, corner = 1, region[3] = {5, 6, 7};
    double *heat = memory(sizeof(double) * 130), *load = memory(sizeof(double) * 2 * 108);
    amst_id edge = 0;
    char name[16];
    int64_t needed = 0;
    for (int v = 0; v < 130; ++v)
        heat[v] = 1.0 / (v + 3);
    for (int f = 0; f < 216; ++f)
        load[f] = f / 7.0;
    must(amst_mesh_find_edges(mesh, rim, 1, &edge));
    must(amst_mesh_set_markers(mesh, AMST_EDGE, &edge, 1, 7));
    must(amst_mesh_set_markers(mesh, AMST_FACE, region, 3, -4));
    must(amst_mesh_set_marker_name(mesh, AMST_EDGE, 7, "in\xc3\xa9t"));
    must(amst_mesh_set_flags(mesh, AMST_VERTEX, &corner, 1, AMST_FLAG_CORNER, AMST_FLAG_CORNER));
    must(amst_mesh_set_flags(mesh, AMST_FACE, region, 1, AMST_FLAG_FIXED, AMST_FLAG_FIXED));
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "heat", 1, AMST_CARRY_LINEAR, heat, 130));
    must(amst_mesh_set_field(mesh, AMST_FACE, "load", 2, AMST_CARRY_CONSERVE, load, 108));
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    assert_true(amst_adapt(mesh, NULL, 0.6, options, NULL) >= 0);
    assert_true(revision(mesh) > 0);
    back = written_and_read(ctx, mesh);
    assert_same(mesh, back);
    must(amst_mesh_get_marker_name(back, AMST_EDGE, 7, name, sizeof name, &needed));
    assert_string_equal(name, "in\xc3\xa9t");
    adapt_both(mesh, back, 2.5, options);
    assert_same_field(mesh, back, AMST_VERTEX, "heat");
    assert_same_field(mesh, back, AMST_FACE, "load");
    adapt_both(mesh, back, 0.7, options);
    assert_same_field(mesh, back, AMST_FACE, "load");
    amst_mesh_destroy(back);
    amst_mesh_destroy(mesh);
    amst_options_destroy(options);
    amst_context_destroy(ctx);
    free(heat);
    free(load);
}

/* A roof over a grid: bent, with a ridge that is a feature. */
static amst_mesh *new_roof(amst_context *ctx) {
    enum { n = 10, n_vertices = (n + 1) * (n + 1) };
    double *plane = grid_points(n, n), *points = memory(sizeof(double) * 3 * n_vertices);
    int32_t *faces = grid_faces(n, n, 0);
    amst_mesh *mesh = NULL;
    int64_t found = 0;
    for (int v = 0; v < n_vertices; ++v) {
        const double x = plane[2 * v], y = plane[2 * v + 1], off = x > 5 ? x - 5 : 5 - x;
        points[3 * v] = x;
        points[3 * v + 1] = y;
        points[3 * v + 2] = 0.02 * y * y - 0.9 * off;
    }
    must(amst_mesh_create(ctx, 3, points, n_vertices, 0, 0, faces, n * n, 0, 0, 4, NULL, &mesh));
    must(amst_mesh_detect_features(mesh, 40, &found));
    assert_int_equal(found, n);
    free(plane);
    free(points);
    free(faces);
    return mesh;
}

static void on_a_surface_with_a_feature(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_roof(ctx), *back;
    assert_true(amst_adapt(mesh, NULL, 1.7, NULL, NULL) >= 0); /* keeps the surface that was there */
    back = written_and_read(ctx, mesh);
    assert_same(mesh, back);
    adapt_both(mesh, back, 0.8, NULL);
    adapt_both(mesh, back, 1.9, NULL);
    amst_mesh_destroy(back);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void a_damaged_file_names_the_byte(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 3, 3), *back = NULL;
    must(amst_mesh_write(mesh, path));
    FILE *file = fopen(path, "r+b");
    assert_non_null(file);
    assert_int_equal(fseek(file, 200, SEEK_SET), 0);
    assert_int_equal(fputc('x', file), 'x');
    assert_int_equal(fclose(file), 0);
    refused(AMST_ERR_FORMAT, amst_mesh_read(ctx, path, NULL, &back));
    assert_null(back);
    assert_non_null(strstr(amst_last_error(), "byte "));
    assert_int_equal(remove(path), 0);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_a_plane_with_a_boundary_that_changes),
        cmocka_unit_test(on_a_surface_with_a_feature),
        cmocka_unit_test(a_damaged_file_names_the_byte),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
