/* amst_clean: doublets go, valences above 5 are split. */
#include <math.h>

#include "grid.h"

static int32_t extreme_valence(const amst_mesh *mesh, int largest) {
    const int64_t n = count_of(mesh, AMST_VERTEX);
    int64_t needed, n_edges = count_of(mesh, AMST_EDGE);
    int32_t *valences = memory(sizeof(int32_t) * (size_t)n), found = 4;
    char *border = calloc((size_t)n, 1);
    amst_id *edges = memory(sizeof(amst_id) * 2 * (size_t)n_edges);
    amst_id *sides = memory(sizeof(amst_id) * 2 * (size_t)n_edges);
    assert_non_null(border);
    must(amst_mesh_get_valences(mesh, valences, n, &needed));
    must(amst_mesh_get_edges(mesh, edges, 2 * n_edges, &needed));
    must(amst_mesh_get_edge_faces(mesh, sides, 2 * n_edges, &needed));
    for (int64_t e = 0; e < n_edges; ++e)
        if (sides[2 * e] == -1 || sides[2 * e + 1] == -1)
            border[edges[2 * e]] = border[edges[2 * e + 1]] = 1;
    for (int64_t v = 0; v < n; ++v)
        if (!border[v] && (largest ? valences[v] > found : valences[v] < found))
            found = valences[v];
    free(valences);
    free(border);
    free(edges);
    free(sides);
    return found;
}

/* The middle face of a grid gets a vertex of valence 2 inside. */
static void a_doublet_goes(void **state) {
    (void)state;
    enum { nx = 7 };
    amst_context *ctx = new_context(0);
    double *grid = grid_points(nx, nx), points[2 * 65];
    int32_t *faces = grid_faces(nx, nx, 0), more[4 * 50];
    memcpy(points, grid, sizeof(double) * 2 * 64);
    points[128] = 3.5;
    points[129] = 3.5;
    memcpy(more, faces, sizeof(int32_t) * 4 * 49);
    int32_t *middle = more + 4 * (3 * nx + 3), *last = more + 4 * 49;
    const int32_t a = middle[0], b = middle[1], c = middle[2], d = middle[3];
    middle[3] = 64; /* a b c m and a m c d */
    (void)b;
    last[0] = a;
    last[1] = 64;
    last[2] = c;
    last[3] = d;
    amst_mesh *mesh = NULL;
    amst_report *report = NULL;
    must(amst_mesh_create(ctx, 2, points, 65, 0, 0, more, 50, 0, 0, 4, NULL, &mesh));
    assert_int_equal(extreme_valence(mesh, 0), 2);
    must(amst_clean(mesh, NULL, &report));
    must(amst_mesh_check(mesh));
    assert_true(extreme_valence(mesh, 0) >= 3);
    assert_true(revision(mesh) > 0);
    assert_true(worst_scaled_jacobian(mesh) > 0);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_BEFORE), 50);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_AFTER), count_of(mesh, AMST_FACE));
    int64_t doublets;
    must(amst_report_get_valence(report, AMST_ALL, 0, 2, &doublets));
    assert_int_equal(doublets, 1);
    must(amst_report_get_valence(report, AMST_ALL, 1, 2, &doublets));
    assert_int_equal(doublets, 0);
    free(grid);
    free(faces);
    amst_report_destroy(report);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* n sectors around a point, each of rings of quads: a centre of valence n. */
static amst_mesh *new_star(amst_context *ctx, int sectors) {
    enum { rings = 3 };
    const double pi = 3.14159265358979323846;
    const int around = 2 * sectors;
    double *points = memory(sizeof(double) * 2 * (size_t)(1 + rings * around));
    int32_t *faces = memory(sizeof(int32_t) * 4 * (size_t)(sectors + (rings - 1) * around)), *to = faces;
    points[0] = points[1] = 0;
    for (int r = 0; r < rings; ++r)
        for (int k = 0; k < around; ++k) {
            points[2 * (1 + r * around + k)] = (r + 1) * cos(2 * pi * k / around);
            points[2 * (1 + r * around + k) + 1] = (r + 1) * sin(2 * pi * k / around);
        }
    for (int s = 0; s < sectors; ++s) {
        *to++ = 0;
        *to++ = 1 + 2 * s;
        *to++ = 2 + 2 * s;
        *to++ = 1 + (2 * s + 2) % around;
    }
    for (int r = 1; r < rings; ++r)
        for (int k = 0; k < around; ++k) {
            const int next = (k + 1) % around;
            *to++ = 1 + (r - 1) * around + k;
            *to++ = 1 + r * around + k;
            *to++ = 1 + r * around + next;
            *to++ = 1 + (r - 1) * around + next;
        }
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 2, points, 1 + rings * around, 0, 0, faces, sectors + (rings - 1) * around, 0,
                          0, 4, NULL, &mesh));
    free(points);
    free(faces);
    return mesh;
}

static void a_high_valence_is_split(void **state) {
    (void)state;
    for (int sectors = 6; sectors <= 8; ++sectors) {
        amst_context *ctx = new_context(0);
        amst_mesh *mesh = new_star(ctx, sectors);
        must(amst_mesh_check(mesh));
        assert_int_equal(extreme_valence(mesh, 1), sectors);
        must(amst_clean(mesh, NULL, NULL));
        must(amst_mesh_check(mesh));
        assert_true(extreme_valence(mesh, 1) <= 5);
        assert_true(worst_scaled_jacobian(mesh) > 0);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

/* What is mended is filled as a patch is. */
static void options_of_fillings_count(void **state) {
    (void)state;
    const int32_t keys[] = {AMST_OPT_SIZE_WEIGHT, AMST_OPT_EFFORT, AMST_OPT_TRANSITION, AMST_OPT_LEAST_SIZE};
    int64_t digest[4];
    amst_context *ctx = new_context(0);
    for (int k = 0; k < 4; ++k) {
        amst_mesh *mesh = new_star(ctx, 8);
        amst_options *options = NULL;
        amst_report *report = NULL;
        must(amst_options_create(&options));
        must(amst_options_set_real(options, keys[k], k == 0 ? 0 : 0.05));
        must(amst_clean(mesh, options, &report));
        digest[k] = checksum(mesh);
        assert_int_equal(result(report, AMST_ALL, AMST_RESULT_UNUSED_OPTION), AMST_OPTION_INVALID);
        amst_report_destroy(report);
        amst_options_destroy(options);
        amst_mesh_destroy(mesh);
    }
    assert_true(digest[0] != digest[1]); /* sizes weigh there */
    amst_context_destroy(ctx);
}

static void a_clean_mesh_stays(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 6, 6);
    amst_patches *set = NULL;
    const int64_t before = checksum(mesh);
    must(amst_patches_create(mesh, NULL, &set));
    must(amst_clean(mesh, NULL, NULL));
    assert_true(checksum(mesh) == before);
    assert_int_equal(revision(mesh), 0);
    must(amst_patches_add_rings(set, 8, 1, NULL)); /* not stale */
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_doublet_goes),
        cmocka_unit_test(a_high_valence_is_split),
        cmocka_unit_test(options_of_fillings_count),
        cmocka_unit_test(a_clean_mesh_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
