/* Markers of vertices, edges and faces, and their names: from the caller, from files, through copies, undoing
 * and operations. */
#include <stdio.h>

#include "grid.h"

static int32_t *markers_of(const amst_mesh *mesh, int32_t entity) {
    const int64_t n = count_of(mesh, entity);
    int64_t needed = -1;
    int32_t *markers = memory(sizeof(int32_t) * (size_t)n);
    must(amst_mesh_get_markers(mesh, entity, markers, n, &needed));
    assert_int_equal(needed, n);
    return markers;
}

static void assert_list(const amst_mesh *mesh, int32_t entity, const int32_t *wanted, int64_t n) {
    int32_t list[8];
    int64_t needed = -1;
    must(amst_mesh_get_marker_list(mesh, entity, NULL, 0, &needed));
    assert_int_equal(needed, n);
    must(amst_mesh_get_marker_list(mesh, entity, list, 8, &needed));
    for (int64_t i = 0; i < n; ++i)
        assert_int_equal(list[i], wanted[i]);
}

static void assert_name(const amst_mesh *mesh, int32_t entity, int32_t marker, const char *wanted) {
    char name[64];
    int64_t needed = -1;
    must(amst_mesh_get_marker_name(mesh, entity, marker, NULL, 0, &needed));
    assert_int_equal(needed, strlen(wanted) + 1);
    must(amst_mesh_get_marker_name(mesh, entity, marker, name, needed, &needed));
    assert_string_equal(name, wanted);
}

