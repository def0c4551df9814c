/* Improve a region: fewer singular vertices and better corners with the same number of faces.
 *
 *   build/release/examples/c/improve examples/data/coast_small.msh [after.svg] */
#include "check.h"

static void print_row(const char *state, const amst_report *report, int32_t faces, int32_t singular,
                      int32_t quality) {
    int64_t n_faces = 0, n_singular = 0;
    double smallest = 0;
    check(amst_report_get_int(report, 0, faces, &n_faces));
    check(amst_report_get_int(report, 0, singular, &n_singular));
    check(amst_report_get_real(report, 0, quality, &smallest));
    printf("%-8s %6lld %9lld %12.4f\n", state, (long long)n_faces, (long long)n_singular, smallest);
}

int main(int argc, char **argv) {
    const double low[3] = {3.8, 4.4, 0}, high[3] = {6.2, 6.4, 0};
    amst_context *context = NULL;
    amst_mesh *mesh = NULL;
    amst_patches *patches = NULL;
    amst_report *report = NULL;
    if (argc < 2) {
        fprintf(stderr, "usage: improve MESH [PICTURE]\n");
        return 2;
    }
    check(amst_context_create(0, &context));
    check(amst_mesh_read(context, argv[1], NULL, &mesh));
    check(amst_patches_create(mesh, NULL, &patches));
    check(amst_patches_add_box(patches, low, high, NULL));
    check(amst_adapt(mesh, patches, 1, NULL, &report));

    printf("%-8s %6s %9s %12s\n", "region", "faces", "singular", "smallest SJ");
    print_row("before", report, AMST_RESULT_FACES_BEFORE, AMST_RESULT_SINGULAR_BEFORE,
              AMST_RESULT_QUALITY_BEFORE);
    print_row("after", report, AMST_RESULT_FACES_AFTER, AMST_RESULT_SINGULAR_AFTER,
              AMST_RESULT_QUALITY_AFTER);
    if (argc > 2)
        check(amst_patches_write(patches, argv[2]));

    amst_report_destroy(report);
    amst_patches_destroy(patches);
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    return 0;
}
