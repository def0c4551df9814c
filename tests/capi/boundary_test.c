/* Vertices that come and go on the boundary, on a disk, a square and a channel. */
#include <math.h>

#include "grid.h"

enum { rim = 16, core = 5 };
static const double pi = 3.14159265358979323846;

static amst_context *ctx;
static amst_mesh *disk;
static amst_options *options;

/* A square of 4 x 4 faces amid two rings; its boundary is a polygon of 16 edges. */
static amst_mesh *new_disk(void) {
    double points[2 * (core * core + 2 * rim)];
    int32_t faces[4 * (16 + 2 * rim)], around[rim];
    int32_t n = 0, f = 0;
    for (int j = 0; j < core; ++j)
        for (int i = 0; i < core; ++i, ++n) {
            points[2 * n] = 0.2 * (i - 2);
            points[2 * n + 1] = 0.2 * (j - 2);
        }
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i, ++f) {
            const int32_t a = j * core + i, quad[4] = {a, a + 1, a + core + 1, a + core};
            memcpy(faces + 4 * f, quad, sizeof quad);
        }
    for (int i = 0; i < 4; ++i) {
        around[i] = i;
        around[4 + i] = 4 + core * i;
        around[8 + i] = 24 - i;
        around[12 + i] = 20 - core * i;
    }
    for (int ring = 1; ring <= 2; ++ring) {
        for (int i = 0; i < rim; ++i) {
            const double angle = 2 * pi * i / rim - 0.75 * pi, part = ring == 2 ? 1 : 0.5;
            points[2 * (n + i)] = (1 - part) * points[2 * around[i]] + part * cos(angle);
            points[2 * (n + i) + 1] = (1 - part) * points[2 * around[i] + 1] + part * sin(angle);
        }
        for (int i = 0; i < rim; ++i, ++f) {
            const int32_t quad[4] = {around[(i + 1) % rim], around[i], n + i, n + (i + 1) % rim};
            memcpy(faces + 4 * f, quad, sizeof quad);
        }
        for (int i = 0; i < rim; ++i)
            around[i] = n + i;
        n += rim;
    }
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 2, points, n, 0, 0, faces, f, 0, 0, 4, NULL, &mesh));
    return mesh;
}

static int setup(void **state) {
    (void)state;
    ctx = new_context(0);
    disk = new_disk();
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    return 0;
}

static int teardown(void **state) {
    (void)state;
    amst_options_destroy(options);
    amst_mesh_destroy(disk);
    amst_context_destroy(ctx);
    return 0;
}

/* [count][2] ends of the edges of the boundary. */
static double *boundary_of(const amst_mesh *mesh, int64_t *count) {
    const int64_t n = count_of(mesh, AMST_EDGE);
    int64_t needed;
    amst_id *edges = memory((size_t)n * 2 * sizeof *edges), *sides = memory((size_t)n * 2 * sizeof *sides);
    double *points = points_of(mesh), *ends = memory((size_t)n * 4 * sizeof *ends);
    must(amst_mesh_get_edges(mesh, edges, 2 * n, &needed));
    must(amst_mesh_get_edge_faces(mesh, sides, 2 * n, &needed));
    *count = 0;
    for (int64_t e = 0; e < n; ++e)
        if (sides[2 * e] < 0 || sides[2 * e + 1] < 0) {
            for (int k = 0; k < 2; ++k)
                memcpy(ends + 4 * *count + 2 * k, points + 2 * edges[2 * e + k], 2 * sizeof *ends);
            ++*count;
        }
    free(edges);
    free(sides);
    free(points);
    return ends;
}

static int64_t calls, points_seen;
static int32_t answer;
static double radius, spoiled;

