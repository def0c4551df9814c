/* The quality that every operation reports is that of amst_mesh_get_quality. */
#include <float.h>
#include <math.h>

#include "grid.h"

enum shape { PLANE, TILTED, CURVED };

/* A disturbed grid with vertices inside moved a little, so that no corner is square. */
static amst_mesh *new_shape(amst_context *ctx, int32_t shape) {
    amst_mesh *flat = new_disturbed(ctx, 16), *mesh = NULL;
    const int64_t n = count_of(flat, AMST_VERTEX);
    double *points = points_of(flat), *space = memory(3 * sizeof(double) * (size_t)n);
    amst_id *faces = faces_of(flat);
    for (int64_t v = 0; v < n; ++v) {
        double x = points[2 * v], y = points[2 * v + 1];
        if (x > 0 && x < 16 && y > 0 && y < 16) {
            x += 0.03 * sin(5 * x + 3 * y);
            y += 0.03 * sin(7 * y - 2 * x);
        }
        points[2 * v] = x;
        points[2 * v + 1] = y;
        space[3 * v] = x;
        space[3 * v + 1] = y;
        space[3 * v + 2] = shape == TILTED ? 0.5 * x - 0.25 * y : 2 * sin(x / 3) * cos(y / 4);
    }
    must(amst_mesh_create(ctx, shape == PLANE ? 2 : 3, shape == PLANE ? points : space, n, 0, 0, faces,
                          count_of(flat, AMST_FACE), 0, 0, 4, NULL, &mesh));
    free(points);
    free(space);
    free(faces);
    amst_mesh_destroy(flat);
    return mesh;
}

/* Of the faces of the patch. */
static double worst_of(const amst_mesh *mesh, const amst_patches *set, amst_id patch) {
    int64_t n_faces = 0, n = 0;
    must(amst_mesh_get_quality(mesh, AMST_METRIC_SCALED_JACOBIAN, NULL, 0, &n_faces));
    must(amst_patches_get_faces(set, patch, NULL, 0, &n));
    double *quality = memory(sizeof(double) * (size_t)n_faces), worst = DBL_MAX;
    amst_id *faces = memory(sizeof(amst_id) * (size_t)n);
    must(amst_mesh_get_quality(mesh, AMST_METRIC_SCALED_JACOBIAN, quality, n_faces, &n_faces));
    must(amst_patches_get_faces(set, patch, faces, n, &n));
    for (int64_t i = 0; i < n; ++i)
        worst = fmin(worst, quality[faces[i]]);
    free(quality);
    free(faces);
    return worst;
}

static amst_id first_chord(const amst_mesh *mesh, const amst_options *options) {
    int64_t n, edges[400], refusal[400];
    must(amst_mesh_get_chords(mesh, AMST_CHORD_EDGE, options, edges, 400, &n));
    must(amst_mesh_get_chords(mesh, AMST_CHORD_REFUSAL, options, refusal, 400, &n));
    for (int64_t i = 0; i < n; ++i)
        if (refusal[i] == 0)
            return (amst_id)edges[i];
    fail();
    return -1;
}

/* An operation on the whole mesh; the options let chords end on the boundary. */
typedef amst_status (*operation)(amst_mesh *, const amst_options *, amst_report **);

static amst_status smooth(amst_mesh *mesh, const amst_options *options, amst_report **report) {
    return amst_smooth(mesh, NULL, options, report);
}
static amst_status collapse(amst_mesh *mesh, const amst_options *options, amst_report **report) {
    return amst_collapse_chord(mesh, first_chord(mesh, options), options, report);
}
static amst_status split(amst_mesh *mesh, const amst_options *options, amst_report **report) {
    return amst_split_chord(mesh, first_chord(mesh, options), 1, options, report);
}
static amst_status adapt(amst_mesh *mesh, const amst_options *options, amst_report **report) {
    return amst_adapt(mesh, NULL, 1, options, report);
}
static amst_status reduce(amst_mesh *mesh, const amst_options *options, amst_report **report) {
    return amst_reduce_singularities(mesh, NULL, options, report);
}

