/* whole_run MESH                             prints numbers of a mesh
 * whole_run MESH OUTPUT                      writes it in another format, or as a picture (.svg)
 * whole_run MESH OUTPUT ALPHA SEED THREADS   writes it adapted as a whole, prints how that went
 *
 * One process for one mesh, so that its seconds and memory are those of a whole program. What is
 * printed is JSON; numbers of a mesh have the keys that tests/benchmark/judge.py asks for. */
#include <alphamst/alphamst.h>

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
    const char *name;
    int32_t metric;
} metric;

/* The twelve of which the paper on alpha MST (Verma and Suresh 2017) has a table. */
static const metric metrics[] = {{"AspectRatio", AMST_METRIC_ASPECT_RATIO},
                                 {"Condition", AMST_METRIC_CONDITION},
                                 {"Distortion", AMST_METRIC_DISTORTION},
                                 {"MinAngle", AMST_METRIC_MIN_ANGLE},
                                 {"MaxAngle", AMST_METRIC_MAX_ANGLE},
                                 {"Jacobian", AMST_METRIC_JACOBIAN},
                                 {"ScaledJacobian", AMST_METRIC_SCALED_JACOBIAN},
                                 {"Shape", AMST_METRIC_SHAPE},
                                 {"Shear", AMST_METRIC_SHEAR},
                                 {"Skew", AMST_METRIC_SKEW},
                                 {"Taper", AMST_METRIC_TAPER},
                                 {"Warpage", AMST_METRIC_WARPAGE}};

static void check(amst_status status) {
    if (status < 0) {
        fprintf(stderr, "%s: %s\n", amst_status_name(status), amst_last_error());
        exit(1);
    }
}

static int64_t count_of(const amst_mesh *mesh, int32_t entity) {
    int64_t count;
    check(amst_mesh_get_count(mesh, entity, &count));
    return count;
}

static void *allocate(int64_t count, size_t size) {
    void *memory = malloc((size_t)count * size);
    if (memory == NULL) {
        fprintf(stderr, "out of memory\n");
        exit(1);
    }
    return memory;
}

/* The vector product of the edges from p to q and from p to r. */
static void cross(const double p[3], const double q[3], const double r[3], double product[3]) {
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        product[k] = (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
    }
}

/* For each vertex the sum of the products at its corners; of a mesh of dim 2 the way up. */
static void sum_normals(int32_t dim, double (*points)[3], amst_id (*faces)[4], int64_t n_faces,
                        double (*normals)[3]) {
    for (int64_t f = 0; f < n_faces; ++f)
        for (int k = 0; k < 4; ++k) {
            double product[3], *normal = normals[faces[f][k]];
            cross(points[faces[f][k]], points[faces[f][(k + 1) % 4]], points[faces[f][(k + 3) % 4]], product);
            for (int c = 0; c < 3; ++c)
                normal[c] = dim == 2 ? c == 2 : normal[c] + product[c];
        }
}

/* Faces with a corner that is flat or inverted against the mesh around. Verdict's scaled Jacobian
 * cannot tell: it measures a face against its own normal, so one that is inverted as a whole has a good
 * value. */
