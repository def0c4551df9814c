/* NULL for every pointer of every function: AMST_ERR_NULL where it is required, and
 * a sentence that names the parameter. */
#include "grid.h"

/* The name is quoted from the call, so that it is the header's. */
#define null(name, call)                                                                                     \
    do {                                                                                                     \
        refused(AMST_ERR_NULL, call);                                                                        \
        assert_string_equal(amst_last_error(), name " is NULL");                                             \
    } while (0)

static amst_context *ctx;
static amst_mesh *mesh;
static amst_patches *set;
static amst_report *report;
static amst_options *options;

static int setup(void **state) {
    (void)state;
    ctx = new_context(0);
    mesh = new_grid(ctx, 0, 6, 6);
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 6, 1, 4);
    must(amst_options_create(&options));
    must(amst_smooth(mesh, NULL, NULL, &report));
    return 0;
}

static int teardown(void **state) {
    (void)state;
    amst_context_destroy(ctx);
    amst_mesh_destroy(mesh);
    amst_patches_destroy(set);
    amst_report_destroy(report);
    amst_options_destroy(options);
    return 0;
}

static void destroying_nothing(void **state) {
    (void)state;
    amst_context_destroy(NULL);
    amst_options_destroy(NULL);
    amst_mesh_destroy(NULL);
    amst_patches_destroy(NULL);
    amst_report_destroy(NULL);
}

static void contexts_and_options(void **state) {
    (void)state;
    int64_t integer;
    double real;
    null("out", amst_context_create(0, NULL));
    null("ctx", amst_context_set_threads(NULL, 1));
    null("ctx", amst_context_set_log(NULL, AMST_LOG_OFF, NULL, NULL));
    null("ctx", amst_context_set_progress(NULL, NULL, NULL));
    null("ctx", amst_context_set_cancel(NULL, 0));
    null("ctx", amst_context_get_progress(NULL, &real));
    null("fraction", amst_context_get_progress(ctx, NULL));
    must(amst_context_set_log(ctx, AMST_LOG_OFF, NULL, NULL));
    must(amst_context_set_progress(ctx, NULL, NULL));
    null("out", amst_options_create(NULL));
    null("options", amst_options_set_int(NULL, AMST_OPT_SEED, 1));
    null("options", amst_options_set_real(NULL, AMST_OPT_MIN_QUALITY, 0));
    null("options", amst_options_get_int(NULL, AMST_OPT_SEED, &integer));
    null("options", amst_options_get_real(NULL, AMST_OPT_MIN_QUALITY, &real));
    null("options", amst_options_set_edges(NULL, NULL, 0));
    null("options", amst_options_get_edges(NULL, NULL, 0, &integer));
    null("vertices", amst_options_set_edges(options, NULL, 1));
    null("needed", amst_options_get_edges(options, NULL, 0, NULL));
    null("value", amst_options_get_int(options, AMST_OPT_SEED, NULL));
    null("value", amst_options_get_real(options, AMST_OPT_MIN_QUALITY, NULL));
}