static int32_t to_circle(void *user, int64_t n, const int32_t *marker, const double *points,
                         double *projected) {
    assert_ptr_equal(user, &calls);
    ++calls;
    points_seen += n;
    for (int64_t i = 0; i < n; ++i) {
        assert_int_equal(marker[i], 0);
        const double length = hypot(points[2 * i], points[2 * i + 1]);
        projected[2 * i] = radius * points[2 * i] / length;
        projected[2 * i + 1] = radius * points[2 * i + 1] / length;
    }
    if (spoiled != 0)
        projected[n] = spoiled;
    return answer;
}

static void project(double to) {
    calls = points_seen = 0;
    answer = 0;
    radius = to;
    spoiled = 0;
    must(amst_mesh_set_projection(disk, to_circle, &calls));
}

/* Farthest that edges are from the circle. */
static double missed(const double *ends, int64_t count) {
    double most = 0;
    for (int64_t e = 0; e < count; ++e)
        most = fmax(most, 1 - hypot(ends[4 * e] + ends[4 * e + 2], ends[4 * e + 1] + ends[4 * e + 3]) / 2);
    return most;
}

static void edges_of_a_circle_are_halved(void **state) {
    (void)state;
    int64_t before, after;
    double *ends = boundary_of(disk, &before);
    const double missed_before = missed(ends, before);
    free(ends);
    project(1);
    must(amst_adapt(disk, NULL, 4, options, NULL));
    must(amst_mesh_check(disk));
    assert_int_equal(count_of(disk, AMST_FACE), 4 * 48);
    ends = boundary_of(disk, &after);
    assert_int_equal(before, rim);
    assert_int_equal(after, 2 * rim);
    for (int64_t e = 0; e < 2 * after; ++e)
        assert_true(fabs(hypot(ends[2 * e], ends[2 * e + 1]) - 1) <= 1e-12);
    assert_true(missed(ends, after) <= missed_before / 3.9);
    assert_true(worst_scaled_jacobian(disk) > 0.5);
    assert_int_equal(calls, 2);
    free(ends);
}

static void without_a_projection_the_polygon_stays(void **state) {
    (void)state;
    int64_t count;
    const double alphas[] = {0.5, 4, 0.4};
    for (int k = 0; k < 3; ++k) { /* each on what the one before left: the polygon is still the first one */
        must(amst_adapt(disk, NULL, alphas[k], options, NULL));
        must(amst_mesh_check(disk));
        assert_true(worst_scaled_jacobian(disk) > 0.3);
        double *ends = boundary_of(disk, &count);
        assert_true(k == 1 ? count > rim : count < 24);
        for (int64_t e = 0; e < 2 * count; ++e) {
            const double x = ends[2 * e], y = ends[2 * e + 1];
            const double angle = fmod(atan2(y, x) + 4 * pi, 2 * pi / rim) - pi / rim;
            assert_true(fabs(hypot(x, y) * cos(angle) - cos(pi / rim)) <= 1e-12);
        }
        free(ends);
    }
}

static void without_the_option_the_boundary_stays(void **state) {
    (void)state;
    int64_t count;
    project(1);
    must(amst_adapt(disk, NULL, 4, NULL, NULL));
    free(boundary_of(disk, &count));
    assert_int_equal(count, rim);
    assert_int_equal(calls, 0);
}

static void a_failing_projection_changes_nothing(void **state) {
    (void)state;
    const int64_t before = checksum(disk);
    const struct {
        int32_t answer;
        double radius, spoiled;
    } cases[] = {{1, 1, 0}, {-7, 1, 0}, {0, 3, 0}, {0, 1, NAN}, {0, 1, INFINITY}, {0, 1, 0.3}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        project(cases[i].radius);
        answer = cases[i].answer;
        spoiled = cases[i].spoiled;
        amst_report *report = NULL;
        refused(AMST_ERR_PROJECTION, amst_adapt(disk, NULL, 4, options, &report));
        assert_null(report);
        assert_non_null(strstr(amst_last_error(), "projection"));
        assert_true(checksum(disk) == before);
        assert_int_equal(revision(disk), 0);
    }
    project(1);
    must(amst_adapt(disk, NULL, 4, options, NULL));
}

static int64_t fails_at; /* this call */

