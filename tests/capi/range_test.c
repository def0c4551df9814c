/* Lengths that are too large or too small to be reckoned with are refused, and what is taken comes to an end.
 */
#include <math.h>

#include "grid.h"

enum { side = 12, n_vertices = (side + 1) * (side + 1) };

typedef struct {
    amst_context *ctx;
    double points[3 * n_vertices];
    double sizes[n_vertices];
} world;

/* A warped sheet, bent or flat, whose size is about 12 times scale. */
static void lay(world *w, double bend, double scale) {
    for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i) {
            double *p = w->points + 3 * (j * (side + 1) + i);
            p[0] = scale * (i + 0.25 * ((i + 2 * j) % 3 - 1));
            p[1] = scale * (j + 0.25 * ((2 * i + j) % 3 - 1));
            p[2] = scale * bend * (i - 6) * (j - 6);
        }
}

static amst_status create(world *w, amst_mesh **mesh) {
    int32_t *faces = grid_faces(side, side, 0);
    const amst_status status =
        amst_mesh_create(w->ctx, 3, w->points, n_vertices, 0, 0, faces, side * side, 0, 0, 4, NULL, mesh);
    free(faces);
    return status;
}

static amst_mesh *made(world *w, double bend, double scale) {
    amst_mesh *mesh = NULL;
    lay(w, bend, scale);
    must(create(w, &mesh));
    return mesh;
}

static int setup(void **state) {
    world *w = memory(sizeof *w);
    w->ctx = new_context(0);
    *state = w;
    return 0;
}

static int teardown(void **state) {
    world *w = *state;
    amst_context_destroy(w->ctx);
    free(w);
    return 0;
}

static void says(const char *words) {
    if (strstr(amst_last_error(), words) == NULL)
        fail_msg("\"%s\" is not in: %s", words, amst_last_error());
}

static void coordinates_too_far_or_too_near_are_refused(void **state) {
    world *w = *state;
    amst_mesh *mesh = NULL;
    int32_t entity = -1;
    amst_id id = -1;
    lay(w, 0.05, 1);
    w->points[3 * 17 + 1] = -1e160;
    refused(AMST_ERR_RANGE, create(w, &mesh));
    says("vertex 17 has a coordinate beyond 1e30");
    must(amst_last_error_where(&entity, &id, NULL));
    assert_int_equal(entity, AMST_VERTEX);
    assert_int_equal(id, 17);
    lay(w, 0.05, 1e-100);
    refused(AMST_ERR_RANGE, create(w, &mesh));
    says("smaller than 1e-30");
    assert_null(mesh);

    mesh = made(w, 0.05, 1);
    const int64_t before = checksum(mesh);
    lay(w, 0.05, 1e160);
    refused(AMST_ERR_RANGE, amst_mesh_set_points(mesh, w->points, n_vertices));
    lay(w, 0.05, 1e-100);
    refused(AMST_ERR_RANGE, amst_mesh_set_points(mesh, w->points, n_vertices));
    assert_int_equal(checksum(mesh), before);
    memset(w->points, 0, sizeof w->points); /* all at one place: a mesh that gets its points later */
    must(amst_mesh_set_points(mesh, w->points, n_vertices));
    amst_mesh_destroy(mesh);
}

static void sizes_that_no_edge_has_are_refused(void **state) {
    world *w = *state;
    amst_mesh *mesh = made(w, 0, 1);
    const double bad[] = {1e160, 1e-160, 1e308, 1e-308, INFINITY};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k) {
        for (int v = 0; v < n_vertices; ++v)
            w->sizes[v] = 1;
        w->sizes[5] = bad[k];
        refused(isinf(bad[k]) ? AMST_ERR_NOT_FINITE : AMST_ERR_RANGE,
                amst_mesh_set_field(mesh, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, w->sizes, n_vertices));
        says("vertex 5");
    }
    amst_mesh_destroy(mesh);
}

/* All that follow from one state of a mesh. */
static void adapt_all_ways(world *w, amst_mesh *mesh, double scale) {
    const double center[3] = {6 * scale, 6 * scale, 0}, alphas[] = {0.5, 1, 2};
    int64_t mark = 0;
    must(amst_mesh_mark(mesh, &mark));
    for (int k = 0; k < 3; ++k) {
        amst_patches *set = NULL;
        must(amst_patches_create(mesh, NULL, &set));
        must(amst_patches_add_ball(set, center, 3 * scale, NULL));
        assert_true(amst_adapt(mesh, set, alphas[k], NULL, NULL) >= 0);
        must(amst_mesh_rollback(mesh, mark));
        assert_true(amst_adapt(mesh, NULL, alphas[k], NULL, NULL) >= 0);
        must(amst_mesh_rollback(mesh, mark));
        amst_patches_destroy(set);
    }
    assert_true(amst_smooth(mesh, NULL, NULL, NULL) >= 0);
    int64_t n = 0;
    must(amst_mesh_get_points(mesh, w->points, 3 * n_vertices, &n));
    for (int i = 0; i < 3 * n_vertices; ++i)
        assert_true(isfinite(w->points[i]));
}

