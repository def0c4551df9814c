/* adapt MESH OUTPUT_DIRECTORY: patches of a quad mesh adapted with several alphas, through
 * the C interface alone.
 *
 *   scripts/demo                                     from a fresh clone, all steps
 *   build/demo/examples/c/adapt out/coast.msh out      this program again
 *
 * Two choices of patches are made, each adapted with every alpha on a clone of the mesh:
 * six round ones far from the boundary and from each other, one row of the table each; then
 * a partition of the whole mesh, one row for all. Written are, for every alpha A,
 *
 *   NAME_alpha_A.msh .vtk .svg    the mesh with the six patches adapted
 *   NAME_partition_A.svg          the mesh with every patch of the partition adapted
 *   detail_alpha_A.svg            one of the six patches from near by
 *
 * and before.svg, partition_before.svg and detail_before.svg. In the pictures patches have a
 * green outline, vertices of valence 3 are blue and those of valence 5 red. */
#include <alphamst/alphamst.h>

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { n_balls = 6, faces_per_ball = 220, faces_per_part = 120 };
enum { detailed = 3 }; /* the ball with pictures of its own */

static const double alphas[] = {0.5, 0.8, 1, 1.5, 2, 4};
static const size_t n_alphas = sizeof alphas / sizeof alphas[0];

typedef struct {
    double centre[3];
    double radius;
} ball;

/* A mesh as plain arrays, with three coordinates whatever its dimension. */
typedef struct {
    int64_t n_points, n_faces;
    double *points; /* [n_points][3] */
    amst_id *faces; /* [n_faces][4] */
} arrays;

/* What is summed up over the rows of a table. */
typedef struct {
    int64_t patches, delivered, left; /* delivered: with exactly the wanted faces */
    int64_t faces_before, faces_wanted, faces_after, singular_before, singular_after;
    double worst_before, worst_after, seconds;
    /* Of a row, after: rms of log2(area / wanted area), least area / wanted area, shortest edge / root of the
     * wanted area, largest aspect ratio, and time step over that before. */
    double size, area, edge, aspect, step;
} totals;

/* ------------------------------------------------------------------ errors */

#define CHECK(call) check((call), #call)

static void check(amst_status status, const char *call) {
    if (status < 0) {
        fprintf(stderr, "adapt: %s\n  %s in %s\n", amst_last_error(), amst_status_name(status), call);
        exit(1);
    }
}

static void *allocate(int64_t count, size_t size) {
    void *memory = calloc(count > 0 ? (size_t)count : 1, size);
    if (memory == NULL) {
        fprintf(stderr, "adapt: out of memory\n");
        exit(1);
    }
    return memory;
}

static void make_path(char path[1024], const char *directory, const char *name, const char *tail) {
    const int length = snprintf(path, 1024, "%s/%s%s", directory, name, tail);
    if (length < 0 || length >= 1024) {
        fprintf(stderr, "adapt: the path of the output directory is too long\n");
        exit(1);
    }
}

/* ---------------------------------------------------------------- progress */

/* A step that is done within a second says nothing. */
static int32_t show_progress(void *user, double fraction, const char *stage) {
    const time_t *start = (const time_t *)user;
    if (difftime(time(NULL), *start) > 1)
        fprintf(stderr, "\r%s %3.0f %%%s", stage, 100 * fraction, fraction < 1 ? "" : "\n");
    return 0; /* go on */
}

/* ------------------------------------------------------------- choosing patches */

static int64_t count_of(const amst_mesh *mesh, int32_t entity) {
    int64_t count;
    CHECK(amst_mesh_get_count(mesh, entity, &count));
    return count;
}

static arrays get_arrays(const amst_mesh *mesh) {
    arrays a;
    int32_t dim;
    int64_t needed;
    CHECK(amst_mesh_get_dim(mesh, &dim));
    a.n_points = count_of(mesh, AMST_VERTEX);
    a.n_faces = count_of(mesh, AMST_FACE);
    a.points = allocate(a.n_points, 3 * sizeof *a.points);
    a.faces = allocate(a.n_faces, 4 * sizeof *a.faces);
    CHECK(amst_mesh_get_points(mesh, a.points, dim * a.n_points, &needed));
    CHECK(amst_mesh_get_faces(mesh, a.faces, 4 * a.n_faces, &needed));
    for (int64_t v = dim == 2 ? a.n_points - 1 : -1; v >= 0; --v) { /* spread from the end */
        const double x = a.points[2 * v], y = a.points[2 * v + 1];
        a.points[3 * v] = x;
        a.points[3 * v + 1] = y;
        a.points[3 * v + 2] = 0;
    }
    return a;
}

