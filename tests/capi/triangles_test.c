/* Meshes of triangles: what is crossed or added is told, and can be forbidden. */
#include <stdio.h>

#include "grid.h"

typedef struct said {
    int warnings;
    char text[400];
} said;

static void hear(void *user, int32_t level, const char *message) {
    said *heard = user;
    if (level == AMST_LOG_WARNING) {
        ++heard->warnings;
        snprintf(heard->text, sizeof heard->text, "%s", message);
    }
}

static int64_t count(const amst_mesh *mesh, int32_t entity) {
    int64_t n = 0;
    must(amst_mesh_get_count(mesh, entity, &n));
    return n;
}

static double least_quality(const amst_mesh *mesh) {
    amst_summary summary;
    must(amst_mesh_get_summary(mesh, AMST_METRIC_SCALED_JACOBIAN, &summary));
    return summary.min;
}

static const double octahedron[] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
static const int32_t eight[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

static amst_id edge_between(const amst_mesh *mesh, amst_id v, amst_id w) {
    const amst_id pair[] = {v, w};
    amst_id edge = 0;
    must(amst_mesh_find_edges(mesh, pair, 1, &edge));
    return edge;
}

static void crossing_is_told(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    said heard = {0, ""};
    must(amst_context_set_log(ctx, AMST_LOG_WARNING, hear, &heard));
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 3, octahedron, 6, 0, 0, eight, 8, 0, 0, 3, NULL, &mesh));
    assert_int_equal(count(mesh, AMST_FACE), 4);
    assert_int_equal(heard.warnings, 1);
    assert_non_null(strstr(heard.text, "4 sharp edges"));
    amst_id crossed[8], split[3];
    int64_t needed = 0;
    must(amst_mesh_get_crossed_edges(mesh, crossed, 8, &needed));
    assert_int_equal(needed, 8);
    for (int e = 0; e < 4; ++e) {
        assert_true(crossed[2 * e] < crossed[2 * e + 1]);
        assert_true(edge_between(mesh, crossed[2 * e], crossed[2 * e + 1]) < 0);
        assert_true(e == 0 || crossed[2 * e - 2] <= crossed[2 * e]);
    }
    must(amst_mesh_get_split_edges(mesh, split, 3, &needed));
    assert_int_equal(needed, 0);
    amst_mesh_destroy(mesh);

    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_real(options, AMST_OPT_SHARP_ANGLE, 180));
    must(amst_mesh_create(ctx, 3, octahedron, 6, 0, 0, eight, 8, 0, 0, 3, options, &mesh));
    assert_int_equal(heard.warnings, 1);
    amst_mesh_destroy(mesh);
    amst_options_destroy(options);
    amst_context_destroy(ctx);
}

static void boundary_vertices_are_told_or_forbidden(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    said heard = {0, ""};
    must(amst_context_set_log(ctx, AMST_LOG_WARNING, hear, &heard));
    const double points[] = {0, 0, 1, 0, 1, 1, 0, 1, 2, 0.5};
    const int32_t three[] = {1, 2, 3, 3, 4, 1, 2, 5, 3};
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 2, points, 5, 0, 0, three, 3, 0, 0, 3, NULL, &mesh));
    assert_int_equal(heard.warnings, 1);
    assert_non_null(strstr(heard.text, "boundary"));
    amst_mesh *copy = NULL;
    must(amst_mesh_clone(mesh, &copy));
    amst_mesh_destroy(mesh);
    mesh = NULL;
    amst_id split[3];
    int64_t needed = 0;
    must(amst_mesh_get_split_edges(copy, split, 3, &needed));
    assert_int_equal(needed, 3);
    assert_true(split[0] >= 1 && split[0] < split[1] && split[1] <= 5);
    assert_int_equal(split[2], 6);
    assert_true(edge_between(copy, split[0], split[2]) > 0);
    assert_true(edge_between(copy, split[1], split[2]) > 0);
    must(amst_mesh_get_crossed_edges(copy, NULL, 0, &needed));
    assert_int_equal(needed, 0);
    amst_mesh_destroy(copy);

    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_KEEP_BOUNDARY, 1));
    refused(AMST_ERR_ARGUMENT, amst_mesh_create(ctx, 2, points, 5, 0, 0, three, 3, 0, 0, 3, options, &mesh));
    assert_non_null(strstr(amst_last_error(), "odd"));
    assert_null(mesh);
    must(amst_mesh_create(ctx, 2, points, 4, 0, 0, three, 2, 0, 0, 3, options, &mesh));
    assert_int_equal(count(mesh, AMST_FACE), 1);
    assert_int_equal(heard.warnings, 1);
    amst_mesh_destroy(mesh);
    amst_options_destroy(options);
    amst_context_destroy(ctx);
}

