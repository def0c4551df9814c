/* Wall: a shock runs around a bend between two circles. Under its foot on the outer wall the mesh is
 * refined, wall and all, and behind it made coarser again; all vertices of the wall stay on the circle.
 *
 *   build/release/examples/c/wall 4 [wall_] */
#include "check.h"

#include <math.h>

enum { ALONG = 64, ACROSS = 16, N_POINTS = (ALONG + 1) * (ACROSS + 1), N_FACES = ALONG * ACROSS };

static const double inner = 1, outer = 2;

/* Of the bend in ALONG parts, by turning from each to the next: sine and cosine are not the same to the last
 * digit in every language. */
static void divide(double (*circle)[2]) {
    circle[0][0] = 1;
    circle[0][1] = 0;
    for (int i = 1; i <= ALONG; ++i) {
        circle[i][0] = 0.9987954562051724 * circle[i - 1][0] - 0.04906767432741801 * circle[i - 1][1];
        circle[i][1] = 0.04906767432741801 * circle[i - 1][0] + 0.9987954562051724 * circle[i - 1][1];
    }
    circle[ALONG][1] = 0;
}

static amst_mesh *make_bend(amst_context *context, double (*circle)[2]) {
    static double points[N_POINTS][2];
    static int32_t faces[N_FACES][4];
    amst_mesh *mesh = NULL;
    for (int i = 0; i <= ALONG; ++i)
        for (int j = 0; j <= ACROSS; ++j)
            for (int k = 0; k < 2; ++k)
                points[i * (ACROSS + 1) + j][k] = (inner + (outer - inner) * j / ACROSS) * circle[i][k];
    for (int32_t f = 0; f < N_FACES; ++f) {
        const int32_t v = f + f / ACROSS, quad[4] = {v, v + 1, v + ACROSS + 2, v + ACROSS + 1};
        for (int k = 0; k < 4; ++k)
            faces[f][k] = quad[k];
    }
    check(amst_mesh_create(context, 2, *points, N_POINTS, 0, 0, *faces, N_FACES, 0, 0, 4, NULL, &mesh));
    return mesh;
}

/* The two ends of the bend are on y = 0, the rest of its boundary on the two circles. */
static int32_t project(void *user, int64_t n, const int32_t *marker, const double *points,
                       double *projected) {
    (void)user;
    (void)marker;
    for (int64_t i = 0; i < n; ++i) {
        const double x = points[2 * i], y = points[2 * i + 1], radius = sqrt(x * x + y * y);
        const double scale = y <= 0 ? 1 : (radius < (inner + outer) / 2 ? inner : outer) / radius;
        projected[2 * i] = scale * x;
        projected[2 * i + 1] = scale * y;
    }
    return 0;
}

static void *memory(int64_t n, size_t size) {
    void *made = malloc((size_t)n * size);
    if (made == NULL)
        exit(1);
    return made;
}

/* The field "size" around the foot of the shock; how many faces that asks for. */
static double want_sizes(amst_mesh *mesh, const double foot[2]) {
    int64_t n = 0, n_faces = 0, needed = 0;
    double wanted = 0;
    check(amst_mesh_get_count(mesh, AMST_VERTEX, &n));
    check(amst_mesh_get_count(mesh, AMST_FACE, &n_faces));
    double *points = memory(2 * n, sizeof *points), *size = memory(n, sizeof *size);
    double *area = memory(n_faces, sizeof *area);
    amst_id *faces = memory(4 * n_faces, sizeof *faces);
    check(amst_mesh_get_points(mesh, points, 2 * n, &needed));
    check(amst_mesh_get_faces(mesh, faces, 4 * n_faces, &needed));
    check(amst_mesh_get_quality(mesh, AMST_METRIC_AREA, area, n_faces, &needed));
    for (int64_t v = 0; v < n; ++v) {
        const double x = points[2 * v] - foot[0], y = points[2 * v + 1] - foot[1];
        size[v] = fmin(0.02 + 0.2 * sqrt(x * x + y * y), 0.08);
    }
    for (int64_t f = 0; f < n_faces; ++f) {
        const amst_id *v = faces + 4 * f;
        const double length = (size[v[0]] + size[v[1]] + size[v[2]] + size[v[3]]) / 4;
        wanted += area[f] / (length * length);
    }
    check(amst_mesh_set_field(mesh, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, size, n));
    free(points);
    free(size);
    free(area);
    free(faces);
    return wanted;
}