static void free_arrays(arrays *a) {
    free(a->points);
    free(a->faces);
}

static double distance(const double *a, const double *b) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

static double distance_of_face(const arrays *a, int64_t face, const double *from) {
    double centroid[3] = {0, 0, 0};
    for (int64_t k = 0; k < 12; ++k)
        centroid[k % 3] += a->points[3 * a->faces[4 * face + k / 3] + k % 3] / 4;
    return distance(centroid, from);
}

/* is_boundary[v] of each vertex */
static char *find_boundary(const amst_mesh *mesh, int64_t n_points) {
    const int64_t n_edges = count_of(mesh, AMST_EDGE);
    amst_id *edges = allocate(n_edges, 2 * sizeof *edges);
    amst_id *sides = allocate(n_edges, 2 * sizeof *sides);
    char *is_boundary = allocate(n_points, 1);
    int64_t needed;
    CHECK(amst_mesh_get_edges(mesh, edges, 2 * n_edges, &needed));
    CHECK(amst_mesh_get_edge_faces(mesh, sides, 2 * n_edges, &needed));
    for (int64_t i = 0; i < 2 * n_edges; ++i)
        if (sides[i] < 0) /* "none" for the index base 0 */
            is_boundary[edges[i - i % 2]] = is_boundary[edges[i - i % 2 + 1]] = 1;
    free(edges);
    free(sides);
    return is_boundary;
}

