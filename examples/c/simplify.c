/* Simplify: three faces where there were four, patch by patch over the whole mesh. A patch that
 * cannot have its wanted faces is left as it was.
 *
 *   build/release/examples/c/simplify examples/data/coast_small.msh [after.svg] */
#include "check.h"

int main(int argc, char **argv) {
    amst_context *context = NULL;
    amst_options *options = NULL;
    amst_mesh *mesh = NULL;
    amst_patches *patches = NULL;
    amst_report *report = NULL;
    int64_t n_patches = 0, left = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: simplify MESH [PICTURE]\n");
        return 2;
    }
    check(amst_options_create(&options));
    check(amst_options_set_real(options, AMST_OPT_PATCH_FACES, 80));
    check(amst_options_set_int(options, AMST_OPT_SEED, 7));
    check(amst_context_create(0, &context));
    check(amst_mesh_read(context, argv[1], options, &mesh));
    check(amst_patches_create(mesh, options, &patches));
    check(amst_patches_decompose(patches, AMST_DECOMPOSE_CLUSTERS, &n_patches));
    check(amst_adapt(mesh, patches, 0.75, options, &report));

    printf("%5s %6s %6s %6s %9s\n", "patch", "before", "wanted", "after", "singular");
    for (amst_id patch = 0; patch < n_patches; ++patch) {
        int64_t before = 0, wanted = 0, after = 0, singular = 0, status = 0;
        check(amst_report_get_int(report, patch, AMST_RESULT_FACES_BEFORE, &before));
        check(amst_report_get_int(report, patch, AMST_RESULT_FACES_WANTED, &wanted));
        check(amst_report_get_int(report, patch, AMST_RESULT_FACES_AFTER, &after));
        check(amst_report_get_int(report, patch, AMST_RESULT_SINGULAR_AFTER, &singular));
        check(amst_report_get_int(report, patch, AMST_RESULT_STATUS, &status));
        left += status < 0;
        printf("%5d %6lld %6lld %6lld %9lld%s\n", (int)patch + 1, (long long)before, (long long)wanted,
               (long long)after, (long long)singular, status < 0 ? "  left" : "");
    }
    printf("%lld of %lld patches left\n", (long long)left, (long long)n_patches);
    if (argc > 2)
        check(amst_patches_write(patches, argv[2]));

    amst_report_destroy(report);
    amst_patches_destroy(patches);
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    amst_options_destroy(options);
    return 0;
}