static int64_t count_inverted(const amst_mesh *mesh) {
    const int64_t n_faces = count_of(mesh, AMST_FACE), n_points = count_of(mesh, AMST_VERTEX);
    int32_t dim;
    int64_t needed, inverted = 0;
    check(amst_mesh_get_dim(mesh, &dim));
    double *coordinates = allocate(dim * n_points, sizeof *coordinates);
    double(*points)[3] = allocate(n_points, sizeof *points),
    (*normals)[3] = allocate(n_points, sizeof *normals);
    amst_id(*faces)[4] = allocate(n_faces, sizeof *faces);
    check(amst_mesh_get_points(mesh, coordinates, dim * n_points, &needed));
    check(amst_mesh_get_faces(mesh, *faces, 4 * n_faces, &needed));
    for (int64_t v = 0; v < n_points; ++v)
        for (int c = 0; c < 3; ++c) {
            points[v][c] = c < dim ? coordinates[dim * v + c] : 0;
            normals[v][c] = 0;
        }
    sum_normals(dim, points, faces, n_faces, normals);
    for (int64_t f = 0; f < n_faces; ++f) {
        const amst_id *corners = faces[f];
        int is_inverted = 0;
        for (int k = 0; k < 4; ++k) {
            double product[3], along = 0;
            cross(points[corners[k]], points[corners[(k + 1) % 4]], points[corners[(k + 3) % 4]], product);
            for (int c = 0; c < 3; ++c)
                along += product[c] * (normals[corners[0]][c] + normals[corners[1]][c] +
                                       normals[corners[2]][c] + normals[corners[3]][c]);
            is_inverted |= !(along > 0);
        }
        inverted += is_inverted;
    }
    free(coordinates);
    free(points);
    free(normals);
    free(faces);
    return inverted;
}

static void print_numbers(const amst_mesh *mesh) {
    int64_t n_singular;
    amst_summary jacobian;
    check(amst_mesh_get_singularities(mesh, NULL, 0, &n_singular));
    check(amst_mesh_get_summary(mesh, AMST_METRIC_SCALED_JACOBIAN, &jacobian));
    printf("{\"V\": %" PRId64 ", \"F\": %" PRId64 ", \"quad\": %" PRId64 ", \"irr\": %" PRId64
           ", \"inverted\": %" PRId64 ", \"SJ_min\": %.9g, \"SJ_mean\": %.9g, \"verdict\": {",
           count_of(mesh, AMST_VERTEX), jacobian.count, jacobian.count, n_singular, count_inverted(mesh),
           jacobian.min, jacobian.mean);
    for (size_t i = 0; i < sizeof metrics / sizeof metrics[0]; ++i) {
        amst_summary s;
        check(amst_mesh_get_summary(mesh, metrics[i].metric, &s));
        printf("%s\"%s\": {\"ok_pct\": %.9g}", i == 0 ? "" : ", ", metrics[i].name,
               100 * (double)s.acceptable / (double)s.count);
    }
    printf("}}\n");
}

static void adapt(amst_mesh *mesh, double alpha, int64_t seed) {
    amst_options *options;
    amst_report *report;
    int64_t wanted, after;
    double seconds;
    check(amst_options_create(&options));
    check(amst_options_set_int(options, AMST_OPT_SEED, seed));
    const amst_status status = amst_adapt(mesh, NULL, alpha, options, &report);
    check(status);
    check(amst_report_get_real(report, AMST_ALL, AMST_RESULT_SECONDS, &seconds));
    check(amst_report_get_int(report, AMST_ALL, AMST_RESULT_FACES_WANTED, &wanted));
    check(amst_report_get_int(report, AMST_ALL, AMST_RESULT_FACES_AFTER, &after));
    printf("{\"status\": \"%s\", \"wanted\": %" PRId64 ", \"faces\": %" PRId64 ", \"seconds\": %.6f}\n",
           amst_status_name(status), wanted, after, seconds);
    amst_report_destroy(report);
    amst_options_destroy(options);
}

int main(int argc, char **argv) {
    amst_context *context;
    amst_mesh *mesh;
    if (argc != 2 && argc != 3 && argc != 6) {
        fprintf(stderr, "usage: whole_run MESH [OUTPUT [ALPHA SEED THREADS]]\n");
        return 2;
    }
    check(amst_context_create(0, &context));
    check(amst_mesh_read(context, argv[1], NULL, &mesh));
    if (argc == 2)
        print_numbers(mesh);
    if (argc == 6) {
        check(amst_context_set_threads(context, (int32_t)strtol(argv[5], NULL, 10)));
        adapt(mesh, strtod(argv[3], NULL), strtoll(argv[4], NULL, 10));
    }
    if (argc > 2)
        check(amst_mesh_write(mesh, argv[2]));
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    return 0;
}