static int compare(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Distance from the centre within which that many faces are. */
static double radius_for(const arrays *a, const double *centre, int64_t faces) {
    double *distances = allocate(a->n_faces, sizeof *distances);
    for (int64_t f = 0; f < a->n_faces; ++f)
        distances[f] = distance_of_face(a, f, centre);
    qsort(distances, (size_t)a->n_faces, sizeof *distances, compare);
    const double radius = distances[faces < a->n_faces ? faces : a->n_faces - 1];
    free(distances);
    return radius;
}

/* Each centre is the vertex with the most room left, up to the boundary and half way to the
 * centres before; of a large mesh only every so many vertices are looked at. */
static void choose_balls(const amst_mesh *mesh, ball balls[n_balls]) {
    arrays a = get_arrays(mesh);
    char *is_boundary = find_boundary(mesh, a.n_points);
    const int64_t step = 1 + a.n_points / 10000;
    double *room = allocate(a.n_points, sizeof *room);
    for (int64_t v = 0; v < a.n_points; v += step) {
        room[v] = HUGE_VAL;
        for (int64_t w = 0; w < a.n_points; ++w)
            if (is_boundary[w])
                room[v] = fmin(room[v], distance(a.points + 3 * v, a.points + 3 * w));
    }
    for (int i = 0; i < n_balls; ++i) {
        int64_t best = 0;
        for (int64_t v = 0; v < a.n_points; v += step)
            best = room[v] > room[best] ? v : best;
        memcpy(balls[i].centre, a.points + 3 * best, sizeof balls[i].centre);
        balls[i].radius = fmin(room[best], radius_for(&a, balls[i].centre, faces_per_ball));
        for (int64_t v = 0; v < a.n_points; v += step)
            room[v] = fmin(room[v], distance(a.points + 3 * v, balls[i].centre) / 2);
    }
    free(room);
    free(is_boundary);
    free_arrays(&a);
}

static amst_patches *make_balls(const amst_mesh *mesh, const ball balls[n_balls]) {
    amst_patches *patches;
    CHECK(amst_patches_create(mesh, NULL, &patches));
    for (int i = 0; i < n_balls; ++i)
        CHECK(amst_patches_add_ball(patches, balls[i].centre, balls[i].radius, NULL));
    return patches;
}

static amst_patches *make_partition(const amst_mesh *mesh) {
    amst_options *options;
    amst_patches *patches;
    CHECK(amst_options_create(&options));
    CHECK(amst_options_set_real(options, AMST_OPT_PATCH_FACES, faces_per_part));
    CHECK(amst_patches_create(mesh, options, &patches));
    CHECK(amst_patches_decompose(patches, AMST_DECOMPOSE_PARTITION, NULL));
    amst_options_destroy(options);
    return patches;
}

/* ------------------------------------------------------------------- table */

static int64_t get_int(const amst_report *report, amst_id patch, int32_t key) {
    int64_t value;
    CHECK(amst_report_get_int(report, patch, key, &value));
    return value;
}

static double get_real(const amst_report *report, amst_id patch, int32_t key) {
    double value;
    CHECK(amst_report_get_real(report, patch, key, &value));
    return value;
}

static void add_patch(totals *sum, const amst_report *report, amst_id patch) {
    const int64_t wanted = get_int(report, patch, AMST_RESULT_FACES_WANTED);
    const int64_t after = get_int(report, patch, AMST_RESULT_FACES_AFTER);
    const int left = get_int(report, patch, AMST_RESULT_STATUS) < 0;
    ++sum->patches;
    sum->left += left;
    sum->delivered += !left && after == wanted;
    sum->faces_before += get_int(report, patch, AMST_RESULT_FACES_BEFORE);
    sum->faces_wanted += wanted;
    sum->faces_after += after;
    sum->singular_before += get_int(report, patch, AMST_RESULT_SINGULAR_BEFORE);
    sum->singular_after += get_int(report, patch, AMST_RESULT_SINGULAR_AFTER);
    sum->worst_before = fmin(sum->worst_before, get_real(report, patch, AMST_RESULT_QUALITY_BEFORE));
    sum->worst_after = fmin(sum->worst_after, get_real(report, patch, AMST_RESULT_QUALITY_AFTER));
    sum->seconds += get_real(report, patch, AMST_RESULT_SECONDS);
}

static void print_title(const char *title, const char *second) {
    printf("\n%s\n\n", title);
    printf("                      faces           singularities  scaled Jacobian\n");
    printf(
        "alpha  %-7s  before wanted delivered  before  after   before   after   size   area   edge aspect  "
        " step       ms  status\n",
        second);
}

static void print_row(double alpha, const char *second, const totals *row, const char *status) {
    printf("%5.1f  %-7s  %6" PRId64 " %6" PRId64 " %9" PRId64 "  %6" PRId64 " %6" PRId64
           "   %6.3f  %6.3f  %5.2f  %5.2f  %5.2f  %5.2f  %5.2f  %7.1f  %s\n",
           alpha, second, row->faces_before, row->faces_wanted, row->faces_after, row->singular_before,
           row->singular_after, row->worst_before, row->worst_after, row->size, row->area, row->edge,
           row->aspect, row->step, 1e3 * row->seconds, status);
}

static void print_totals(const totals *sum) {
    printf("\n%" PRId64 " patches: %" PRId64 " have exactly the faces wanted, %" PRId64
           " missed the number, %" PRId64 " were left as they were.\n",
           sum->patches, sum->delivered, sum->patches - sum->delivered - sum->left, sum->left);
    printf(
        "Singularities %" PRId64 " -> %" PRId64 ", smallest scaled Jacobian %.3f -> %.3f, %.1f ms in all.\n",
        sum->singular_before, sum->singular_after, sum->worst_before, sum->worst_after, 1e3 * sum->seconds);
}

static void add_totals(totals *sum, const totals *row) {
    sum->patches += row->patches;
    sum->left += row->left;
    sum->delivered += row->delivered;
    sum->singular_before += row->singular_before;
    sum->singular_after += row->singular_after;
    sum->worst_before = fmin(sum->worst_before, row->worst_before);
    sum->worst_after = fmin(sum->worst_after, row->worst_after);
    sum->seconds += row->seconds;
}

static totals no_rows(void) {
    totals none = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 1};
    return none;
}