static int32_t fail_late(void *user, int64_t n, const int32_t *marker, const double *points,
                         double *projected) {
    to_circle(user, n, marker, points, projected);
    return calls == fails_at;
}

static void so_does_one_that_fails_in_the_end(void **state) {
    (void)state;
    const int64_t before = checksum(disk);
    project(1);
    must(amst_mesh_set_projection(disk, fail_late, &calls));
    fails_at = 2;
    refused(AMST_ERR_PROJECTION, amst_adapt(disk, NULL, 4, options, NULL));
    assert_int_equal(calls, 2);
    assert_true(checksum(disk) == before);
    must(amst_mesh_set_projection(disk, NULL, NULL));
    must(amst_adapt(disk, NULL, 4, options, NULL));
    assert_int_equal(calls, 2);
}

static void call_the_mesh(void *user, const char *stage) {
    (void)stage;
    refused(AMST_ERR_STATE, amst_mesh_set_projection(user, NULL, NULL));
}

static int32_t while_busy(void *user, double fraction, const char *stage) {
    (void)fraction;
    call_the_mesh(user, stage);
    return 0;
}

static void it_stays_while_an_operation_runs(void **state) {
    (void)state;
    must(amst_context_set_progress(ctx, while_busy, disk));
    must(amst_adapt(disk, NULL, 2, options, NULL));
    refused(AMST_ERR_NULL, amst_mesh_set_projection(NULL, NULL, NULL));
}

static double area_of(const amst_mesh *mesh) {
    amst_summary summary;
    must(amst_mesh_get_summary(mesh, AMST_METRIC_AREA, &summary));
    return summary.mean * (double)summary.count;
}

/* Where chords cut off or add something of the disk, the sum of a field goes with its area. */
static void constants_stay_where_the_area_changes(void **state) {
    (void)state;
    const double alphas[] = {0.5, 4};
    for (int k = 0; k < 2; ++k) {
        int64_t n = count_of(disk, AMST_FACE), needed;
        double *values = memory((size_t)n * 2 * sizeof *values);
        for (int64_t f = 0; f < n; ++f) {
            values[2 * f] = 3;
            values[2 * f + 1] = (double)f;
        }
        must(amst_mesh_set_field(disk, AMST_FACE, "mass", 2, AMST_CARRY_CONSERVE, values, n));
        free(values);
        const double before = area_of(disk);
        amst_report *report = NULL;
        if (k == 1)
            project(1);
        must(amst_adapt(disk, NULL, alphas[k], options, &report));
        const double gained = real_result(report, AMST_ALL, AMST_RESULT_AREA_GAINED);
        assert_true(fabs(area_of(disk) - before - gained) < 1e-12);
        assert_true(k == 0 ? gained < -0.01 : gained > 0.01);
        n = count_of(disk, AMST_FACE);
        values = memory((size_t)n * 2 * sizeof *values);
        must(amst_mesh_get_field(disk, AMST_FACE, "mass", values, 2 * n, &needed));
        for (int64_t f = 0; f < n; ++f)
            assert_true(fabs(values[2 * f] - 3) < 1e-12);
        free(values);
        amst_report_destroy(report);
    }
}

static int has_vertex(const double *ends, int64_t count, double x, double y) {
    for (int64_t e = 0; e < 2 * count; ++e)
        if (ends[2 * e] == x && ends[2 * e + 1] == y)
            return 1;
    return 0;
}

/* Its corners have no flag. */
static void corners_of_a_square_stay(void **state) {
    (void)state;
    const double alphas[] = {0.25, 0.5, 2, 4};
    const int64_t least[] = {20, 28, 52, 76}, most[] = {28, 40, 62, 84};
    for (int k = 0; k < 4; ++k) {
        amst_mesh *square = new_grid(ctx, 0, 10, 10);
        int64_t count;
        must(amst_adapt(square, NULL, alphas[k], options, NULL));
        must(amst_mesh_check(square));
        assert_int_equal(count_of(square, AMST_FACE), (int64_t)(100 * alphas[k]));
        assert_true(worst_scaled_jacobian(square) > 0.4);
        double *ends = boundary_of(square, &count);
        for (int i = 0; i < 4; ++i)
            assert_true(has_vertex(ends, count, i % 2 * 10, i / 2 * 10));
        assert_true(count >= least[k] && count <= most[k]);
        free(ends);
        amst_mesh_destroy(square);
    }
}

