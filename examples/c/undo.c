/* Undo: two changes, each taken back, and the mesh is bit for bit what it was.
 *
 *   build/release/examples/c/undo examples/data/coast_small.msh */
#include "check.h"

static void print_row(const char *what, const amst_mesh *mesh, int64_t digest_at_start) {
    int64_t faces = 0, digest = 0, needed = 0;
    check(amst_mesh_get_count(mesh, AMST_FACE, &faces));
    check(amst_mesh_get_checksum(mesh, &digest));
    const amst_status status = amst_mesh_get_singularities(mesh, NULL, 0, &needed);
    if (status != AMST_ERR_BUFFER_TOO_SMALL)
        check(status);
    printf("%-16s %6lld %9lld   %s\n", what, (long long)faces, (long long)needed,
           digest == digest_at_start ? "as at the start" : "changed");
}

static void adapt_ball(amst_mesh *mesh, double x, double y, double alpha) {
    const double centre[3] = {x, y, 0};
    amst_patches *patches = NULL;
    check(amst_patches_create(mesh, NULL, &patches));
    check(amst_patches_add_ball(patches, centre, 0.8, NULL));
    check(amst_adapt(mesh, patches, alpha, NULL, NULL));
    amst_patches_destroy(patches);
}

int main(int argc, char **argv) {
    amst_context *context = NULL;
    amst_mesh *mesh = NULL;
    int64_t digest = 0, first = 0, second = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: undo MESH\n");
        return 2;
    }
    check(amst_context_create(0, &context));
    check(amst_mesh_read(context, argv[1], NULL, &mesh));
    check(amst_mesh_get_checksum(mesh, &digest));
    printf("%-16s %6s %9s\n", "mesh", "faces", "singular");
    print_row("read", mesh, digest);

    check(amst_mesh_mark(mesh, &first));
    adapt_ball(mesh, 4.9, 5.3, 3);
    print_row("refined", mesh, digest);
    check(amst_mesh_mark(mesh, &second));
    check(amst_smooth(mesh, NULL, NULL, NULL));
    print_row("smoothed", mesh, digest);
    check(amst_mesh_rollback(mesh, second));
    print_row("not smoothed", mesh, digest);
    check(amst_mesh_rollback(mesh, first));
    print_row("not refined", mesh, digest);
    check(amst_mesh_forget(mesh, first));

    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    return 0;
}