static void sizes_at_the_ends_of_the_range_are_no_trouble(void **state) {
    world *w = *state;
    const double sizes[] = {1e-30, 1e30};
    for (int k = 0; k < 2; ++k) {
        amst_mesh *mesh = made(w, 0, 1);
        for (int v = 0; v < n_vertices; ++v)
            w->sizes[v] = sizes[k];
        must(amst_mesh_set_field(mesh, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, w->sizes, n_vertices));
        adapt_all_ways(w, mesh, 1);
        amst_mesh_destroy(mesh);
    }
}

static void a_flat_surface_wants_faces_of_one_size(void **state) {
    world *w = *state;
    const double points[12] = {-1, -1, 0, 20, -1, 0, 20, 20, 0, -1, 20, 0};
    const int32_t triangles[6] = {0, 1, 2, 0, 2, 3};
    for (int bent = 0; bent < 2; ++bent) {
        amst_mesh *mesh = made(w, 0.02 * bent, 1);
        must(amst_mesh_set_surface(mesh, points, 4, triangles, 2));
        adapt_all_ways(w, mesh, 1);
        amst_mesh_destroy(mesh);
    }
}

static void a_surface_without_area_is_refused(void **state) {
    world *w = *state;
    amst_mesh *mesh = made(w, 0.05, 1);
    const double line[9] = {0, 0, 0, 1, 1, 0, 2, 2, 0}, far[9] = {0, 0, 0, 1, 0, 0, 0, 1e160, 0};
    const int32_t triangle[3] = {0, 1, 2};
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, line, 3, triangle, 1));
    says("no triangle of the surface has an area");
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, far, 3, triangle, 1));
    says("point 2 of the surface");
    amst_mesh_destroy(mesh);
}

/* A billion billion billion times as large or as small: the same mesh. */
static void the_unit_of_length_is_free(void **state) {
    world *w = *state;
    for (int bent = 0; bent < 2; ++bent) {
        double plain[3 * n_vertices], plain_quality = 0;
        int64_t plain_features = 0;
        const int exponents[] = {0, -85, 85};
        for (int k = 0; k < 3; ++k) {
            const double scale = ldexp(1, exponents[k]);
            amst_mesh *mesh = made(w, 0.05 * bent, scale);
            amst_summary shape;
            int64_t n = 0, found = 0, mark = 0;
            must(amst_mesh_mark(mesh, &mark));
            must(amst_mesh_detect_features(mesh, 20, &found));
            must(amst_mesh_rollback(mesh, mark));
            must(amst_smooth(mesh, NULL, NULL, NULL));
            must(amst_mesh_get_points(mesh, w->points, 3 * n_vertices, &n));
            must(amst_mesh_get_summary(mesh, AMST_METRIC_SHAPE, &shape));
            if (k == 0) {
                memcpy(plain, w->points, sizeof plain);
                plain_quality = shape.mean;
                plain_features = found;
            }
            for (int i = 0; i < 3 * n_vertices; ++i)
                assert_true(w->points[i] == plain[i] * scale);
            assert_true(shape.mean == plain_quality);
            assert_int_equal(found, plain_features);
            adapt_all_ways(w, mesh, scale);
            must(amst_adapt(mesh, NULL, 2, NULL, NULL));
            must(amst_mesh_get_count(mesh, AMST_FACE, &n));
            assert_int_equal(n, 2 * side * side);
            amst_mesh_destroy(mesh);
        }
    }
}

#define test(name) cmocka_unit_test_setup_teardown(name, setup, teardown)

int main(void) {
    const struct CMUnitTest tests[] = {
        test(coordinates_too_far_or_too_near_are_refused),
        test(sizes_that_no_edge_has_are_refused),
        test(sizes_at_the_ends_of_the_range_are_no_trouble),
        test(a_flat_surface_wants_faces_of_one_size),
        test(a_surface_without_area_is_refused),
        test(the_unit_of_length_is_free),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
