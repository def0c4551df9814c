/* Edges, their faces, finding them; valences and singularities. */
#include "grid.h"

static void edges_and_their_faces_fit_the_faces(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 4, 3);
    enum { n_edges = 31 };
    amst_id edges[2 * n_edges], sides[2 * n_edges], found[n_edges];
    int64_t n;
    must(amst_mesh_get_edges(mesh, edges, 2 * n_edges, &n));
    assert_int_equal(n, 2 * n_edges);
    must(amst_mesh_get_edge_faces(mesh, sides, 2 * n_edges, &n));
    assert_int_equal(n, 2 * n_edges);
    amst_id *faces = faces_of(mesh);
    int used = 0, beyond = 0;
    for (int e = 0; e < n_edges; ++e) {
        const amst_id v = edges[2 * e], w = edges[2 * e + 1];
        assert_true(v < w);
        assert_true(sides[2 * e] != -1); /* on the boundary the one face is the first */
        int turned = 0;                  /* then it may be right of the edge */
        for (int side = 0; side < 2; ++side) {
            const amst_id face = sides[2 * e + side];
            if (face == -1) {
                ++beyond;
                continue;
            }
            int along = 0, back = 0; /* the left face runs from v to w, the right one back */
            for (int c = 0; c < 4; ++c) {
                const amst_id here = faces[4 * face + c], next = faces[4 * face + (c + 1) % 4];
                along += here == v && next == w;
                back += here == w && next == v;
            }
            assert_int_equal(along + back, 1);
            turned += (side == 0) == (back == 1);
            ++used;
        }
        assert_true(turned == 0 || sides[2 * e + 1] == -1);
    }
    assert_int_equal(used, 4 * 12);
    assert_int_equal(beyond, 2 * (4 + 3));

    must(amst_mesh_find_edges(mesh, edges, n_edges, found));
    for (int e = 0; e < n_edges; ++e)
        assert_int_equal(found[e], e);
    const amst_id pairs[8] = {1, 0, 0, 6, 0, 19, 3, 3}; /* turned round, diagonal, far, none */
    must(amst_mesh_find_edges(mesh, pairs, 4, found));
    assert_true(found[0] >= 0);
    assert_int_equal(found[1], -1);
    assert_int_equal(found[2], -1);
    assert_int_equal(found[3], -1);
    const amst_id bad[4] = {0, 1, 0, 20};
    found[0] = 77;
    refused(AMST_ERR_RANGE, amst_mesh_find_edges(mesh, bad, 2, found));
    assert_error_names(AMST_VERTEX, 20);
    assert_int_equal(found[0], 77);
    must(amst_mesh_find_edges(mesh, NULL, 0, NULL));
    refused(AMST_ERR_RANGE, amst_mesh_find_edges(mesh, pairs, -1, found));
    free(faces);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void valences_of_a_grid(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 4, 3);
    int32_t valences[20];
    int64_t n;
    must(amst_mesh_get_valences(mesh, valences, 20, &n));
    assert_int_equal(n, 20);
    for (int j = 0; j <= 3; ++j)
        for (int i = 0; i <= 4; ++i)
            assert_int_equal(valences[5 * j + i], 4 - (i == 0 || i == 4) - (j == 0 || j == 3));
    assert_int_equal(n_singular(mesh), 0);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void all_corners_of_a_cube_are_singular(void **state) {
    (void)state;
    for (int32_t base = 0; base <= 1; ++base) {
        amst_context *ctx = new_context(base);
        double points[24];
        int32_t faces[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
        for (int v = 0; v < 8; ++v)
            for (int c = 0; c < 3; ++c)
                points[3 * v + c] = (v >> c) & 1;
        for (int i = 0; i < 24; ++i)
            faces[i] += base;
        amst_mesh *mesh = NULL;
        must(amst_mesh_create(ctx, 3, points, 8, 0, 0, faces, 6, 0, 0, 4, NULL, &mesh));
        must(amst_mesh_check(mesh));
        amst_id singular[8];
        int64_t n;
        must(amst_mesh_get_singularities(mesh, singular, 8, &n));
        assert_int_equal(n, 8);
        for (int v = 0; v < 8; ++v)
            assert_int_equal(singular[v], v + base);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edges_and_their_faces_fit_the_faces),
        cmocka_unit_test(valences_of_a_grid),
        cmocka_unit_test(all_corners_of_a_cube_are_singular),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