static void get_sizes(totals *row, const amst_report *report, amst_id patch) {
    row->size = get_real(report, patch, AMST_RESULT_SIZE_ERROR_AFTER);
    row->area = get_real(report, patch, AMST_RESULT_LEAST_AREA_AFTER);
    row->edge = get_real(report, patch, AMST_RESULT_SHORTEST_EDGE_AFTER);
    row->aspect = get_real(report, patch, AMST_RESULT_ASPECT_RATIO_AFTER);
    row->step = get_real(report, patch, AMST_RESULT_TIME_STEP);
}

static void print_patches(double alpha, const amst_report *report, int64_t n_patches, totals *sum) {
    for (amst_id p = 0; p < n_patches; ++p) {
        char name[16];
        totals row = no_rows();
        snprintf(name, sizeof name, "%" PRId32, p);
        add_patch(&row, report, p);
        get_sizes(&row, report, p);
        print_row(alpha, name, &row, amst_status_name((amst_status)get_int(report, p, AMST_RESULT_STATUS)));
        add_totals(sum, &row);
    }
}

static void print_all(double alpha, const amst_report *report, int64_t n_patches, totals *sum) {
    char name[48];
    totals row = no_rows();
    for (amst_id p = 0; p < n_patches; ++p)
        add_patch(&row, report, p);
    get_sizes(&row, report, AMST_ALL);
    /* Neighbours share singular vertices, so those of the patches do not add up. */
    row.singular_before = get_int(report, AMST_ALL, AMST_RESULT_SINGULAR_BEFORE);
    row.singular_after = get_int(report, AMST_ALL, AMST_RESULT_SINGULAR_AFTER);
    snprintf(name, sizeof name, "%" PRId64 "/%" PRId64, row.patches - row.left, row.patches);
    print_row(alpha, name, &row,
              amst_status_name((amst_status)get_int(report, AMST_ALL, AMST_RESULT_STATUS)));
    add_totals(sum, &row);
}

/* ---------------------------------------------------------------- pictures */

/* The faces around a ball become a mesh of their own, with new numbers. */
static void write_detail(amst_context *ctx, const amst_mesh *mesh, const amst_patches *patches,
                         const ball *around, const char *path) {
    arrays a = get_arrays(mesh);
    amst_id *vertex = allocate(a.n_points, sizeof *vertex), *face = allocate(a.n_faces, sizeof *face);
    amst_mesh *detail;
    amst_patches *outline;
    int64_t n_points = 0, n_faces = 0, n_patch;
    memset(vertex, -1, (size_t)a.n_points * sizeof *vertex);
    for (int64_t f = 0; f < a.n_faces; ++f) {
        face[f] = -1;
        if (distance_of_face(&a, f, around->centre) > 1.35 * around->radius)
            continue;
        face[f] = (amst_id)n_faces;
        for (int k = 0; k < 4; ++k) {
            const amst_id v = a.faces[4 * f + k];
            if (vertex[v] < 0)
                vertex[v] = (amst_id)n_points++;
            a.faces[4 * n_faces + k] = vertex[v];
        }
        ++n_faces;
    }
    double *points = allocate(n_points, 3 * sizeof *points);
    for (int64_t v = 0; v < a.n_points; ++v)
        if (vertex[v] >= 0)
            memcpy(points + 3 * vertex[v], a.points + 3 * v, 3 * sizeof *points);
    CHECK(amst_mesh_create(ctx, 3, points, n_points, 0, 0, a.faces, n_faces, 0, 0, 4, NULL, &detail));

    amst_id *inside = allocate(a.n_faces, sizeof *inside);
    CHECK(amst_patches_get_faces(patches, detailed, inside, a.n_faces, &n_patch));
    for (int64_t i = 0; i < n_patch; ++i)
        inside[i] = face[inside[i]];
    CHECK(amst_patches_create(detail, NULL, &outline));
    CHECK(amst_patches_add_faces(outline, inside, n_patch, NULL));
    CHECK(amst_patches_write(outline, path));
    amst_patches_destroy(outline);
    amst_mesh_destroy(detail);
    free(inside);
    free(points);
    free(vertex);
    free(face);
    free_arrays(&a);
}