static void meshes(void **state) {
    (void)state;
    const double points[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    const int32_t face[4] = {0, 1, 2, 3};
    const int64_t wide[4] = {0, 1, 2, 3};
    amst_mesh *out = NULL;
    int32_t narrow;
    int64_t n;
    double degrees;
    amst_summary summary;
    null("ctx", amst_mesh_create(NULL, 2, points, 4, 0, 0, face, 1, 0, 0, 4, options, &out));
    null("coords", amst_mesh_create(ctx, 2, NULL, 4, 0, 0, face, 1, 0, 0, 4, options, &out));
    null("faces", amst_mesh_create(ctx, 2, points, 4, 0, 0, NULL, 1, 0, 0, 4, options, &out));
    null("out", amst_mesh_create(ctx, 2, points, 4, 0, 0, face, 1, 0, 0, 4, options, NULL));
    null("ctx", amst_mesh_create_i64(NULL, 2, points, 4, 0, 0, wide, 1, 0, 0, 4, options, &out));
    null("coords", amst_mesh_create_i64(ctx, 2, NULL, 4, 0, 0, wide, 1, 0, 0, 4, options, &out));
    null("faces", amst_mesh_create_i64(ctx, 2, points, 4, 0, 0, NULL, 1, 0, 0, 4, options, &out));
    null("out", amst_mesh_create_i64(ctx, 2, points, 4, 0, 0, wide, 1, 0, 0, 4, options, NULL));
    null("ctx", amst_mesh_read(NULL, "mesh.off", options, &out));
    null("path", amst_mesh_read(ctx, NULL, options, &out));
    null("out", amst_mesh_read(ctx, "mesh.off", options, NULL));
    null("mesh", amst_mesh_write(NULL, "mesh.off"));
    null("path", amst_mesh_write(mesh, NULL));
    null("mesh", amst_mesh_clone(NULL, &out));
    null("out", amst_mesh_clone(mesh, NULL));
    null("mesh", amst_mesh_clone_into(NULL, ctx, &out));
    null("ctx", amst_mesh_clone_into(mesh, NULL, &out));
    null("out", amst_mesh_clone_into(mesh, ctx, NULL));
    assert_null(out);
    null("mesh", amst_mesh_get_dim(NULL, &narrow));
    null("dim", amst_mesh_get_dim(mesh, NULL));
    null("mesh", amst_mesh_get_count(NULL, AMST_FACE, &n));
    null("count", amst_mesh_get_count(mesh, AMST_FACE, NULL));
    null("mesh", amst_mesh_get_revision(NULL, &n));
    null("revision", amst_mesh_get_revision(mesh, NULL));
    null("mesh", amst_mesh_set_points(NULL, points, 4));
    null("points", amst_mesh_set_points(mesh, NULL, 49));
    null("mesh", amst_mesh_find_edges(NULL, face, 1, &narrow));
    null("pairs", amst_mesh_find_edges(mesh, NULL, 1, &narrow));
    null("edges", amst_mesh_find_edges(mesh, face, 1, NULL));
    null("mesh", amst_mesh_check(NULL));
    null("mesh", amst_mesh_get_checksum(NULL, &n));
    null("digest", amst_mesh_get_checksum(mesh, NULL));
    null("mesh", amst_mesh_set_flags(NULL, AMST_FACE, NULL, 0, 1, 1));
    null("mesh", amst_mesh_set_markers(NULL, AMST_FACE, NULL, 0, 1));
    null("mesh", amst_mesh_set_marker_name(NULL, AMST_FACE, 1, "a"));
    null("mesh", amst_mesh_detect_features(NULL, 30, &n));
    null("mesh", amst_mesh_compute_cross_field(NULL, NULL));
    null("mesh", amst_mesh_get_alignment(NULL, &degrees));
    null("mean_degrees", amst_mesh_get_alignment(mesh, NULL));
    null("mesh", amst_mesh_set_surface(NULL, NULL, 0, NULL, 0));
    null("triangles", amst_mesh_set_surface(mesh, points, 4, NULL, 1));
    null("mesh", amst_mesh_set_field(NULL, AMST_VERTEX, "a", 1, AMST_CARRY_DROP, points, 49));
    null("name", amst_mesh_set_field(mesh, AMST_VERTEX, NULL, 1, AMST_CARRY_DROP, points, 49));
    null("values", amst_mesh_set_field(mesh, AMST_VERTEX, "a", 1, AMST_CARRY_DROP, NULL, 49));
    null("name", amst_mesh_get_field(mesh, AMST_VERTEX, NULL, NULL, 0, &n));
    null("mesh", amst_mesh_remove_field(NULL, AMST_VERTEX, "a"));
    null("name", amst_mesh_remove_field(mesh, AMST_VERTEX, NULL));
    null("mesh", amst_mesh_mark(NULL, &n));
    null("revision", amst_mesh_mark(mesh, NULL));
    null("mesh", amst_mesh_rollback(NULL, 0));
    null("mesh", amst_mesh_forget(NULL, 0));
    null("mesh", amst_mesh_get_summary(NULL, AMST_METRIC_AREA, &summary));
    null("out", amst_mesh_get_summary(mesh, AMST_METRIC_AREA, NULL));
}

/* handle, needed, and out with a capacity. */
#define null_array(handle, call, type)                                                                       \
    do {                                                                                                     \
        type item;                                                                                           \
        int64_t n;                                                                                           \
        null(#handle, call(NULL, &item, 1, &n));                                                             \
        null("needed", call(handle, &item, 1, NULL));                                                        \
        null("out", call(handle, NULL, 1, &n));                                                              \
    } while (0)

#define mesh_flags(m, out, capacity, needed) amst_mesh_get_flags(m, AMST_FACE, out, capacity, needed)
#define mesh_markers(m, out, capacity, needed) amst_mesh_get_markers(m, AMST_FACE, out, capacity, needed)
#define marker_list(m, out, capacity, needed) amst_mesh_get_marker_list(m, AMST_FACE, out, capacity, needed)
#define marker_name(m, out, capacity, needed)                                                                \
    amst_mesh_get_marker_name(m, AMST_FACE, 1, out, capacity, needed)
#define mesh_field(m, out, capacity, needed) amst_mesh_get_field(m, AMST_FACE, "a", out, capacity, needed)
#define mesh_geometry(m, out, capacity, needed)                                                              \
    amst_mesh_get_geometry(m, AMST_GEOMETRY_NORMALS, out, capacity, needed)
#define vertex_faces(m, out, capacity, needed) amst_mesh_get_vertex_faces(m, offsets, out, capacity, needed)
#define mesh_quality(m, out, capacity, needed)                                                               \
    amst_mesh_get_quality(m, AMST_METRIC_AREA, out, capacity, needed)
#define patch_faces(p, out, capacity, needed) amst_patches_get_faces(p, 0, out, capacity, needed)
#define patch_boundary(p, out, capacity, needed) amst_patches_get_boundary(p, 0, out, capacity, needed)
#define patch_corners(p, out, capacity, needed) amst_patches_get_corners(p, 0, out, capacity, needed)
#define report_origin(r, out, capacity, needed) amst_report_get_origin(r, AMST_FACE, out, capacity, needed)

static void arrays(void **state) {
    (void)state;
    amst_patches *patches = set;
    null_array(mesh, amst_mesh_get_points, double);
    null_array(mesh, amst_mesh_get_faces, amst_id);
    null_array(mesh, amst_mesh_get_edges, amst_id);
    null_array(mesh, amst_mesh_get_edge_faces, amst_id);
    int32_t offsets[50] = {0};
    null_array(mesh, vertex_faces, amst_id);
    null_array(mesh, mesh_geometry, double);
    null_array(mesh, amst_mesh_get_crossed_edges, amst_id);
    null_array(mesh, amst_mesh_get_split_edges, amst_id);
    null_array(mesh, amst_mesh_get_valences, int32_t);
    null_array(mesh, amst_mesh_get_singularities, amst_id);
    null_array(mesh, mesh_flags, int32_t);
    null_array(mesh, mesh_markers, int32_t);
    null_array(mesh, marker_list, int32_t);
    null_array(mesh, marker_name, char);
    const double values[36] = {0};
    must(amst_mesh_set_field(mesh, AMST_FACE, "a", 1, AMST_CARRY_DROP, values, 36));
    null_array(mesh, mesh_field, double);
    null_array(mesh, mesh_quality, double);
    null_array(patches, patch_faces, amst_id);
    null_array(patches, patch_boundary, amst_id);
    null_array(patches, patch_corners, amst_id);
    null_array(report, report_origin, amst_id);
}

static void patches(void **state) {
    (void)state;
    const double here[3] = {0, 0, 0};
    const amst_id one[1] = {35};
    amst_patches *out = NULL;
    int32_t defects;
    int64_t n;
    null("mesh", amst_patches_create(NULL, options, &out));
    null("out", amst_patches_create(mesh, options, NULL));
    null("patches", amst_patches_add_faces(NULL, one, 1, NULL));
    null("faces", amst_patches_add_faces(set, NULL, 1, NULL));
    null("patches", amst_patches_add_rings(NULL, 0, 1, NULL));
    null("patches", amst_patches_add_ball(NULL, here, 1, NULL));
    null("center", amst_patches_add_ball(set, NULL, 1, NULL));
    null("patches", amst_patches_add_box(NULL, here, here, NULL));
    null("low", amst_patches_add_box(set, NULL, here, NULL));
    null("high", amst_patches_add_box(set, here, NULL, NULL));
    null("patches", amst_patches_decompose(NULL, AMST_DECOMPOSE_CLUSTERS, NULL));
    null("patches", amst_patches_set_corners(NULL, 0, one, 1));
    null("vertices", amst_patches_set_corners(set, 0, NULL, 3));
    null("patches", amst_patches_set_alpha(NULL, 0, 1));
    null("patches", amst_patches_get_count(NULL, &n));
    null("count", amst_patches_get_count(set, NULL));
    null("patches", amst_patches_check(NULL, 0, &defects, NULL));
    null("defects", amst_patches_check(set, 0, NULL, NULL));
    null("patches", amst_patches_predict(NULL, 0, 1, options, &n, &n));
    null("patches", amst_patches_write(NULL, "patches.svg"));
    null("path", amst_patches_write(set, NULL));
    assert_null(out);
    must(amst_patches_get_count(set, &n));
    assert_int_equal(n, 1);
}

static void operations_and_reports(void **state) {
    (void)state;
    int64_t integer;
    double real;
    null("mesh", amst_adapt(NULL, set, 1, options, NULL));
    null("mesh", amst_reduce_singularities(NULL, set, options, NULL));
    null("mesh", amst_smooth(NULL, set, options, NULL));
    null("mesh", amst_clean(NULL, options, NULL));
    null("mesh", amst_collapse_chord(NULL, 0, options, NULL));
    null("mesh", amst_split_chord(NULL, 0, 1, options, NULL));
    null("mesh", amst_insert_chords(NULL, set, 1, options, NULL));
    null("patches", amst_insert_chords(mesh, NULL, 1, options, NULL));
    null("report", amst_report_get_int(NULL, AMST_ALL, AMST_RESULT_STATUS, &integer));
    null("value", amst_report_get_int(report, AMST_ALL, AMST_RESULT_STATUS, NULL));
    null("report", amst_report_get_real(NULL, AMST_ALL, AMST_RESULT_ALPHA, &real));
    null("value", amst_report_get_real(report, AMST_ALL, AMST_RESULT_ALPHA, NULL));
    null("report", amst_report_get_valence(NULL, AMST_ALL, 0, 4, &integer));
    null("count", amst_report_get_valence(report, AMST_ALL, 0, 4, NULL));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(destroying_nothing, setup, teardown),
        cmocka_unit_test_setup_teardown(contexts_and_options, setup, teardown),
        cmocka_unit_test_setup_teardown(meshes, setup, teardown),
        cmocka_unit_test_setup_teardown(arrays, setup, teardown),
        cmocka_unit_test_setup_teardown(patches, setup, teardown),
        cmocka_unit_test_setup_teardown(operations_and_reports, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
