/* Sizes: what the report tells of the faces of two patches and of both together, for several alphas.
 *
 *   build/release/examples/c/sizes examples/data/coast_small.msh [after_] */
#include "check.h"

static long long integer(const amst_report *report, amst_id patch, int32_t key) {
    int64_t value = 0;
    check(amst_report_get_int(report, patch, key, &value));
    return (long long)value;
}

static double real(const amst_report *report, amst_id patch, int32_t key) {
    double value = 0;
    check(amst_report_get_real(report, patch, key, &value));
    return value;
}

static void print_row(double alpha, const char *name, const amst_report *report, amst_id patch) {
    printf(
        "%5.1f %5s %6lld %9lld %7.2f %7.2f %7.2f %7.2f %7.2f %7.2f\n", alpha, name,
        integer(report, patch, AMST_RESULT_FACES_AFTER), integer(report, patch, AMST_RESULT_SINGULAR_AFTER),
        real(report, patch, AMST_RESULT_SIZE_ERROR_BEFORE), real(report, patch, AMST_RESULT_SIZE_ERROR_AFTER),
        real(report, patch, AMST_RESULT_LEAST_AREA_AFTER),
        real(report, patch, AMST_RESULT_SHORTEST_EDGE_AFTER),
        real(report, patch, AMST_RESULT_ASPECT_RATIO_AFTER), real(report, patch, AMST_RESULT_TIME_STEP));
}

int main(int argc, char **argv) {
    const double alphas[] = {0.5, 1, 2, 4}, centre[3] = {4.2, 5.2, 0}, other[3] = {6, 5, 0};
    amst_context *context = NULL;
    amst_mesh *mesh = NULL;
    int64_t begun = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: sizes MESH [PICTURE_PREFIX]\n");
        return 2;
    }
    check(amst_context_create(0, &context));
    check(amst_mesh_read(context, argv[1], NULL, &mesh));
    check(amst_mesh_mark(mesh, &begun));

    printf("%5s %5s %6s %9s %7s %7s %7s %7s %7s %7s\n", "alpha", "patch", "faces", "singular", "before",
           "after", "area", "edge", "aspect", "step");
    for (size_t i = 0; i < sizeof alphas / sizeof *alphas; ++i) {
        amst_patches *patches = NULL;
        amst_report *report = NULL;
        check(amst_mesh_rollback(mesh, begun));
        check(amst_patches_create(mesh, NULL, &patches));
        check(amst_patches_add_ball(patches, centre, 0.7, NULL));
        check(amst_patches_add_ball(patches, other, 0.7, NULL));
        check(amst_adapt(mesh, patches, alphas[i], NULL, &report));
        print_row(alphas[i], "1", report, 0);
        print_row(alphas[i], "2", report, 1);
        print_row(alphas[i], "both", report, AMST_ALL);
        if (argc > 2) {
            char path[1024];
            snprintf(path, sizeof path, "%s%zu.svg", argv[2], i);
            check(amst_patches_write(patches, path));
        }
        amst_report_destroy(report);
        amst_patches_destroy(patches);
    }
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    return 0;
}
