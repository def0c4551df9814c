/* Refine around a moving front: at every step the mesh is fine where the front is and as it was
 * everywhere else.
 *
 *   build/release/examples/c/front examples/data/coast_small.msh [front_] */
#include "check.h"

int main(int argc, char **argv) {
    enum { steps = 5 };
    amst_context *context = NULL;
    amst_mesh *mesh = NULL;
    int64_t coarse = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: front MESH [PICTURE_PREFIX]\n");
        return 2;
    }
    check(amst_context_create(0, &context));
    check(amst_mesh_read(context, argv[1], NULL, &mesh));
    check(amst_mesh_mark(mesh, &coarse));

    printf("%4s %6s %6s %9s %12s\n", "step", "near", "faces", "singular", "smallest SJ");
    for (int step = 0; step < steps; ++step) {
        const double front[3] = {4.2 + 0.3 * step, 5.2 + 0.05 * step, 0};
        amst_patches *patches = NULL;
        amst_report *report = NULL;
        int64_t near = 0, faces = 0, singular = 0;
        double smallest = 0;
        check(amst_mesh_rollback(mesh, coarse)); /* the front has moved on */
        check(amst_patches_create(mesh, NULL, &patches));
        check(amst_patches_add_ball(patches, front, 0.8, NULL));
        check(amst_adapt(mesh, patches, 2, NULL, &report));
        check(amst_report_get_int(report, AMST_ALL, AMST_RESULT_FACES_AFTER, &near));
        check(amst_report_get_int(report, AMST_ALL, AMST_RESULT_SINGULAR_AFTER, &singular));
        check(amst_report_get_real(report, AMST_ALL, AMST_RESULT_QUALITY_AFTER, &smallest));
        check(amst_mesh_get_count(mesh, AMST_FACE, &faces));
        printf("%4d %6lld %6lld %9lld %12.4f\n", step, (long long)near, (long long)faces, (long long)singular,
               smallest);
        if (argc > 2) {
            char path[1024];
            snprintf(path, sizeof path, "%s%d.svg", argv[2], step);
            check(amst_patches_write(patches, path));
        }
        amst_report_destroy(report);
        amst_patches_destroy(patches);
    }
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    return 0;
}
