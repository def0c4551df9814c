/* What a new mesh makes the log say: faces turned over, and what mostly is a mistake. */
#include <math.h>
#include <stdio.h>

#include "grid.h"

typedef struct said {
    int warnings;
    char text[1024];
} said;

static void hear(void *user, int32_t level, const char *message) {
    said *heard = user;
    if (level != AMST_LOG_WARNING)
        return;
    ++heard->warnings;
    snprintf(heard->text, sizeof heard->text, "%s", message);
}

static amst_context *listening(int32_t index_base, said *heard) {
    amst_context *ctx = new_context(index_base);
    must(amst_context_set_log(ctx, AMST_LOG_WARNING, hear, heard));
    return ctx;
}

static void turn(int32_t *faces, int face) {
    const int32_t second = faces[4 * face + 1];
    faces[4 * face + 1] = faces[4 * face + 3];
    faces[4 * face + 3] = second;
}

static void faces_are_turned_over_and_counted(void **state) {
    (void)state;
    for (int32_t base = 0; base < 2; ++base) {
        said heard = {0, ""};
        amst_context *ctx = listening(base, &heard);
        amst_mesh *right = new_grid(ctx, base, 4, 3), *mesh = NULL;
        assert_int_equal(heard.warnings, 0);
        double *points = grid_points(4, 3);
        int32_t *faces = grid_faces(4, 3, base);
        for (int f = 2; f < 12; f += 3)
            turn(faces, f);
        must(amst_mesh_create(ctx, 2, points, 20, 0, 0, faces, 12, 0, 0, 4, NULL, &mesh));
        assert_true(checksum(mesh) == checksum(right)); /* the first corner stays the first */
        assert_int_equal(heard.warnings, 1);
        assert_string_equal(heard.text, base == 0 ? "amst_mesh_create: 4 of 12 faces ran the other way round "
                                                    "and were turned over, the first of them face 2"
                                                  : "amst_mesh_create: 4 of 12 faces ran the other way round "
                                                    "and were turned over, the first of them face 3");
        amst_mesh_destroy(mesh);
        amst_mesh_destroy(right);
        amst_context_destroy(ctx);
        free(points);
        free(faces);
    }
}

static void files_too(void **state) {
    (void)state;
    const char *const files[][2] = {
        {"capi_turned.su2", "NDIME= 2\nNELEM= 2\n9 0 1 4 3\n5 1 4 2\n" /* a triangle, clockwise */
                            "NPOIN= 5\n0 0\n1 0\n2 0\n0 1\n1 1\nNMARK= 0\n"},
        {"capi_turned.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n4 0 1 4 3\n3 1 4 2\n"},
    };
    said heard = {0, ""};
    amst_context *ctx = listening(0, &heard);
    for (size_t k = 0; k < 2; ++k) {
        amst_mesh *mesh = NULL;
        FILE *file = fopen(files[k][0], "wb");
        assert_non_null(file);
        assert_true(fputs(files[k][1], file) >= 0);
        assert_int_equal(fclose(file), 0);
        must(amst_mesh_read(ctx, files[k][0], NULL, &mesh));
        assert_string_equal(heard.text,
                            "amst_mesh_read: 1 of 2 faces ran the other way round and were turned "
                            "over, the first of them face 1");
        must(amst_mesh_check(mesh));
        amst_mesh_destroy(mesh);
        assert_int_equal(remove(files[k][0]), 0);
    }
    amst_context_destroy(ctx);
}

/* n by n squares, each with vertices of its own. */
static amst_mesh *soup(amst_context *ctx, int n) {
    double *points = memory(sizeof(double) * 8 * (size_t)(n * n));
    int32_t *faces = memory(sizeof(int32_t) * 4 * (size_t)(n * n));
    for (int f = 0; f < n * n; ++f)
        for (int k = 0; k < 4; ++k) {
            points[8 * f + 2 * k] = f % n + (k == 1 || k == 2);
            points[8 * f + 2 * k + 1] = f / n + (k >= 2);
            faces[4 * f + k] = 4 * f + k;
        }
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 2, points, 4 * n * n, 0, 0, faces, n * n, 0, 0, 4, NULL, &mesh));
    free(points);
    free(faces);
    return mesh;
}

static void components_of_one_face(void **state) {
    (void)state;
    said heard = {0, ""};
    amst_context *ctx = listening(0, &heard);
    amst_mesh *mesh = soup(ctx, 6);
    assert_int_equal(heard.warnings, 1);
    assert_non_null(strstr(heard.text, "36 components of one face"));
    assert_non_null(strstr(heard.text, "weld"));
    const double alpha[2] = {0.5, 2};
    for (int k = 0; k < 2; ++k) {
        assert_int_equal(amst_adapt(mesh, NULL, alpha[k], NULL, NULL), AMST_PARTIAL);
        assert_non_null(strstr(amst_last_error(), "36 components of one face"));
        assert_non_null(strstr(amst_last_error(), "weld"));
    }
    amst_mesh_destroy(mesh);
    heard.warnings = 0;
    amst_mesh_destroy(soup(ctx, 1)); /* one face may be alone */
    assert_int_equal(heard.warnings, 0);
    amst_context_destroy(ctx);
}

