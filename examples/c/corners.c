/* Choose the faces of a patch by hand and ask what would come with corners set by hand and with
 * those of the library; then take the latter.
 *
 *   build/release/examples/c/corners examples/data/coast_small.msh [after.svg] */
#include "check.h"

/* Faces whose centroid is in the ellipse around (4.9, 5.3). */
static int64_t choose(const amst_mesh *mesh, amst_id *chosen) {
    int64_t n_points = 0, n_faces = 0, needed = 0, n = 0;
    check(amst_mesh_get_count(mesh, AMST_VERTEX, &n_points));
    check(amst_mesh_get_count(mesh, AMST_FACE, &n_faces));
    double *points = malloc(sizeof *points * 2 * (size_t)n_points);
    amst_id *faces = malloc(sizeof *faces * 4 * (size_t)n_faces);
    check(amst_mesh_get_points(mesh, points, 2 * n_points, &needed));
    check(amst_mesh_get_faces(mesh, faces, 4 * n_faces, &needed));
    for (int64_t f = 0; f < n_faces; ++f) {
        double x = 0, y = 0;
        for (int k = 0; k < 4; ++k) {
            x += points[2 * faces[4 * f + k]] / 4;
            y += points[2 * faces[4 * f + k] + 1] / 4;
        }
        if ((x - 4.9) * (x - 4.9) / 1.2 + (y - 5.3) * (y - 5.3) / 0.7 < 1)
            chosen[n++] = (amst_id)f;
    }
    free(points);
    free(faces);
    return n;
}

/* Four boundary vertices, a quarter of the boundary from one to the next. */
static void set_corners(amst_patches *patches, amst_id patch) {
    int64_t n = 0;
    amst_id corners[4];
    const amst_status status = amst_patches_get_boundary(patches, patch, NULL, 0, &n);
    if (status != AMST_ERR_BUFFER_TOO_SMALL)
        check(status);
    amst_id *boundary = malloc(sizeof *boundary * (size_t)n);
    check(amst_patches_get_boundary(patches, patch, boundary, n, &n));
    for (int k = 0; k < 4; ++k)
        corners[k] = boundary[k * n / 4];
    free(boundary);
    check(amst_patches_set_corners(patches, patch, corners, 4));
}

int main(int argc, char **argv) {
    const double alphas[] = {0.75, 1, 1.5, 2};
    amst_context *context = NULL;
    amst_mesh *mesh = NULL;
    amst_patches *patches = NULL;
    amst_report *report = NULL;
    amst_id patch = 0;
    int64_t n_faces = 0, after = 0, singular = 0;
    int32_t defects = 0;
    double convexity = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: corners MESH [PICTURE]\n");
        return 2;
    }
    check(amst_context_create(0, &context));
    check(amst_mesh_read(context, argv[1], NULL, &mesh));
    check(amst_mesh_get_count(mesh, AMST_FACE, &n_faces));
    amst_id *chosen = malloc(sizeof *chosen * (size_t)n_faces);
    const int64_t n = choose(mesh, chosen);
    check(amst_patches_create(mesh, NULL, &patches));
    check(amst_patches_add_faces(patches, chosen, n, &patch));
    free(chosen);
    check(amst_patches_check(patches, patch, &defects, &convexity));
    printf("%lld faces chosen, defects %d, convexity %.3f\n", (long long)n, (int)defects, convexity);

    printf("%5s %6s %18s %18s\n", "alpha", "faces", "singular, by hand", "by the library");
    for (size_t k = 0; k < sizeof alphas / sizeof alphas[0]; ++k) {
        int64_t by_hand = 0;
        set_corners(patches, patch);
        check(amst_patches_predict(patches, patch, alphas[k], NULL, NULL, &by_hand));
        check(amst_patches_set_corners(patches, patch, NULL, 0));
        check(amst_patches_predict(patches, patch, alphas[k], NULL, &after, &singular));
        printf("%5.2f %6lld %18lld %18lld\n", alphas[k], (long long)after, (long long)by_hand,
               (long long)singular);
    }
    check(amst_adapt(mesh, patches, 1.5, NULL, &report));
    check(amst_report_get_int(report, patch, AMST_RESULT_FACES_AFTER, &after));
    check(amst_report_get_int(report, patch, AMST_RESULT_SINGULAR_AFTER, &singular));
    printf("%5s %6lld %18s %18lld\n", "done", (long long)after, "", (long long)singular);
    if (argc > 2)
        check(amst_patches_write(patches, argv[2]));

    amst_report_destroy(report);
    amst_patches_destroy(patches);
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    return 0;
}