/* NAME of DIRECTORY/NAME.EXTENSION */
static void stem_of(const char *path, char stem[256]) {
    const char *slash = strrchr(path, '/');
    snprintf(stem, 256, "%s", slash == NULL ? path : slash + 1);
    char *dot = strrchr(stem, '.');
    if (dot != NULL)
        *dot = '\0';
}

/* -------------------------------------------------------------------- runs */

static void write_before(amst_context *ctx, const amst_mesh *mesh, const ball balls[n_balls],
                         const char *directory) {
    char path[1024];
    amst_patches *patches = make_balls(mesh, balls);
    make_path(path, directory, "before", ".svg");
    CHECK(amst_patches_write(patches, path));
    make_path(path, directory, "detail_before", ".svg");
    write_detail(ctx, mesh, patches, &balls[detailed], path);
    amst_patches_destroy(patches);
    patches = make_partition(mesh);
    make_path(path, directory, "partition_before", ".svg");
    CHECK(amst_patches_write(patches, path));
    amst_patches_destroy(patches);
}

/* One alpha on a clone of the mesh, for one choice of patches; balls NULL: the partition. */
static void run(amst_context *ctx, const amst_mesh *mesh, const ball *balls, double alpha,
                const char *directory, const char *stem, totals *sum) {
    amst_mesh *clone;
    amst_report *report;
    int64_t n_patches;
    time_t start = time(NULL);
    char name[300], path[1024];
    CHECK(amst_mesh_clone(mesh, &clone));
    amst_patches *patches = balls != NULL ? make_balls(clone, balls) : make_partition(clone);
    CHECK(amst_patches_get_count(patches, &n_patches));
    CHECK(amst_context_set_progress(ctx, show_progress, &start));
    CHECK(amst_adapt(clone, patches, alpha, NULL, &report));
    CHECK(amst_context_set_progress(ctx, NULL, NULL));
    if (amst_mesh_check(mesh) == AMST_OK) /* nothing that was in order is in disorder now */
        CHECK(amst_mesh_check(clone));

    snprintf(name, sizeof name, "%s_%s_%g", stem, balls != NULL ? "alpha" : "partition", alpha);
    make_path(path, directory, name, ".svg");
    CHECK(amst_patches_write(patches, path));
    if (balls != NULL) {
        print_patches(alpha, report, n_patches, sum);
        make_path(path, directory, name, ".msh");
        CHECK(amst_mesh_write(clone, path));
        make_path(path, directory, name, ".vtk");
        CHECK(amst_mesh_write(clone, path));
        snprintf(name, sizeof name, "detail_alpha_%g", alpha);
        make_path(path, directory, name, ".svg");
        write_detail(ctx, clone, patches, &balls[detailed], path);
    } else {
        print_all(alpha, report, n_patches, sum);
    }
    amst_report_destroy(report);
    amst_patches_destroy(patches);
    amst_mesh_destroy(clone);
}

int main(int argc, char **argv) {
    amst_context *ctx;
    amst_mesh *mesh;
    ball balls[n_balls];
    char stem[256];
    totals sum = no_rows(), whole = no_rows();
    if (argc != 3) {
        fprintf(stderr, "usage: adapt MESH OUTPUT_DIRECTORY\n");
        return 2;
    }
    stem_of(argv[1], stem);
    CHECK(amst_context_create(0, &ctx));
    CHECK(amst_mesh_read(ctx, argv[1], NULL, &mesh));
    printf("%s: %" PRId64 " vertices, %" PRId64 " faces; AlphaMST %s\n", argv[1], count_of(mesh, AMST_VERTEX),
           count_of(mesh, AMST_FACE), amst_version_string());
    if (amst_mesh_check(mesh) < 0)
        printf("The mesh has a fault before any change: %s\n", amst_last_error());
    choose_balls(mesh, balls);
    write_before(ctx, mesh, balls, argv[2]);

    print_title("Six round patches", "patch");
    for (size_t i = 0; i < n_alphas; ++i)
        run(ctx, mesh, balls, alphas[i], argv[2], stem, &sum);
    print_totals(&sum);

    print_title("A partition of the whole mesh", "patches");
    for (size_t i = 0; i < n_alphas; ++i)
        run(ctx, mesh, NULL, alphas[i], argv[2], stem, &whole);
    print_totals(&whole);

    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
    return 0;
}
