/* Files: there and back in every format, and files that are none. */
#include <stdio.h>

#include "grid.h"

static void write_text(const char *path, const char *text) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, strlen(text), file), strlen(text));
    assert_int_equal(fclose(file), 0);
}

static int exists(const char *path) {
    FILE *file = fopen(path, "rb");
    if (file != NULL)
        fclose(file);
    return file != NULL;
}

static void there_and_back(void **state) {
    (void)state;
    const char *const paths[] = {"capi_file.off", "capi_file.obj", "capi_file.ply",
                                 "capi_file.msh", "capi_file.su2", "capi_file.vtk"};
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 5, 4);
    double *points = points_of(mesh);
    points[2 * 7] += 1.0 / 3; /* no short decimal fraction */
    must(amst_mesh_set_points(mesh, points, 30));
    free(points);
    for (size_t k = 0; k < sizeof paths / sizeof *paths; ++k) {
        amst_mesh *back = NULL;
        must(amst_mesh_write(mesh, paths[k]));
        must(amst_mesh_read(ctx, paths[k], NULL, &back));
        assert_true(checksum(back) == checksum(mesh));
        amst_mesh_destroy(back);
        assert_int_equal(remove(paths[k]), 0);
    }
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static const char marked[] = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                             "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n"
                             "$Elements\n4\n"
                             "1 1 2 7 7 1 2\n2 1 2 9 9 1 5\n" /* an edge with number 7; no edge of the mesh */
                             "3 3 2 11 11 1 2 5 4\n4 3 2 12 12 2 3 6 5\n$EndElements\n";

static void markers_are_features_and_come_back(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_options *plain = NULL;
    amst_mesh *mesh = NULL, *back = NULL;
    amst_patches *set = NULL;
    const amst_id both[2] = {0, 1};
    int32_t defects = 0, dim = 0;
    write_text("capi_marked.msh", marked);
    assert_int_equal(amst_mesh_read(ctx, "capi_marked.msh", NULL, &mesh), AMST_PARTIAL);
    must(amst_mesh_get_dim(mesh, &dim));
    assert_int_equal(dim, 2);
    assert_int_equal(count_of(mesh, AMST_FACE), 2);
    must(amst_options_create(&plain));
    must(amst_options_set_int(plain, AMST_OPT_REPAIR_PATCHES, 0));
    must(amst_patches_create(mesh, plain, &set));
    must(amst_patches_add_faces(set, both, 2, NULL));
    must(amst_patches_check(set, 0, &defects, NULL));
    assert_true(defects & AMST_DEFECT_CROSSES_FEATURE); /* regions 11 and 12 */
    must(amst_mesh_write(mesh, "capi_marked.msh"));
    must(amst_mesh_read(ctx, "capi_marked.msh", NULL, &back));
    assert_true(checksum(back) == checksum(mesh)); /* markers are in the digest */
    remove("capi_marked.msh");
    amst_patches_destroy(set);
    amst_options_destroy(plain);
    amst_mesh_destroy(mesh);
    amst_mesh_destroy(back);
    amst_context_destroy(ctx);
}

static const char first[] = "$NOD\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$ENDNOD\n"
                            "$ELM\n3\n1 1 1 7 2 1 2\n2 3 0 11 4 1 2 5 4\n3 3 0 11 4 2 3 6 5\n$ENDELM\n";
static const char second[] = "NDIME= 2\nNELEM= 2\n9 0 1 4 3\n9 1 2 5 4\n"
                             "NPOIN= 6\n0 0\n1 0\n2 0\n0 1\n1 1\n2 1\n"
                             "NMARK= 1\nMARKER_TAG= low\nMARKER_ELEMS= 1\n3 0 1\n";

static void one_mesh_in_two_formats(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *old = NULL, *su2 = NULL;
    write_text("capi_first.msh", first);
    write_text("capi_second.su2", second);
    must(amst_mesh_read(ctx, "capi_first.msh", NULL, &old));
    must(amst_mesh_read(ctx, "capi_second.su2", NULL, &su2));
    assert_int_equal(count_of(su2, AMST_FACE), 2);
    assert_true(checksum(old) == checksum(su2)); /* the first edge has number 1 in both */
    remove("capi_first.msh");
    remove("capi_second.su2");
    amst_mesh_destroy(old);
    amst_mesh_destroy(su2);
    amst_context_destroy(ctx);
}