static void print_row(const amst_mesh *mesh, int step) {
    int64_t n = 0, n_points = 0, n_faces = 0, needed = 0, on_wall = 0;
    amst_summary quality;
    double farthest = 0;
    check(amst_mesh_get_count(mesh, AMST_EDGE, &n));
    check(amst_mesh_get_count(mesh, AMST_FACE, &n_faces));
    check(amst_mesh_get_points(mesh, NULL, 0, &n_points)); /* the number of coordinates */
    double *points = memory(n_points, sizeof *points);
    amst_id *edges = memory(2 * n, sizeof *edges), *sides = memory(2 * n, sizeof *sides);
    check(amst_mesh_get_points(mesh, points, n_points, &needed));
    check(amst_mesh_get_edges(mesh, edges, 2 * n, &needed));
    check(amst_mesh_get_edge_faces(mesh, sides, 2 * n, &needed));
    for (int64_t e = 0; e < 2 * n; e += 2) {
        const double *v = points + 2 * edges[e], *w = points + 2 * edges[e + 1];
        const double radius = sqrt(v[0] * v[0] + v[1] * v[1]);
        if ((sides[e] >= 0 && sides[e + 1] >= 0) || v[1] + w[1] <= 0 || radius < (inner + outer) / 2)
            continue;
        ++on_wall;
        farthest = fmax(farthest, fabs(radius - outer));
        farthest = fmax(farthest, fabs(sqrt(w[0] * w[0] + w[1] * w[1]) - outer));
    }
    check(amst_mesh_get_summary(mesh, AMST_METRIC_SCALED_JACOBIAN, &quality));
    printf("%4d %6lld %6lld %15.12f %12.4f\n", step, (long long)n_faces, (long long)on_wall, farthest,
           quality.min);
    free(points);
    free(edges);
    free(sides);
}

static void draw(const amst_mesh *mesh, const char *prefix, int step) {
    char path[1024];
    snprintf(path, sizeof path, "%s%d.svg", prefix, step);
    check(amst_mesh_write(mesh, path));
}

int main(int argc, char **argv) {
    double circle[ALONG + 1][2];
    amst_context *context = NULL;
    amst_options *options = NULL;
    if (argc < 2) {
        fprintf(stderr, "usage: wall STEPS [PICTURE_PREFIX]\n");
        return 2;
    }
    const int steps = atoi(argv[1]);
    divide(circle);
    check(amst_context_create(0, &context));
    amst_mesh *mesh = make_bend(context, circle);
    check(amst_options_create(&options));
    check(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    check(amst_mesh_set_projection(mesh, project, NULL));

    printf("%4s %6s %6s %15s %12s\n", "step", "faces", "edges", "from the wall", "smallest SJ");
    for (int step = 0; step <= steps; ++step) {
        if (step > 0) { /* 0: as it was made */
            const double *at = circle[step * ALONG / (steps + 1)], foot[2] = {outer * at[0], outer * at[1]};
            int64_t n_faces = 0;
            check(amst_mesh_get_count(mesh, AMST_FACE, &n_faces));
            check(amst_adapt(mesh, NULL, want_sizes(mesh, foot) / (double)n_faces, options, NULL));
        }
        print_row(mesh, step);
        if (argc > 2)
            draw(mesh, argv[2], step);
    }
    amst_options_destroy(options);
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    return 0;
}