static void of_whole_meshes(void **state) {
    (void)state;
    const operation operations[] = {smooth, amst_clean, collapse, split, adapt, reduce};
    amst_context *ctx = new_context(0);
    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    for (int32_t shape = PLANE; shape <= CURVED; ++shape)
        for (size_t i = 0; i < sizeof operations / sizeof *operations; ++i) {
            amst_mesh *mesh = new_shape(ctx, shape);
            amst_report *report = NULL;
            const double before = worst_scaled_jacobian(mesh);
            assert_true(operations[i](mesh, options, &report) >= 0);
            const double told_before = real_result(report, AMST_ALL, AMST_RESULT_QUALITY_BEFORE);
            const double told_after = real_result(report, AMST_ALL, AMST_RESULT_QUALITY_AFTER);
            if (told_before != before || told_after != worst_scaled_jacobian(mesh))
                fail_msg("shape %d, operation %d: %.17g -> %.17g told, %.17g -> %.17g measured", (int)shape,
                         (int)i, told_before, told_after, before, worst_scaled_jacobian(mesh));
            amst_report_destroy(report);
            amst_mesh_destroy(mesh);
        }
    amst_options_destroy(options);
    amst_context_destroy(ctx);
}

/* An operation on patches. */
typedef amst_status (*patch_operation)(amst_mesh *, amst_patches *, amst_report **);

static amst_status smooth_patches(amst_mesh *mesh, amst_patches *set, amst_report **report) {
    return amst_smooth(mesh, set, NULL, report);
}
static amst_status adapt_patches(amst_mesh *mesh, amst_patches *set, amst_report **report) {
    return amst_adapt(mesh, set, 1.5, NULL, report);
}
static amst_status reduce_patches(amst_mesh *mesh, amst_patches *set, amst_report **report) {
    return amst_reduce_singularities(mesh, set, NULL, report);
}
static amst_status ring_patches(amst_mesh *mesh, amst_patches *set, amst_report **report) {
    return amst_insert_chords(mesh, set, 1, NULL, report);
}

static void of_patches(void **state) {
    (void)state;
    const patch_operation operations[] = {smooth_patches, adapt_patches, reduce_patches, ring_patches};
    amst_context *ctx = new_context(0);
    for (int32_t shape = PLANE; shape <= CURVED; ++shape)
        for (size_t i = 0; i < sizeof operations / sizeof *operations; ++i) {
            amst_mesh *mesh = new_shape(ctx, shape);
            amst_patches *set = NULL;
            amst_report *report = NULL;
            const double centres[2][3] = {{4, 4, 0}, {11, 11, 0}};
            double before[2];
            must(amst_patches_create(mesh, NULL, &set));
            for (amst_id p = 0; p < 2; ++p) {
                amst_id added = -1;
                must(amst_patches_add_ball(set, centres[p], 3, &added));
                assert_int_equal(added, p);
                before[p] = worst_of(mesh, set, p);
            }
            assert_true(operations[i](mesh, set, &report) >= 0);
            for (amst_id p = 0; p < 2; ++p) {
                const double told_before = real_result(report, p, AMST_RESULT_QUALITY_BEFORE);
                const double told_after = real_result(report, p, AMST_RESULT_QUALITY_AFTER);
                if (told_before != before[p] || told_after != worst_of(mesh, set, p))
                    fail_msg("shape %d, operation %d, patch %d: %.17g -> %.17g told, %.17g -> %.17g measured",
                             (int)shape, (int)i, (int)p, told_before, told_after, before[p],
                             worst_of(mesh, set, p));
            }
            amst_report_destroy(report);
            amst_patches_destroy(set);
            amst_mesh_destroy(mesh);
        }
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_whole_meshes),
        cmocka_unit_test(of_patches),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