static void pictures(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 5, 5);
    amst_options *plain = NULL;
    amst_patches *set = NULL;
    amst_mesh *back = NULL;
    const amst_id apart[2] = {0, 24};
    must(amst_options_create(&plain));
    must(amst_options_set_int(plain, AMST_OPT_REPAIR_PATCHES, 0));
    must(amst_patches_create(mesh, plain, &set));
    add_square(set, 5, 1, 4);
    must(amst_patches_add_faces(set, apart, 2, NULL));
    must(amst_mesh_write(mesh, "capi_mesh.svg"));
    must(amst_patches_write(set, "capi_patches.svg"));
    refused(AMST_ERR_UNSUPPORTED, amst_patches_write(set, "capi_patches.off"));
    refused(AMST_ERR_UNSUPPORTED, amst_mesh_read(ctx, "capi_mesh.svg", NULL, &back));
    assert_int_equal(remove("capi_mesh.svg"), 0);
    assert_int_equal(remove("capi_patches.svg"), 0);
    assert_null(back);
    amst_patches_destroy(set);
    amst_options_destroy(plain);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* Two squares in two regions, each cut in two; the edge between them has a number, and so has a diagonal. */
static const char triangles[] = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n"
                                "$Elements\n6\n1 1 2 7 7 2 5\n2 1 2 8 8 %c 5\n"
                                "3 2 2 11 11 1 2 5\n4 2 2 11 11 1 5 4\n"
                                "5 2 2 12 12 2 3 6\n6 2 2 12 12 2 6 5\n$EndElements\n";

static void triangles_become_quads(void **state) {
    (void)state;
    const char *const path = "capi_triangles.msh";
    amst_context *ctx = new_context(1);
    char text[sizeof triangles];
    for (int marked = 0; marked < 2; ++marked) {
        amst_mesh *mesh = NULL, *back = NULL;
        amst_id edges[3];
        /* 2 5 is numbered in any case, 1 5 is the diagonal of the first square */
        snprintf(text, sizeof text, triangles, marked ? '1' : '2');
        write_text(path, text);
        must(amst_mesh_read(ctx, path, NULL, &mesh));
        /* The diagonal must stay and so must the boundary: both triangles get a vertex on it, and are five.
         */
        assert_int_equal(count_of(mesh, AMST_FACE), marked ? 11 : 2);
        assert_int_equal(count_of(mesh, AMST_VERTEX), marked ? 15 : 6);
        must(amst_mesh_check(mesh));
        const amst_id pairs[6] = {2, 5, 1, marked ? 7 : 5, 2, 6};
        must(amst_mesh_find_edges(mesh, pairs, 3, edges));
        assert_true(edges[0] > 0);
        assert_int_equal(edges[1] > 0, marked);
        assert_int_equal(edges[2], 0);
        must(amst_mesh_write(mesh, path)); /* the markers come back */
        must(amst_mesh_read(ctx, path, NULL, &back));
        assert_true(checksum(back) == checksum(mesh));
        amst_mesh_destroy(back);
        amst_mesh_destroy(mesh);
    }
    amst_options *options = NULL;
    amst_mesh *mesh = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_QUADRANGULATE, 1));
    write_text(path, text);
    must(amst_mesh_read(ctx, path, options, &mesh));
    assert_int_equal(count_of(mesh, AMST_FACE), 12);
    must(amst_mesh_check(mesh));
    amst_mesh_destroy(mesh);
    amst_options_destroy(options);
    assert_int_equal(remove(path), 0);
    amst_context_destroy(ctx);
}

