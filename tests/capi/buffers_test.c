/* The array protocol of every getter: ask, short by one, exact, long. */
#include "grid.h"

static amst_mesh *mesh;
static amst_patches *set;
static amst_report *report;

typedef amst_status (*getter)(void *out, int64_t capacity, int64_t *needed);

#define GETTER(name, call)                                                                                   \
    static amst_status name(void *out, int64_t capacity, int64_t *needed) { return call; }

GETTER(points, amst_mesh_get_points(mesh, out, capacity, needed))
GETTER(faces, amst_mesh_get_faces(mesh, out, capacity, needed))
GETTER(edges, amst_mesh_get_edges(mesh, out, capacity, needed))
GETTER(edge_faces, amst_mesh_get_edge_faces(mesh, out, capacity, needed))
static int32_t offsets[1000];
GETTER(vertex_faces, amst_mesh_get_vertex_faces(mesh, offsets, out, capacity, needed))
GETTER(centroids, amst_mesh_get_geometry(mesh, AMST_GEOMETRY_CENTROIDS, out, capacity, needed))
GETTER(lengths, amst_mesh_get_geometry(mesh, AMST_GEOMETRY_LENGTHS, out, capacity, needed))
GETTER(normals, amst_mesh_get_geometry(mesh, AMST_GEOMETRY_NORMALS, out, capacity, needed))
GETTER(valences, amst_mesh_get_valences(mesh, out, capacity, needed))
GETTER(singularities, amst_mesh_get_singularities(mesh, out, capacity, needed))
GETTER(vertex_flags, amst_mesh_get_flags(mesh, AMST_VERTEX, out, capacity, needed))
GETTER(edge_flags, amst_mesh_get_flags(mesh, AMST_EDGE, out, capacity, needed))
GETTER(face_flags, amst_mesh_get_flags(mesh, AMST_FACE, out, capacity, needed))
GETTER(markers, amst_mesh_get_markers(mesh, AMST_EDGE, out, capacity, needed))
GETTER(marker_list, amst_mesh_get_marker_list(mesh, AMST_FACE, out, capacity, needed))
GETTER(marker_name, amst_mesh_get_marker_name(mesh, AMST_FACE, 7, out, capacity, needed))
GETTER(field, amst_mesh_get_field(mesh, AMST_VERTEX, "a", out, capacity, needed))
GETTER(quality, amst_mesh_get_quality(mesh, AMST_METRIC_SHAPE, out, capacity, needed))
GETTER(patch_faces, amst_patches_get_faces(set, 0, out, capacity, needed))
GETTER(patch_boundary, amst_patches_get_boundary(set, 0, out, capacity, needed))
GETTER(patch_corners, amst_patches_get_corners(set, 0, out, capacity, needed))
GETTER(vertex_origin, amst_report_get_origin(report, AMST_VERTEX, out, capacity, needed))
GETTER(edge_origin, amst_report_get_origin(report, AMST_EDGE, out, capacity, needed))
GETTER(face_origin, amst_report_get_origin(report, AMST_FACE, out, capacity, needed))

static void follow_protocol(getter get, size_t size, int64_t expected) {
    const unsigned char canary = 0xA5;
    int64_t n = -1;
    must(get(NULL, 0, &n));
    assert_int_equal(n, expected);
    assert_true(n > 0);
    const size_t bytes = size * (size_t)n;
    unsigned char *exact = memory(bytes), *longer = memory(bytes + 2 * size);

    memset(exact, canary, bytes);
    n = -1;
    refused(AMST_ERR_BUFFER_TOO_SMALL, get(exact, expected - 1, &n));
    assert_int_equal(n, expected);
    n = -1;
    refused(AMST_ERR_BUFFER_TOO_SMALL, get(exact, 0, &n));
    assert_int_equal(n, expected);
    refused(AMST_ERR_RANGE, get(exact, -1, &n));
    refused(AMST_ERR_RANGE, get(NULL, -1, &n));
    refused(AMST_ERR_NULL, get(NULL, expected, &n));
    refused(AMST_ERR_NULL, get(exact, expected, NULL));
    for (size_t i = 0; i < bytes; ++i)
        assert_int_equal(exact[i], canary);

    must(get(exact, expected, &n));
    memset(longer, canary, bytes + 2 * size);
    must(get(longer, expected + 2, &n));
    assert_int_equal(n, expected);
    assert_memory_equal(longer, exact, bytes);
    for (size_t i = bytes; i < bytes + 2 * size; ++i)
        assert_int_equal(longer[i], canary);
    free(exact);
    free(longer);
}

static void every_getter(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    double corners[24];
    const int32_t cube[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    for (int v = 0; v < 8; ++v)
        for (int c = 0; c < 3; ++c)
            corners[3 * v + c] = (v >> c) & 1;
    must(amst_mesh_create(ctx, 3, corners, 8, 0, 0, cube, 6, 0, 0, 4, NULL, &mesh));
    follow_protocol(points, sizeof(double), 24);
    follow_protocol(faces, sizeof(amst_id), 24);
    follow_protocol(edges, sizeof(amst_id), 24);
    follow_protocol(edge_faces, sizeof(amst_id), 24);
    follow_protocol(vertex_faces, sizeof(amst_id), 24);
    follow_protocol(centroids, sizeof(double), 18);
    follow_protocol(lengths, sizeof(double), 12);
    follow_protocol(normals, sizeof(double), 36);
    follow_protocol(valences, sizeof(int32_t), 8);
    follow_protocol(singularities, sizeof(amst_id), 8);
    follow_protocol(vertex_flags, sizeof(int32_t), 8);
    follow_protocol(edge_flags, sizeof(int32_t), 12);
    follow_protocol(face_flags, sizeof(int32_t), 6);
    must(amst_mesh_set_markers(mesh, AMST_FACE, cube, 1, 7));
    must(amst_mesh_set_markers(mesh, AMST_FACE, cube + 1, 1, 8));
    must(amst_mesh_set_marker_name(mesh, AMST_FACE, 7, "top"));
    follow_protocol(markers, sizeof(int32_t), 12);
    follow_protocol(marker_list, sizeof(int32_t), 2);
    follow_protocol(marker_name, 1, 4);
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "a", 3, AMST_CARRY_DROP, corners, 8));
    follow_protocol(field, sizeof(double), 24);
    follow_protocol(quality, sizeof(double), 6);
    amst_mesh_destroy(mesh);

    mesh = new_grid(ctx, 0, 5, 5);
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 5, 1, 4);
    must(amst_smooth(mesh, set, NULL, &report));
    follow_protocol(points, sizeof(double), 72);
    follow_protocol(patch_faces, sizeof(amst_id), 9);
    follow_protocol(patch_boundary, sizeof(amst_id), 12);
    follow_protocol(patch_corners, sizeof(amst_id), 4);
    follow_protocol(vertex_origin, sizeof(amst_id), 36);
    follow_protocol(edge_origin, sizeof(amst_id), 60);
    follow_protocol(face_origin, sizeof(amst_id), 25);

    int64_t n = -1; /* an empty answer needs no array */
    must(amst_mesh_get_singularities(mesh, NULL, 0, &n));
    assert_int_equal(n, 0);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_getter)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