/* Half of it is refined: vertices come on its part of the boundary alone. */
static void a_patch_at_the_boundary_gets_vertices_there(void **state) {
    (void)state;
    amst_mesh *square = new_grid(ctx, 0, 12, 12);
    amst_patches *set = NULL;
    amst_id faces[36], id;
    int64_t count;
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 6; ++i)
            faces[6 * j + i] = 12 * j + i + 3;
    must(amst_patches_create(square, NULL, &set));
    must(amst_patches_add_faces(set, faces, 36, &id));
    must(amst_adapt(square, set, 4, options, NULL));
    must(amst_mesh_check(square));
    assert_int_equal(count_of(square, AMST_FACE), 144 - 36 + 144);
    double *ends = boundary_of(square, &count);
    assert_true(count > 48 && count <= 54);
    for (int64_t e = 0; e < 2 * count; ++e) {
        const double x = ends[2 * e], y = ends[2 * e + 1];
        if (x != floor(x) || y != floor(y))
            assert_true(y == 0 && x > 3 && x < 9);
    }
    free(ends);
    amst_patches_destroy(set);
    amst_mesh_destroy(square);
}

/* Flagged vertices of the boundary stay where they are, and so do FIXED edges. */
static void what_is_flagged_stays(void **state) {
    (void)state;
    const double alphas[] = {0.25, 4};
    for (int k = 0; k < 2; ++k) {
        amst_mesh *square = new_grid(ctx, 0, 10, 10);
        int64_t count;
        amst_id corner = 3, edge = -1;
        int64_t needed;
        must(amst_mesh_set_flags(square, AMST_VERTEX, &corner, 1, AMST_FLAG_CORNER, AMST_FLAG_CORNER));
        const int64_t n = count_of(square, AMST_EDGE);
        amst_id *edges = memory((size_t)n * 2 * sizeof *edges);
        must(amst_mesh_get_edges(square, edges, 2 * n, &needed));
        for (int64_t e = 0; e < n; ++e)
            if (edges[2 * e] == 7 && edges[2 * e + 1] == 8)
                edge = (amst_id)e;
        must(amst_mesh_set_flags(square, AMST_EDGE, &edge, 1, AMST_FLAG_FIXED, AMST_FLAG_FIXED));
        assert_true(amst_adapt(square, NULL, alphas[k], options, NULL) >= AMST_OK);
        must(amst_mesh_check(square));
        double *ends = boundary_of(square, &count);
        assert_true(has_vertex(ends, count, 3, 0));
        int found = 0;
        for (int64_t e = 0; e < count; ++e)
            found += ends[4 * e + 1] == 0 && ends[4 * e + 3] == 0 && ends[4 * e] + ends[4 * e + 2] == 15 &&
                     fabs(ends[4 * e] - ends[4 * e + 2]) == 1;
        assert_int_equal(found, 1);
        free(ends);
        free(edges);
        amst_mesh_destroy(square);
    }
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, setup, teardown)
    const struct CMUnitTest tests[] = {
        TEST(edges_of_a_circle_are_halved),
        TEST(without_a_projection_the_polygon_stays),
        TEST(without_the_option_the_boundary_stays),
        TEST(a_failing_projection_changes_nothing),
        TEST(so_does_one_that_fails_in_the_end),
        TEST(it_stays_while_an_operation_runs),
        TEST(constants_stay_where_the_area_changes),
        TEST(corners_of_a_square_stay),
        TEST(a_patch_at_the_boundary_gets_vertices_there),
        TEST(what_is_flagged_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