static void every_entity_has_markers(void **state) {
    (void)state;
    const int32_t entities[] = {AMST_VERTEX, AMST_EDGE, AMST_FACE};
    for (int32_t base = 0; base < 2; ++base) {
        amst_context *ctx = new_context(base);
        amst_mesh *mesh = new_grid(ctx, base, 3, 3);
        const int64_t before = checksum(mesh);
        for (size_t k = 0; k < 3; ++k) {
            const amst_id ids[3] = {base, base + 8, base};
            const int32_t list[2] = {-2, 7};
            assert_list(mesh, entities[k], NULL, 0);
            must(amst_mesh_set_markers(mesh, entities[k], ids, 3, 7)); /* no ids: the base is not added */
            must(amst_mesh_set_markers(mesh, entities[k], ids + 1, 1, -2));
            int32_t *markers = markers_of(mesh, entities[k]);
            for (int64_t i = 0; i < count_of(mesh, entities[k]); ++i)
                assert_int_equal(markers[i], i == 0 ? 7 : i == 8 ? -2 : 0);
            free(markers);
            assert_list(mesh, entities[k], list, 2);
            assert_true(checksum(mesh) != before);
            must(amst_mesh_set_markers(mesh, entities[k], NULL, 0, 0));
            assert_list(mesh, entities[k], NULL, 0);
            if (entities[k] == AMST_VERTEX) {
                must(amst_mesh_set_flags(mesh, AMST_VERTEX, NULL, 0, AMST_FLAG_CORNER, 0));
            }
            assert_true(checksum(mesh) == before);
        }
        assert_int_equal(revision(mesh), 0);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

static void marked_vertices_are_corners(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 3, 3);
    const amst_id middle = 5;
    int32_t flags[16];
    int64_t n = 0;
    must(amst_mesh_set_markers(mesh, AMST_VERTEX, &middle, 1, 77));
    must(amst_mesh_set_flags(mesh, AMST_VERTEX, NULL, 0, 7, 0));
    must(amst_mesh_get_flags(mesh, AMST_VERTEX, flags, 16, &n));
    for (int64_t v = 0; v < n; ++v)
        assert_int_equal(flags[v], v == middle ? AMST_FLAG_CORNER : 0);
    must(amst_mesh_set_markers(mesh, AMST_VERTEX, &middle, 1, 0));
    must(amst_mesh_get_flags(mesh, AMST_VERTEX, flags, 16, &n));
    assert_int_equal(flags[middle], AMST_FLAG_CORNER); /* nobody knows whose it is */
    must(amst_mesh_set_flags(mesh, AMST_VERTEX, &middle, 1, AMST_FLAG_CORNER, 0));
    must(amst_mesh_get_flags(mesh, AMST_VERTEX, flags, 16, &n));
    assert_int_equal(flags[middle], 0);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void names_are_kept(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    amst_mesh *mesh = new_grid(ctx, 1, 2, 2);
    const int64_t before = checksum(mesh);
    char small[3] = "ab";
    int64_t needed = 0;
    must(amst_mesh_set_marker_name(mesh, AMST_EDGE, 7, "inlet"));
    must(amst_mesh_set_marker_name(mesh, AMST_FACE, 7,
                                   "\xc3\x9c"
                                   "berlauf 1"));
    must(amst_mesh_set_marker_name(mesh, AMST_EDGE, -1, "wall"));
    assert_name(mesh, AMST_EDGE, 7, "inlet");
    assert_name(mesh, AMST_FACE, 7,
                "\xc3\x9c"
                "berlauf 1");
    assert_name(mesh, AMST_EDGE, -1, "wall");
    assert_name(mesh, AMST_VERTEX, 7, "");
    assert_name(mesh, AMST_EDGE, 8, "");
    assert_name(mesh, AMST_EDGE, 0, "");
    refused(AMST_ERR_BUFFER_TOO_SMALL, amst_mesh_get_marker_name(mesh, AMST_EDGE, 7, small, 3, &needed));
    assert_int_equal(needed, 6);
    assert_string_equal(small, "ab");
    must(amst_mesh_set_marker_name(mesh, AMST_EDGE, 7, "outlet"));
    assert_name(mesh, AMST_EDGE, 7, "outlet");
    must(amst_mesh_set_marker_name(mesh, AMST_EDGE, 7, ""));
    must(amst_mesh_set_marker_name(mesh, AMST_EDGE, -1, NULL));
    assert_name(mesh, AMST_EDGE, 7, "");
    assert_name(mesh, AMST_EDGE, -1, "");
    assert_true(checksum(mesh) == before && revision(mesh) == 0);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void bad_arguments_change_nothing(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    amst_mesh *mesh = new_grid(ctx, 1, 3, 3);
    const int64_t before = checksum(mesh);
    const amst_id last_is_bad[3] = {1, 2, 17}, zero[1] = {0};
    int32_t value = 5;
    int64_t needed = 0;
    char name[8];
    refused(AMST_ERR_RANGE, amst_mesh_set_markers(mesh, AMST_VERTEX, last_is_bad, 3, 1));
    assert_error_names(AMST_VERTEX, 17);
    refused(AMST_ERR_RANGE, amst_mesh_set_markers(mesh, AMST_FACE, zero, 1, 1));
    assert_error_names(AMST_FACE, 0);
    refused(AMST_ERR_RANGE, amst_mesh_set_markers(mesh, AMST_EDGE, last_is_bad, -1, 1));
    refused(AMST_ERR_ARGUMENT, amst_mesh_set_markers(mesh, 3, NULL, 0, 1));
    refused(AMST_ERR_NULL, amst_mesh_set_markers(NULL, AMST_EDGE, NULL, 0, 1));
    must(amst_mesh_set_markers(mesh, AMST_EDGE, zero, 0, 1));
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_markers(mesh, -1, NULL, 0, &needed));
    refused(AMST_ERR_NULL, amst_mesh_get_markers(mesh, AMST_EDGE, NULL, 0, NULL));
    refused(AMST_ERR_BUFFER_TOO_SMALL, amst_mesh_get_markers(mesh, AMST_EDGE, &value, 1, &needed));
    assert_true(needed == 24 && value == 5);
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_marker_list(mesh, 3, NULL, 0, &needed));
    refused(AMST_ERR_ARGUMENT, amst_mesh_set_marker_name(mesh, 3, 1, "a"));
    refused(AMST_ERR_ARGUMENT, amst_mesh_set_marker_name(mesh, AMST_EDGE, 0, "a"));
    refused(AMST_ERR_ARGUMENT, amst_mesh_set_marker_name(mesh, AMST_EDGE, 1, "a \"b\""));
    refused(AMST_ERR_ARGUMENT, amst_mesh_set_marker_name(mesh, AMST_EDGE, 1, "a\nb"));
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_marker_name(mesh, 3, 1, name, 8, &needed));
    refused(AMST_ERR_NULL, amst_mesh_get_marker_name(NULL, 0, 1, name, 8, &needed));
    assert_name(mesh, AMST_EDGE, 1, "");
    assert_true(checksum(mesh) == before);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void copies_and_savepoints_have_them(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 3, 3), *copy = NULL;
    const amst_id one = 1;
    const int32_t seven = 7;
    int64_t saved = -1;
    for (int32_t entity = AMST_VERTEX; entity <= AMST_FACE; ++entity)
        must(amst_mesh_set_markers(mesh, entity, &one, 1, 7));
    must(amst_mesh_set_marker_name(mesh, AMST_EDGE, 7, "inlet"));
    const int64_t marked = checksum(mesh);
    must(amst_mesh_mark(mesh, &saved));
    must(amst_mesh_clone(mesh, &copy));
    for (int32_t entity = AMST_VERTEX; entity <= AMST_FACE; ++entity)
        must(amst_mesh_set_markers(mesh, entity, NULL, 0, 9));
    must(amst_mesh_set_marker_name(mesh, AMST_EDGE, 7, "outlet"));
    must(amst_mesh_rollback(mesh, saved));
    for (amst_mesh *same = mesh; same != NULL; same = same == mesh ? copy : NULL) {
        assert_true(checksum(same) == marked);
        for (int32_t entity = AMST_VERTEX; entity <= AMST_FACE; ++entity)
            assert_list(same, entity, &seven, 1);
        assert_name(same, AMST_EDGE, 7, "inlet");
    }
    amst_mesh_destroy(copy);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

typedef struct heard {
    int n;
    char last[400];
} heard;

static void hear(void *user, int32_t level, const char *message) {
    heard *to = user;
    assert_int_equal(level, AMST_LOG_WARNING);
    ++to->n;
    snprintf(to->last, sizeof to->last, "%s", message);
}

/* A 2 x 2 grid whose middle vertex is a well, cut in eight triangles around it: two squares of four. */
static const char well[] =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n0 77 \"well\"\n1 1 "
    "\"wall\"\n$EndPhysicalNames\n"
    "$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n7 .5 .5 0\n8 1.5 .5 0\n$EndNodes\n"
    "$Elements\n%d\n1 15 2 77 5 7\n2 1 2 1 1 1 2\n3 2 2 0 1 1 2 7\n4 2 2 0 1 2 5 7\n5 2 2 0 1 5 4 7\n"
    "6 2 2 0 1 4 1 7\n7 2 2 0 1 2 3 8\n8 2 2 0 1 3 6 8\n9 2 2 0 1 6 5 8\n10 2 2 0 1 5 2 8\n%s$EndElements\n";

static amst_mesh *read_well(amst_context *ctx, int n, const char *more, amst_status status) {
    amst_mesh *mesh = NULL;
    FILE *file = fopen("capi_well.msh", "wb");
    assert_non_null(file);
    assert_true(fprintf(file, well, n, more) > 0);
    assert_int_equal(fclose(file), 0);
    assert_int_equal(amst_mesh_read(ctx, "capi_well.msh", NULL, &mesh), status);
    assert_non_null(mesh);
    assert_int_equal(remove("capi_well.msh"), 0);
    return mesh;
}

static void a_physical_point_stays(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = read_well(ctx, 10, "", AMST_OK), *back = NULL;
    int32_t valences[32];
    int64_t n = 0;
    must(amst_mesh_get_valences(mesh, valences, 32, &n));
    assert_true(valences[6] > 0);     /* the well */
    assert_int_equal(valences[7], 0); /* the other one */
    must(amst_adapt(mesh, NULL, 8, NULL, NULL));
    int32_t *markers = markers_of(mesh, AMST_VERTEX);
    double *points = points_of(mesh);
    int found = 0;
    for (int64_t v = 0; v < count_of(mesh, AMST_VERTEX); ++v)
        if (markers[v] != 0) {
            assert_int_equal(markers[v], 77);
            assert_true(points[2 * v] == .5 && points[2 * v + 1] == .5);
            ++found;
        }
    assert_int_equal(found, 1);
    free(markers);
    free(points);
    must(amst_mesh_write(mesh, "capi_well.msh"));
    must(amst_mesh_read(ctx, "capi_well.msh", NULL, &back));
    assert_true(checksum(back) == checksum(mesh));
    assert_name(back, AMST_VERTEX, 77, "well");
    assert_name(back, AMST_EDGE, 1, "wall");
    assert_int_equal(remove("capi_well.msh"), 0);
    amst_mesh_destroy(back);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void what_is_left_out_is_told(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    heard log = {0, ""};
    must(amst_context_set_log(ctx, AMST_LOG_WARNING, hear, &log));
    amst_mesh *mesh = read_well(ctx, 11, "11 1 2 4 4 1 3\n", AMST_PARTIAL); /* from corner to corner */
    assert_int_equal(log.n, 1);
    assert_non_null(strstr(log.last, "amst_mesh_read: 1 lines"));
    assert_non_null(strstr(log.last, "1-3 (4)"));
    assert_non_null(strstr(log.last, amst_last_error()));
    amst_mesh_destroy(mesh);
    mesh = read_well(ctx, 11, "11 1 2 4 4 1 2\n", AMST_OK); /* in two groups */
    assert_int_equal(log.n, 2);
    assert_non_null(strstr(log.last, "1-2 (1, 4)"));
    must(amst_mesh_write(mesh, "capi_well.vtk")); /* has a place for all */
    assert_int_equal(log.n, 2);
    assert_int_equal(remove("capi_well.vtk"), 0);
    must(amst_mesh_write(mesh, "capi_well.obj"));
    assert_true(log.n > 2);
    assert_non_null(strstr(log.last, "amst_mesh_write: .obj has no place for"));
    assert_int_equal(remove("capi_well.obj"), 0);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_entity_has_markers),
        cmocka_unit_test(marked_vertices_are_corners),
        cmocka_unit_test(names_are_kept),
        cmocka_unit_test(bad_arguments_change_nothing),
        cmocka_unit_test(copies_and_savepoints_have_them),
        cmocka_unit_test(a_physical_point_stays),
        cmocka_unit_test(what_is_left_out_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
