/* AMST_OPT_CHART: how windows of a curved mesh are laid in the plane. */
#include <math.h>

#include "grid.h"

/* The disturbed grid as the shape of a bell, so steep that no plane holds much of it. */
static amst_mesh *new_bell(amst_context *ctx, int32_t n) {
    amst_mesh *flat = new_disturbed(ctx, n), *bell = NULL;
    const int64_t n_points = count_of(flat, AMST_VERTEX);
    double *places = points_of(flat), *points = memory((size_t)n_points * 3 * sizeof *points);
    amst_id *faces = faces_of(flat);
    for (int64_t v = 0; v < n_points; ++v) {
        const double x = places[2 * v] - 0.5 * n, y = places[2 * v + 1] - 0.5 * n;
        points[3 * v] = x;
        points[3 * v + 1] = y;
        points[3 * v + 2] = 0.8 * n * exp(-18 * (x * x + y * y) / (n * n));
    }
    must(amst_mesh_create(ctx, 3, points, n_points, 0, 0, faces, count_of(flat, AMST_FACE), 0, 0, 4, NULL,
                          &bell));
    free(places);
    free(points);
    free(faces);
    amst_mesh_destroy(flat);
    return bell;
}

/* Corners that do not turn left seen along the normal of the bell: from above, where it is steep, a slightly
 * tilted one would seem to turn over. */
static int64_t n_turned_over(const amst_mesh *mesh, int32_t n) {
    double *points = points_of(mesh);
    amst_id *faces = faces_of(mesh);
    int64_t wrong = 0;
    for (int64_t f = 0; f < count_of(mesh, AMST_FACE); ++f)
        for (int k = 0; k < 4; ++k) {
            const double *p = points + 3 * faces[4 * f + k], *q = points + 3 * faces[4 * f + (k + 1) % 4],
                         *r = points + 3 * faces[4 * f + (k + 3) % 4];
            const double a[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]},
                         b[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
            const double slope = 36.0 / (n * n) * p[2]; /* z falls by that times x and y */
            wrong += !((a[1] * b[2] - a[2] * b[1]) * slope * p[0] +
                           (a[2] * b[0] - a[0] * b[2]) * slope * p[1] + (a[0] * b[1] - a[1] * b[0]) >
                       0);
        }
    free(points);
    free(faces);
    return wrong;
}

static void every_chart_gives_the_count_and_no_inverted_face(void **state) {
    (void)state;
    int64_t digests[4];
    for (int32_t kind = 0; kind < 4; ++kind) {
        amst_context *ctx = new_context(0);
        amst_mesh *mesh = new_bell(ctx, 16);
        amst_options *options = NULL;
        const int64_t faces = count_of(mesh, AMST_FACE), singular = n_singular(mesh);
        assert_int_equal(n_turned_over(mesh, 16), 0);
        must(amst_options_create(&options));
        must(amst_options_set_int(options, AMST_OPT_CHART, kind));
        must(amst_adapt(mesh, NULL, 1, options, NULL));
        must(amst_mesh_check(mesh));
        assert_int_equal(count_of(mesh, AMST_FACE), faces);
        assert_true(n_singular(mesh) < singular);
        assert_int_equal(n_turned_over(mesh, 16), 0);
        digests[kind] = checksum(mesh);
        for (int32_t other = 0; other < kind; ++other)
            assert_true(digests[other] != digests[kind]);
        amst_options_destroy(options);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_chart_gives_the_count_and_no_inverted_face),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