static void a_byte_order_mark_is_passed_over(void **state) {
    (void)state;
    const char *const files[][2] = {
        {"capi_mark.off", "\xEF\xBB\xBFOFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"},
        {"capi_mark.obj", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"},
        {"capi_mark.su2",
         "\xEF\xBB\xBFNDIME= 2\nNELEM= 1\n9 0 1 2 3\nNPOIN= 4\n0 0\n1 0\n1 1\n0 1\nNMARK= 0\n"},
    };
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = NULL;
    for (size_t k = 0; k < sizeof files / sizeof *files; ++k) {
        write_text(files[k][0], files[k][1]);
        must(amst_mesh_read(ctx, files[k][0], NULL, &mesh));
        assert_int_equal(count_of(mesh, AMST_FACE), 1);
        amst_mesh_destroy(mesh);
        assert_int_equal(remove(files[k][0]), 0);
    }
    write_text("capi_mark.off", "\xFF\xFEO"); /* UTF-16 */
    mesh = NULL;
    refused(AMST_ERR_UNSUPPORTED, amst_mesh_read(ctx, "capi_mark.off", NULL, &mesh));
    assert_int_equal(remove("capi_mark.off"), 0);
    assert_null(mesh);
    amst_context_destroy(ctx);
}

static void what_is_no_mesh_is_refused(void **state) {
    (void)state;
    static const struct {
        const char *path, *text;
        amst_status status;
    } bad[] = {
        {"capi_bad.off", "", AMST_ERR_FORMAT},
        {"capi_bad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n", AMST_ERR_FORMAT},
        {"capi_bad.off", "OFF\n100000000000 1 0\n0 0 0\n", AMST_ERR_FORMAT},
        {"capi_bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n2 0 1\n", AMST_ERR_NOT_QUAD},
        {"capi_bad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 4\n", AMST_ERR_RANGE},
        {"capi_bad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 nan 0\n0 1 0\n4 0 1 2 3\n", AMST_ERR_NOT_FINITE},
        {"capi_bad.off", "OFF\n4 0 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n", AMST_ERR_RANGE},
        {"capi_bad.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n4 0 1 2 3\n",
         AMST_ERR_NOT_MANIFOLD},
        {"capi_bad.vtk", "not a vtk file\n", AMST_ERR_FORMAT},
        {"capi_bad.msh", "$MeshFormat\n2.2 0 8\n", AMST_ERR_FORMAT},
        {"capi_bad.msh", "$NOD\n1\n1 0 0 0\n", AMST_ERR_FORMAT},
        {"capi_bad.su2", "NDIME= 2\n", AMST_ERR_FORMAT},
        {"capi_bad.su2", "NDIME= 2\nNELEM= 1\n10 0 1 2 0\nNPOIN= 3\n0 0\n1 0\n0 1\nNMARK= 0\n",
         AMST_ERR_NOT_QUAD},
        {"capi_bad.stl", "solid\n", AMST_ERR_UNSUPPORTED},
        {"capi_bad", "OFF\n", AMST_ERR_UNSUPPORTED},
    };
    amst_context *ctx = new_context(0);
    for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k) {
        amst_mesh *mesh = NULL;
        write_text(bad[k].path, bad[k].text);
        const amst_status status = amst_mesh_read(ctx, bad[k].path, NULL, &mesh);
        remove(bad[k].path);
        if (status != bad[k].status)
            fail_msg("case %d: %s (%s)", (int)k, amst_status_name(status), amst_last_error());
        assert_null(mesh);
        assert_true(strlen(amst_last_error()) > 10);
    }
    amst_context_destroy(ctx);
}

static void paths_that_lead_nowhere(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 2, 2), *back = NULL;
    refused(AMST_ERR_IO, amst_mesh_read(ctx, "capi_no_such_file.off", NULL, &back));
    refused(AMST_ERR_IO, amst_mesh_write(mesh, "capi_no_such_directory/mesh.off"));
    refused(AMST_ERR_UNSUPPORTED, amst_mesh_write(mesh, "capi_mesh.stl"));
    refused(AMST_ERR_UNSUPPORTED, amst_mesh_write(mesh, ""));
    assert_false(exists("capi_mesh.stl"));
    assert_null(back);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(there_and_back),          cmocka_unit_test(markers_are_features_and_come_back),
        cmocka_unit_test(one_mesh_in_two_formats), cmocka_unit_test(pictures),
        cmocka_unit_test(triangles_become_quads),  cmocka_unit_test(what_is_no_mesh_is_refused),
        cmocka_unit_test(paths_that_lead_nowhere), cmocka_unit_test(a_byte_order_mark_is_passed_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
