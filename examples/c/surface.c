/* Surface: a torus of triangles that lie at random becomes quads, and a fraction alpha of these, with few
 * singular vertices; all vertices stay on the surface.
 *
 *   build/release/examples/c/surface 0.5 [after.svg] */
#include "check.h"

#include <math.h>

enum { AROUND = 64, ACROSS = 24, N_POINTS = AROUND * ACROSS, N_TRIANGLES = 2 * N_POINTS };

static const double radius = 1.0, tube = 0.4; /* from the axis to the middle of the tube; its radius */

/* A number of -0.5 to 0.5 at random, the same in every language. */
static double noise(int64_t *state) {
    *state = (1103515245 * *state + 12345) % 2147483648;
    return (double)*state / 2147483648.0 - 0.5;
}

static double distance(const double p[3]) {
    const double off = sqrt(p[0] * p[0] + p[1] * p[1]) - radius;
    return fabs(sqrt(off * off + p[2] * p[2]) - tube);
}

/* The point of the torus that is nearest to p. */
static void project(double p[3]) {
    const double around = sqrt(p[0] * p[0] + p[1] * p[1]);
    const double off = around - radius, across = sqrt(off * off + p[2] * p[2]);
    const double wide = (radius + off / across * tube) / around;
    p[0] = p[0] * wide;
    p[1] = p[1] * wide;
    p[2] = p[2] / across * tube;
}

/* Of a circle in n parts, by turning from each to the next: sine and cosine are not the same to the last
 * digit in every language. */
static void divide(int n, double cosine, double sine, double (*circle)[2]) {
    circle[0][0] = 1;
    circle[0][1] = 0;
    for (int i = 1; i < n; ++i) {
        circle[i][0] = cosine * circle[i - 1][0] - sine * circle[i - 1][1];
        circle[i][1] = sine * circle[i - 1][0] + cosine * circle[i - 1][1];
    }
}

static void make_torus(double (*points)[3], int32_t (*triangles)[3]) {
    double long_way[AROUND][2], short_way[2 * ACROSS][2];
    int64_t state = 1;
    divide(AROUND, 0.9951847266721969, 0.0980171403295606, long_way);
    divide(2 * ACROSS, 0.9914448613738104, 0.13052619222005157, short_way);
    for (int i = 0; i < AROUND; ++i)
        for (int j = 0; j < ACROSS; ++j) {
            double *p = points[i * ACROSS + j];
            const double *at = short_way[2 * j + i % 2]; /* every other row by half a cell */
            const double wide = radius + tube * at[0];
            p[0] = wide * long_way[i][0] + 0.04 * noise(&state);
            p[1] = wide * long_way[i][1] + 0.04 * noise(&state);
            p[2] = tube * at[1] + 0.04 * noise(&state);
            project(p);
            const int32_t a = i * ACROSS + j, b = (i + 1) % AROUND * ACROSS + j;
            const int32_t c = (i + 1) % AROUND * ACROSS + (j + 1) % ACROSS, d = i * ACROSS + (j + 1) % ACROSS;
            const int is_even = i % 2 == 0; /* its short diagonals are those from b to d */
            const int32_t two[2][3] = {{a, b, is_even ? d : c}, {is_even ? b : a, c, d}};
            for (int k = 0; k < 6; ++k)
                triangles[2 * a + k / 3][k % 3] = two[k / 3][k % 3];
        }
}

int main(int argc, char **argv) {
    static double points[N_POINTS][3];
    static int32_t triangles[N_TRIANGLES][3];
    amst_context *context = NULL;
    amst_mesh *mesh = NULL;
    amst_report *report = NULL;
    int64_t n_sharp = 0, n_points = 0, before = 0, after = 0, singular_before = 0, singular_after = 0;
    double quality_before = 0, quality_after = 0, farthest = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: surface ALPHA [PICTURE]\n");
        return 2;
    }
    make_torus(points, triangles);
    check(amst_context_create(0, &context));
    check(
        amst_mesh_create(context, 3, *points, N_POINTS, 0, 0, *triangles, N_TRIANGLES, 0, 0, 3, NULL, &mesh));
    check(amst_mesh_detect_features(mesh, 60, &n_sharp));
    check(amst_mesh_set_surface(mesh, *points, N_POINTS, *triangles, N_TRIANGLES));
    check(amst_adapt(mesh, NULL, strtod(argv[1], NULL), NULL, &report));

    check(amst_report_get_int(report, AMST_ALL, AMST_RESULT_FACES_BEFORE, &before));
    check(amst_report_get_int(report, AMST_ALL, AMST_RESULT_FACES_AFTER, &after));
    check(amst_report_get_int(report, AMST_ALL, AMST_RESULT_SINGULAR_BEFORE, &singular_before));
    check(amst_report_get_int(report, AMST_ALL, AMST_RESULT_SINGULAR_AFTER, &singular_after));
    check(amst_report_get_real(report, AMST_ALL, AMST_RESULT_QUALITY_BEFORE, &quality_before));
    check(amst_report_get_real(report, AMST_ALL, AMST_RESULT_QUALITY_AFTER, &quality_after));
    check(amst_mesh_get_points(mesh, NULL, 0, &n_points)); /* the number of coordinates */
    double *now = malloc((size_t)n_points * sizeof *now);
    if (now == NULL)
        return 1;
    check(amst_mesh_get_points(mesh, now, n_points, &n_points));
    for (int64_t i = 0; i < n_points; i += 3)
        farthest = fmax(farthest, distance(now + i));
    free(now);

    printf("%d triangles, %lld sharp edges\n", N_TRIANGLES, (long long)n_sharp);
    printf("%-24s %6s %6s\n", "", "before", "after");
    printf("%-24s %6lld %6lld\n", "faces", (long long)before, (long long)after);
    printf("%-24s %6lld %6lld\n", "singular vertices", (long long)singular_before, (long long)singular_after);
    printf("%-24s %6.3f %6.3f\n", "smallest scaled Jacobian", quality_before, quality_after);
    printf("%.4f from the torus at most\n", farthest);
    if (argc > 2)
        check(amst_mesh_write(mesh, argv[2]));

    amst_report_destroy(report);
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    return 0;
}