/* Three rows of two squares; the right one of the second row is cut in two. */
static void one_hanging_vertex_is_a_slit(void **state) {
    (void)state;
    double points[2 * 14];
    int32_t faces[4 * 7];
    double *grid = grid_points(2, 3);
    int32_t *squares = grid_faces(2, 3, 1);
    memcpy(points, grid, sizeof(double) * 24);
    memcpy(faces, squares, sizeof(int32_t) * 24);
    free(grid);
    free(squares);
    const double cut[4] = {1, 1.5, 2, 1.5};
    memcpy(points + 24, cut, sizeof cut);
    const int32_t lower[4] = {5, 6, 14, 13}, upper[4] = {13, 14, 9, 8};
    memcpy(faces + 4 * 3, lower, sizeof lower);
    memcpy(faces + 4 * 6, upper, sizeof upper);
    said heard = {0, ""};
    amst_context *ctx = listening(1, &heard);
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 2, points, 14, 0, 0, faces, 7, 0, 0, 4, NULL, &mesh));
    assert_int_equal(heard.warnings, 1);
    assert_non_null(strstr(heard.text, "1 vertex hangs in the middle of an edge, the first of them vertex 13 "
                                       "between vertices 5 and 8"));
    amst_mesh_destroy(mesh);

    /* Without the third row the faces at an end of the edge fall apart. */
    mesh = NULL;
    memcpy(faces + 16, upper, sizeof upper);
    refused(AMST_ERR_NOT_MANIFOLD,
            amst_mesh_create(ctx, 2, points, 14, 0, 0, faces, 5, 0, 0, 4, NULL, &mesh));
    assert_error_names(AMST_VERTEX, 13);
    assert_non_null(
        strstr(amst_last_error(), "vertex 13 hangs in the middle of the edge between vertices 5"));
    assert_null(mesh);
    amst_context_destroy(ctx);
}

enum { around = 12, rings = 5 };

/* The smallest sine of the corners of faces beyond the first ring. */
static double least_sound(const amst_mesh *mesh) {
    double *points = points_of(mesh), least = 1;
    const int64_t n = count_of(mesh, AMST_FACE);
    amst_id *faces = memory(sizeof(amst_id) * 4 * (size_t)n);
    int64_t needed = 0;
    must(amst_mesh_get_faces(mesh, faces, 4 * n, &needed));
    for (int64_t f = around; f < n; ++f)
        for (int k = 0; k < 4; ++k) {
            const double *p = points + 2 * faces[4 * f + k], *q = points + 2 * faces[4 * f + (k + 1) % 4],
                         *r = points + 2 * faces[4 * f + (k + 3) % 4];
            const double x = q[0] - p[0], y = q[1] - p[1], u = r[0] - p[0], v = r[1] - p[1];
            least = fmin(least, (x * v - y * u) / (hypot(x, y) * hypot(u, v)));
        }
    free(points);
    free(faces);
    return least;
}

/* A disk of rings of quads, the innermost of which have an edge at the pole. */
static void sound_faces_round_a_pole_stay_so(void **state) {
    (void)state;
    double points[2 * (around + 1) * (rings + 1)];
    int32_t faces[4 * around * rings];
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i <= around; ++i) { /* cut open, as on a map */
            points[2 * (j * (around + 1) + i)] = .2 * j * cos(6.283185307179586 * i / around);
            points[2 * (j * (around + 1) + i) + 1] = .2 * j * sin(6.283185307179586 * i / around);
        }
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < around; ++i) {
            const int32_t v = j * (around + 1) + i;
            const int32_t corners[4] = {v, v + around + 1, v + around + 2, v + 1};
            memcpy(faces + 4 * (j * around + i), corners, sizeof corners);
        }
    said heard = {0, ""};
    amst_context *ctx = listening(0, &heard);
    for (int k = 0; k < 2; ++k) {
        amst_mesh *mesh = NULL;
        heard.warnings = 0;
        must(amst_mesh_create(ctx, 2, points, (around + 1) * (rings + 1), 0, 0, faces, around * rings, 0, 0,
                              4, NULL, &mesh));
        assert_int_equal(heard.warnings, 1);
        assert_non_null(
            strstr(heard.text, "12 edges have no length, the first of them between vertices 0 and"));
        const double before = least_sound(mesh);
        must(k == 0 ? amst_smooth(mesh, NULL, NULL, NULL) : amst_adapt(mesh, NULL, 1, NULL, NULL));
        assert_true(least_sound(mesh) >= before - 1e-12);
        amst_mesh_destroy(mesh);
    }
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faces_are_turned_over_and_counted),
        cmocka_unit_test(files_too),
        cmocka_unit_test(components_of_one_face),
        cmocka_unit_test(one_hanging_vertex_is_a_slit),
        cmocka_unit_test(sound_faces_round_a_pole_stay_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
