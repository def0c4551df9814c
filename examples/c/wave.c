/* Wave: adapt while you solve. A ring around the middle of a square runs outwards; before each step the field
 * "size" asks for small faces near it, and the mesh changes only where its faces are off that. An energy and
 * a temperature come along: the sum of the one and the linear values of the other stay.
 *
 *   build/release/examples/c/wave 6 [wave_] */
#include "check.h"

#include <math.h>

enum { SIDE = 32, N_POINTS = (SIDE + 1) * (SIDE + 1), N_FACES = SIDE * SIDE };

static const double middle = 16;

static void *memory(int64_t n, size_t size) {
    void *made = malloc((size_t)n * size);
    if (made == NULL)
        exit(1);
    return made;
}

/* A square of unit squares with the two fields. */
static amst_mesh *make_square(amst_context *context) {
    static double points[N_POINTS][2], temperature[N_POINTS], energy[N_FACES];
    static int32_t faces[N_FACES][4];
    amst_mesh *mesh = NULL;
    for (int v = 0; v < N_POINTS; ++v) {
        const int column = v % (SIDE + 1), row = v / (SIDE + 1);
        points[v][0] = column;
        points[v][1] = row;
        temperature[v] = points[v][0] + 2 * points[v][1];
    }
    for (int32_t f = 0; f < N_FACES; ++f) {
        const int32_t column = f % SIDE, row = f / SIDE, v = f + row;
        const int32_t quad[4] = {v, v + 1, v + SIDE + 2, v + SIDE + 1};
        const double x = column + 0.5 - middle, y = row + 0.5 - middle;
        for (int k = 0; k < 4; ++k)
            faces[f][k] = quad[k];
        energy[f] = 1 / (1 + (x * x + y * y) / 32);
    }
    check(amst_mesh_create(context, 2, *points, N_POINTS, 0, 0, *faces, N_FACES, 0, 0, 4, NULL, &mesh));
    check(amst_mesh_set_field(mesh, AMST_FACE, "energy", 1, AMST_CARRY_CONSERVE, energy, N_FACES));
    check(amst_mesh_set_field(mesh, AMST_VERTEX, "temperature", 1, AMST_CARRY_LINEAR, temperature, N_POINTS));
    return mesh;
}

/* The caller's own array: coordinates of all vertices, whose number is n. */
static double *points_of(const amst_mesh *mesh, int64_t *n) {
    int64_t needed = 0;
    check(amst_mesh_get_count(mesh, AMST_VERTEX, n));
    double *points = memory(2 * *n, sizeof *points);
    check(amst_mesh_get_points(mesh, points, 2 * *n, &needed));
    return points;
}

/* The field "size" around the ring: half an edge within 1.5 of it, a whole one from 5 on. */
static void want_sizes(amst_mesh *mesh, double radius) {
    int64_t n = 0;
    double *points = points_of(mesh, &n), *size = memory(n, sizeof *size);
    for (int64_t v = 0; v < n; ++v) {
        const double x = points[2 * v] - middle, y = points[2 * v + 1] - middle;
        const double away = fabs(sqrt(x * x + y * y) - radius);
        size[v] = fmin(fmax(0.5, 0.5 + 0.5 * (away - 1.5) / 3.5), 1);
    }
    check(amst_mesh_set_field(mesh, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, size, n));
    free(points);
    free(size);
}

static double total_energy(const amst_mesh *mesh) {
    int64_t n = 0, needed = 0;
    double sum = 0;
    check(amst_mesh_get_count(mesh, AMST_FACE, &n));
    double *area = memory(n, sizeof *area), *energy = memory(n, sizeof *energy);
    check(amst_mesh_get_quality(mesh, AMST_METRIC_AREA, area, n, &needed));
    check(amst_mesh_get_field(mesh, AMST_FACE, "energy", energy, n, &needed));
    for (int64_t f = 0; f < n; ++f)
        sum += energy[f] * area[f];
    free(area);
    free(energy);
    return sum;
}

static double temperature_error(const amst_mesh *mesh) {
    int64_t n = 0, needed = 0;
    double error = 0, *points = points_of(mesh, &n), *temperature = memory(n, sizeof *temperature);
    check(amst_mesh_get_field(mesh, AMST_VERTEX, "temperature", temperature, n, &needed));
    for (int64_t v = 0; v < n; ++v)
        error = fmax(error, fabs(temperature[v] - points[2 * v] - 2 * points[2 * v + 1]));
    free(points);
    free(temperature);
    return error;
}

/* The power of ten above a value: its digits are those of rounding, and differ between languages. */
static void bound(double value, char text[16]) {
    int power = -12;
    for (double limit = 1e-12; power < 0 && !(value < limit); limit *= 10)
        ++power;
    snprintf(text, 16, "< 1e%d", power);
}

static long long integer(const amst_report *report, int32_t key) {
    int64_t value = 0;
    check(amst_report_get_int(report, AMST_ALL, key, &value));
    return (long long)value;
}

static void print_row(const amst_mesh *mesh, const amst_report *report, int radius, double energy) {
    double smallest = 0;
    char change[16], error[16];
    check(amst_report_get_real(report, AMST_ALL, AMST_RESULT_QUALITY_AFTER, &smallest));
    bound(fabs(total_energy(mesh) / energy - 1), change);
    bound(temperature_error(mesh), error);
    printf("%6d %6lld %6lld %6lld %9lld %12.4f %8s %12s\n", radius, integer(report, AMST_RESULT_FACES_BEFORE),
           integer(report, AMST_RESULT_FACES_WANTED), integer(report, AMST_RESULT_FACES_AFTER),
           integer(report, AMST_RESULT_SINGULAR_AFTER), smallest, change, error);
}

static void draw(const amst_mesh *mesh, const char *prefix, int radius) {
    char path[1024];
    snprintf(path, sizeof path, "%s%d.svg", prefix, radius);
    check(amst_mesh_write(mesh, path));
}

int main(int argc, char **argv) {
    enum { FIRST = 5 }; /* radius */
    amst_context *context = NULL;
    amst_options *options = NULL;
    int64_t before = 0, after = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: wave STEPS [PICTURE_PREFIX]\n");
        return 2;
    }
    const int last = FIRST + atoi(argv[1]) - 1;
    check(amst_context_create(0, &context));
    amst_mesh *mesh = make_square(context);
    const double energy = total_energy(mesh);
    check(amst_options_create(&options));
    check(amst_options_set_real(options, AMST_OPT_SIZE_BAND, 0.7));

    printf("%6s %6s %6s %6s %9s %12s %8s %12s\n", "radius", "before", "wanted", "after", "singular",
           "smallest SJ", "energy", "temperature");
    for (int radius = FIRST; radius <= last; ++radius) {
        amst_report *report = NULL;
        want_sizes(mesh, radius);
        check(amst_adapt(mesh, NULL, 1, options, &report));
        print_row(mesh, report, radius, energy);
        if (argc > 2)
            draw(mesh, argv[2], radius);
        amst_report_destroy(report);
    }
    want_sizes(mesh, last); /* the last call again */
    check(amst_mesh_get_checksum(mesh, &before));
    check(amst_adapt(mesh, NULL, 1, options, NULL));
    check(amst_mesh_get_checksum(mesh, &after));
    printf("again: %s\n", before == after ? "nothing changed" : "the mesh changed");
    amst_options_destroy(options);
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    return 0;
}