/* Two triangles are one quad, unless the edge between them is named. */
static void edges_named_are_not_crossed(void **state) {
    (void)state;
    const double points[] = {0, 0, 1, 0, 1, 1, 0, 1};
    const amst_id diagonal[] = {3, 1}, outside[] = {2, 4, 1, 7, 0, 3};
    for (int base = 0; base < 2; ++base) {
        amst_context *ctx = new_context(base);
        int32_t two[] = {0, 1, 2, 2, 3, 0};
        int64_t wide[6];
        for (int i = 0; i < 6; ++i)
            wide[i] = two[i] += base;
        amst_id named[] = {base + 2, base};
        amst_options *options = NULL;
        must(amst_options_create(&options));
        must(amst_options_set_edges(options, diagonal, 1));
        must(amst_options_set_edges(options, named, 1));
        amst_id back[2] = {-1, -1};
        int64_t needed = 0;
        must(amst_options_get_edges(options, back, 2, &needed));
        assert_int_equal(needed, 2);
        assert_int_equal(back[0], base + 2);
        assert_int_equal(back[1], base);

        amst_mesh *mesh = NULL;
        must(amst_mesh_create(ctx, 2, points, 4, 0, 0, two, 2, 0, 0, 3, options, &mesh));
        assert_true(count(mesh, AMST_FACE) > 1);
        const int64_t n_faces = count(mesh, AMST_FACE);
        amst_mesh_destroy(mesh);
        must(amst_mesh_create_i64(ctx, 2, points, 4, 0, 0, wide, 2, 0, 0, 3, options, &mesh));
        assert_int_equal(count(mesh, AMST_FACE), n_faces);
        amst_mesh_destroy(mesh);

        must(amst_options_set_edges(options, NULL, 0));
        must(amst_mesh_create(ctx, 2, points, 4, 0, 0, two, 2, 0, 0, 3, options, &mesh));
        assert_int_equal(count(mesh, AMST_FACE), 1);
        amst_mesh_destroy(mesh);
        mesh = NULL;

        must(amst_options_set_edges(options, outside, 3));
        refused(AMST_ERR_NOT_FOUND,
                amst_mesh_create(ctx, 2, points, 4, 0, 0, two, 2, 0, 0, 3, options, &mesh));
        assert_non_null(strstr(amst_last_error(), base == 0 ? "2 edges" : "3 edges"));
        assert_non_null(strstr(amst_last_error(), "1-7"));
        assert_null(mesh);
        refused(AMST_ERR_RANGE, amst_options_set_edges(options, outside, -1));
        amst_options_destroy(options);
        amst_context_destroy(ctx);
    }
}

/* Three squares of two triangles: each is a quad, unless the diagonal of the second one is named. */
static void edges_named_turn_pairs(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    double points[16];
    for (int i = 0; i < 8; ++i) {
        points[2 * i] = i / 2;
        points[2 * i + 1] = i % 2;
    }
    int32_t six[18];
    for (int i = 0; i < 3; ++i) {
        const int32_t a = 2 * i, cell[] = {a, a + 2, a + 3, a + 3, a + 1, a};
        memcpy(six + 6 * i, cell, sizeof cell);
    }
    amst_options *options = NULL;
    must(amst_options_create(&options));
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 2, points, 8, 0, 0, six, 6, 0, 0, 3, options, &mesh));
    assert_int_equal(count(mesh, AMST_FACE), 3);
    assert_true(edge_between(mesh, 2, 5) < 0);
    amst_mesh_destroy(mesh);
    const amst_id named[] = {5, 2};
    must(amst_options_set_edges(options, named, 1));
    must(amst_mesh_create(ctx, 2, points, 8, 0, 0, six, 6, 0, 0, 3, options, &mesh));
    must(amst_mesh_check(mesh));
    assert_true(edge_between(mesh, 2, 5) >= 0 || count(mesh, AMST_VERTEX) > 8);
    assert_true(count(mesh, AMST_FACE) > 3);
    amst_mesh_destroy(mesh);
    amst_options_destroy(options);
    amst_context_destroy(ctx);
}

static void one_tetrahedron_or_triangle_works(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    const double points[] = {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1};
    const int32_t four[] = {0, 1, 3, 0, 2, 1, 0, 3, 2, 1, 2, 3};
    amst_mesh *mesh = NULL;
    for (int n = 1; n <= 4; n += 3) {
        must(amst_mesh_create(ctx, 3, points, 4, 0, 0, four, n, 0, 0, 3, NULL, &mesh));
        must(amst_mesh_check(mesh));
        assert_int_equal(count(mesh, AMST_FACE), 3 * n);
        assert_true(least_quality(mesh) > 0.4);
        must(amst_adapt(mesh, NULL, 2.0, NULL, NULL));
        must(amst_mesh_check(mesh));
        assert_true(least_quality(mesh) > 0.1);
        amst_mesh_destroy(mesh);
    }
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crossing_is_told),
        cmocka_unit_test(boundary_vertices_are_told_or_forbidden),
        cmocka_unit_test(edges_named_are_not_crossed),
        cmocka_unit_test(edges_named_turn_pairs),
        cmocka_unit_test(one_tetrahedron_or_triangle_works),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
