/* The triangles that a mesh keeps to. What they are for is told by the tests of operations. */
#include <math.h>

#include "grid.h"

static amst_context *ctx;
static amst_mesh *mesh;

static int setup(void **state) {
    (void)state;
    ctx = new_context(1);
    mesh = new_grid(ctx, 1, 3, 3);
    return 0;
}

static int teardown(void **state) {
    (void)state;
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
    return 0;
}

static void a_surface_is_no_change_of_the_mesh(void **state) {
    (void)state;
    const double points[8] = {0, 0, 3, 0, 3, 3, 0, 3};
    const int32_t triangles[9] = {1, 2, 3, 1, 3, 4, 1, 1, 2}; /* the last one has no area */
    const int64_t before = checksum(mesh);
    amst_mesh *copy = NULL;
    must(amst_mesh_set_surface(mesh, NULL, 0, NULL, 0));
    must(amst_mesh_set_surface(mesh, NULL, -5, triangles, 3)); /* nothing else counts */
    must(amst_mesh_set_surface(mesh, points, 4, triangles, 3));
    must(amst_mesh_clone(mesh, &copy));
    assert_true(checksum(mesh) == before);
    assert_int_equal(revision(mesh), 0);
    must(amst_mesh_check(mesh));
    amst_mesh_destroy(copy);
}

static void bad_triangles_are_named(void **state) {
    (void)state;
    const double points[8] = {0, 0, 3, 0, 3, 3, 0, NAN};
    const int32_t good[3] = {1, 2, 3}, zero[6] = {1, 2, 3, 1, 2, 0}, far[6] = {1, 2, 3, 5, 1, 2},
                  least[3] = {1, 2, INT32_MIN};
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, points, 4, zero, 2));
    assert_string_equal(amst_last_error(), "triangle 2 of the surface has corner 0, but there are 4 points; "
                                           "correct the corner or add the point");
    assert_error_names(AMST_ENTITY_NONE, 0); /* no entity of the mesh */
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, points, 4, far, 2));
    assert_non_null(strstr(amst_last_error(), "triangle 2 of the surface has corner 5"));
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, points, 4, least, 1));
    refused(AMST_ERR_NOT_FINITE, amst_mesh_set_surface(mesh, points, 4, good, 1));
    assert_non_null(strstr(amst_last_error(), "point 4 of the surface"));
    must(amst_mesh_set_surface(mesh, points, 3, good, 1)); /* the fourth is not read */
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, points, 3, good, 0));
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, points, 3, good, -1));
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, points, -1, good, 1));
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, points, 0, good, 1));
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, points, INT64_MAX, good, 1));
    refused(AMST_ERR_RANGE, amst_mesh_set_surface(mesh, points, 3, good, INT64_MAX));
    refused(AMST_ERR_NULL, amst_mesh_set_surface(mesh, points, 3, NULL, 1));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_surface_is_no_change_of_the_mesh, setup, teardown),
        cmocka_unit_test_setup_teardown(bad_triangles_are_named, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
