/* The face field "size error". */
#include <math.h>

#include "grid.h"

static double *errors_of(const amst_mesh *mesh) {
    int64_t n = count_of(mesh, AMST_FACE);
    double *errors = memory(sizeof(double) * (size_t)n);
    must(amst_mesh_get_field(mesh, AMST_FACE, "size error", errors, n, &n));
    return errors;
}

static void add_errors(amst_mesh *mesh, double value) {
    const int64_t n = count_of(mesh, AMST_FACE);
    double *values = memory(sizeof(double) * (size_t)n);
    for (int64_t f = 0; f < n; ++f)
        values[f] = value;
    must(amst_mesh_set_field(mesh, AMST_FACE, "size error", 1, AMST_CARRY_INHERIT, values, n));
    free(values);
}

/* The field has what the report tells of some faces, NULL: the first n. */
static void errors_agree(const amst_mesh *mesh, const amst_report *report, amst_id patch,
                         const amst_id *faces, int64_t n) {
    double *errors = errors_of(mesh), squares = 0, least = HUGE_VAL;
    for (int64_t i = 0; i < n; ++i) {
        const double e = errors[faces == NULL ? i : faces[i]];
        squares += e * e;
        least = fmin(least, e);
    }
    assert_true(fabs(sqrt(squares / (double)n) - real_result(report, patch, AMST_RESULT_SIZE_ERROR_AFTER)) <
                1e-9);
    assert_true(fabs(exp2(least) - real_result(report, patch, AMST_RESULT_LEAST_AREA_AFTER)) < 1e-9);
    free(errors);
}

static void a_field_has_the_errors_of_patches(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 12, 12);
    amst_patches *set = NULL;
    amst_report *report = NULL;
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 12, 1, 6);
    add_square(set, 12, 7, 11);
    add_errors(mesh, 9);
    must(amst_adapt(mesh, set, 2, NULL, &report));
    const int64_t n = count_of(mesh, AMST_FACE);
    amst_id *faces = memory(sizeof(amst_id) * (size_t)n);
    double *errors = errors_of(mesh), *areas = memory(sizeof(double) * (size_t)n);
    int64_t n_faces, nines = 0, needed, told = 0;
    must(amst_mesh_get_quality(mesh, AMST_METRIC_AREA, areas, n, &needed));
    for (amst_id p = 0; p < 2; ++p) {
        must(amst_patches_get_faces(set, p, faces, n, &n_faces));
        errors_agree(mesh, report, p, faces, n_faces);
        for (int64_t i = 0; i < n_faces; ++i) { /* what is wanted lies between border and core */
            const double wanted = areas[faces[i]] / exp2(errors[faces[i]]);
            assert_true(wanted > 0.1 && wanted < 1.01);
        }
        told += n_faces;
    }
    for (int64_t f = 0; f < n; ++f)
        nines += errors[f] == 9;
    assert_int_equal(nines, n - told); /* of the others nothing is known */
    free(areas);
    free(errors);
    free(faces);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* A patch that is left, as a strip has the fewest faces that its boundary allows, and whose faces get other
 * numbers as another one has fewer: what is there is far too small. */
static void a_field_has_the_errors_of_a_patch_that_is_left(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 12, 12);
    amst_patches *set = NULL;
    amst_report *report = NULL;
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 12, 0, 5);
    const amst_id strip[5] = {139, 140, 141, 142, 143};
    must(amst_patches_add_faces(set, strip, 5, NULL));
    must(amst_patches_set_alpha(set, 1, 0.01));
    add_errors(mesh, 9);
    assert_int_equal(amst_adapt(mesh, set, 0.8, NULL, &report), AMST_PARTIAL);
    assert_int_equal(result(report, 0, AMST_RESULT_FACES_AFTER), 20);
    assert_true(result(report, 1, AMST_RESULT_STATUS) < 0);
    amst_id faces[5], *corners = faces_of(mesh);
    int64_t n;
    double *errors = errors_of(mesh), *points = points_of(mesh);
    must(amst_patches_get_faces(set, 1, faces, 5, &n));
    assert_int_equal(n, 5);
    errors_agree(mesh, report, 1, faces, n);
    int moved = 0;
    for (int64_t i = 0; i < n; ++i) {
        const double *low = points + 2 * corners[4 * faces[i]];
        assert_true(errors[faces[i]] < -4);
        moved = moved || faces[i] != 12 * (amst_id)(low[1] + 0.5) + (amst_id)(low[0] + 0.5);
    }
    assert_true(moved);
    free(points);
    free(errors);
    free(corners);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* Also where the mesh stays; where there is none, none comes. */
static void a_field_has_the_errors_of_a_whole_mesh(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    for (int k = 0; k < 2; ++k) {
        amst_mesh *mesh = new_disturbed(ctx, 16);
        amst_report *report = NULL;
        add_errors(mesh, 9);
        must(amst_adapt(mesh, NULL, k == 0 ? 1 : 1.5, NULL, &report));
        errors_agree(mesh, report, AMST_ALL, NULL, count_of(mesh, AMST_FACE));
        amst_report_destroy(report);
        must(amst_adapt(mesh, NULL, 1, NULL, &report)); /* it has what is asked for */
        errors_agree(mesh, report, AMST_ALL, NULL, count_of(mesh, AMST_FACE));
        amst_report_destroy(report);
        must(amst_mesh_remove_field(mesh, AMST_FACE, "size error"));
        must(amst_adapt(mesh, NULL, 2, NULL, NULL));
        int64_t needed;
        refused(AMST_ERR_NOT_FOUND, amst_mesh_get_field(mesh, AMST_FACE, "size error", NULL, 0, &needed));
        amst_mesh_destroy(mesh);
    }
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_field_has_the_errors_of_patches),
        cmocka_unit_test(a_field_has_the_errors_of_a_patch_that_is_left),
        cmocka_unit_test(a_field_has_the_errors_of_a_whole_mesh),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
