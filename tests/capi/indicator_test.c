/* Sizes from an indicator: what is refused and left alone; numbers are in tests/reference. */
#include <math.h>

#include "grid.h"

static amst_context *ctx;
static amst_mesh *mesh;
static amst_options *options;
static double ones[100];

static int setup(void **state) {
    (void)state;
    ctx = new_context(0);
    mesh = new_grid(ctx, 0, 10, 10);
    must(amst_options_create(&options));
    for (int f = 0; f < 100; ++f)
        ones[f] = 1;
    return 0;
}

static int teardown(void **state) {
    (void)state;
    amst_options_destroy(options);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
    return 0;
}

static void the_size_is_written(void **state) {
    (void)state;
    double sizes[121], asked = 0;
    int64_t n;
    const int64_t before = revision(mesh);
    must(amst_mesh_size_from_indicator(mesh, ones, 100, 0, 400, NULL, &asked));
    assert_true(fabs(asked - 400) <= 0.4);
    must(amst_mesh_get_field(mesh, AMST_VERTEX, "size", sizes, 121, &n));
    for (int v = 0; v < 121; ++v)
        assert_true(fabs(sizes[v] - 0.5) < 1e-3);
    must(amst_mesh_size_from_indicator(mesh, ones, 100, 2, 0, NULL, NULL)); /* twice as long */
    must(amst_mesh_get_field(mesh, AMST_VERTEX, "size", sizes, 121, &n));
    assert_true(fabs(sizes[60] - 2) < 1e-14);
    assert_true(revision(mesh) == before);
}

static void what_adapt_makes_of_it(void **state) {
    (void)state;
    double jump[100], asked;
    int64_t again;
    for (int f = 0; f < 100; ++f)
        jump[f] = f / 10 == 5 ? 1 : 0;
    must(amst_options_set_real(options, AMST_OPT_MIN_EDGE, 0.5));
    must(amst_options_set_real(options, AMST_OPT_MAX_EDGE, 1));
    must(amst_options_set_real(options, AMST_OPT_SIZE_BAND, 0.7));
    must(amst_mesh_size_from_indicator(mesh, jump, 100, 0.1, 0, options, &asked));
    must(amst_adapt(mesh, NULL, 1, options, NULL));
    const int64_t n = count_of(mesh, AMST_FACE);
    assert_true(n > 1.1 * 100 && fabs((double)n / asked - 1) < 0.2);
    /* Where the wanted sizes change by less than half of the band nothing is touched. */
    double *sizes = memory(sizeof(double) * 2000);
    const int64_t as_it_was = checksum(mesh);
    must(amst_mesh_get_field(mesh, AMST_VERTEX, "size", sizes, 2000, &again));
    for (int64_t v = 0; v < again; ++v)
        sizes[v] *= 1.05;
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, sizes, again));
    must(amst_adapt(mesh, NULL, 1, options, NULL));
    assert_true(checksum(mesh) == as_it_was);
    free(sizes);
}

static void refusals_leave_the_field(void **state) {
    (void)state;
    double sizes[121], wrong[100], asked = -7;
    int64_t n;
    must(amst_mesh_size_from_indicator(mesh, ones, 100, 0, 400, NULL, NULL));
    memcpy(wrong, ones, sizeof wrong);
    wrong[42] = -1;
    refused(AMST_ERR_RANGE, amst_mesh_size_from_indicator(mesh, wrong, 100, 0, 100, NULL, &asked));
    assert_error_names(AMST_FACE, 42);
    wrong[42] = NAN;
    refused(AMST_ERR_NOT_FINITE, amst_mesh_size_from_indicator(mesh, wrong, 100, 0, 100, NULL, &asked));
    assert_error_names(AMST_FACE, 42);
    refused(AMST_ERR_NOT_FINITE, amst_mesh_size_from_indicator(mesh, ones, 100, NAN, 100, NULL, &asked));
    refused(AMST_ERR_RANGE, amst_mesh_size_from_indicator(mesh, ones, 99, 0, 100, NULL, &asked));
    refused(AMST_ERR_RANGE, amst_mesh_size_from_indicator(mesh, ones, 100, 0, 0, NULL, &asked));
    refused(AMST_ERR_RANGE, amst_mesh_size_from_indicator(mesh, ones, 100, -1, 100, NULL, &asked));
    refused(AMST_ERR_RANGE, amst_mesh_size_from_indicator(mesh, ones, 100, 1, -1, NULL, &asked));
    refused(AMST_ERR_NULL, amst_mesh_size_from_indicator(NULL, ones, 100, 1, 0, NULL, &asked));
    refused(AMST_ERR_NULL, amst_mesh_size_from_indicator(mesh, NULL, 100, 1, 0, NULL, &asked));
    must(amst_options_set_real(options, AMST_OPT_MIN_EDGE, 2));
    must(amst_options_set_real(options, AMST_OPT_MAX_EDGE, 1));
    refused(AMST_ERR_ARGUMENT, amst_mesh_size_from_indicator(mesh, ones, 100, 0, 100, options, &asked));
    assert_true(asked == -7);
    must(amst_mesh_get_field(mesh, AMST_VERTEX, "size", sizes, 121, &n));
    assert_true(fabs(sizes[7] - 0.5) < 1e-3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(the_size_is_written, setup, teardown),
        cmocka_unit_test_setup_teardown(what_adapt_makes_of_it, setup, teardown),
        cmocka_unit_test_setup_teardown(refusals_leave_the_field, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
