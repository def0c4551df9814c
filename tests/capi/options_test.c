/* Defaults, ranges and types of the numeric settings. */
#include <math.h>

#include "grid.h"

typedef struct integer_option {
    int32_t key;
    int64_t initial, low, high;
} integer_option;

static const integer_option integers[] = {
    {AMST_OPT_SEED, 0, INT64_MIN, INT64_MAX},
    {AMST_OPT_SMOOTH_STEPS, 20, 0, 1000},
    {AMST_OPT_REPAIR_PATCHES, 1, 0, 1},
    {AMST_OPT_CANDIDATES, 16, 1, 1000},
    {AMST_OPT_NODE_LIMIT, 1000, 0, INT64_C(1000000000)},
    {AMST_OPT_QUADRANGULATE, 0, 0, 1},
    {AMST_OPT_EDIT_BOUNDARY, 0, 0, 1},
    {AMST_OPT_STRATEGY, 0, 0, 1},
    {AMST_OPT_ALIGN, 0, 0, 1},
    {AMST_OPT_CHART, 0, 0, 3},
    {AMST_OPT_KEEP_BOUNDARY, 0, 0, 1},
    {AMST_OPT_STARTS, 1, 1, 1000},
    {AMST_OPT_BUFFER_LAYERS, 2, 0, 1000},
};

typedef struct real_option {
    int32_t key;
    double initial, low, high;
} real_option;

static const real_option reals[] = {
    {AMST_OPT_MIN_QUALITY, 0, 0, 1},
    {AMST_OPT_MIN_CONVEXITY, 0.6, 0, 1},
    {AMST_OPT_PATCH_FACES, 100, 1, 2147483647},
    {AMST_OPT_TOLERANCE, 0.5, 0.01, 100},
    {AMST_OPT_EFFORT, 1, 0.01, 100},
    {AMST_OPT_SIZE_WEIGHT, 0.7, 0, 1},
    {AMST_OPT_TRANSITION, 0.5, 0.05, 1},
    {AMST_OPT_LEAST_SIZE, 0.125, 0, 1},
    {AMST_OPT_SHARP_ANGLE, 40, 0, 180},
    {AMST_OPT_SIZE_BAND, 0, 0, 8},
    {AMST_OPT_MIN_EDGE, 0, 0, 1e30},
    {AMST_OPT_MAX_EDGE, 0, 0, 1e30},
    {AMST_OPT_GRADATION, 0.2, 0.01, 100},
    {AMST_OPT_ERROR_ORDER, 1, 0.1, 16},
};

static amst_options *new_options(void) {
    amst_options *options = NULL;
    must(amst_options_create(&options));
    return options;
}

static void integers_have_defaults_and_ranges(void **state) {
    (void)state;
    amst_options *options = new_options();
    for (size_t i = 0; i < sizeof integers / sizeof *integers; ++i) {
        const integer_option *o = &integers[i];
        int64_t value = -12345;
        must(amst_options_get_int(options, o->key, &value));
        assert_true(value == o->initial);
        must(amst_options_set_int(options, o->key, o->low));
        must(amst_options_set_int(options, o->key, o->high));
        if (o->low != INT64_MIN)
            refused(AMST_ERR_RANGE, amst_options_set_int(options, o->key, o->low - 1));
        if (o->high != INT64_MAX)
            refused(AMST_ERR_RANGE, amst_options_set_int(options, o->key, o->high + 1));
        must(amst_options_get_int(options, o->key, &value));
        assert_true(value == o->high);
        refused(AMST_ERR_NOT_FOUND, amst_options_set_real(options, o->key, 0.5));
        double real = -1;
        refused(AMST_ERR_NOT_FOUND, amst_options_get_real(options, o->key, &real));
        assert_true(real == -1);
    }
    amst_options_destroy(options);
}

static void reals_have_defaults_and_ranges(void **state) {
    (void)state;
    amst_options *options = new_options();
    for (size_t i = 0; i < sizeof reals / sizeof *reals; ++i) {
        const real_option *o = &reals[i];
        double value = -12345;
        must(amst_options_get_real(options, o->key, &value));
        assert_true(value == o->initial);
        must(amst_options_set_real(options, o->key, o->low));
        must(amst_options_set_real(options, o->key, o->high));
        refused(AMST_ERR_RANGE, amst_options_set_real(options, o->key, o->low - 0.01));
        refused(AMST_ERR_RANGE, amst_options_set_real(options, o->key, o->high * 1.01));
        refused(AMST_ERR_NOT_FINITE, amst_options_set_real(options, o->key, NAN));
        refused(AMST_ERR_NOT_FINITE, amst_options_set_real(options, o->key, INFINITY));
        must(amst_options_get_real(options, o->key, &value));
        assert_true(value == o->high);
        refused(AMST_ERR_NOT_FOUND, amst_options_set_int(options, o->key, 1));
    }
    amst_options_destroy(options);
}

static void unknown_keys_are_not_found(void **state) {
    (void)state;
    amst_options *options = new_options();
    const int32_t keys[] = {AMST_OPTION_INVALID, 999, 1999, AMST_OPTION_MAX};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; ++i) {
        int64_t value;
        double real;
        refused(AMST_ERR_NOT_FOUND, amst_options_set_int(options, keys[i], 1));
        refused(AMST_ERR_NOT_FOUND, amst_options_set_real(options, keys[i], 1));
        refused(AMST_ERR_NOT_FOUND, amst_options_get_int(options, keys[i], &value));
        refused(AMST_ERR_NOT_FOUND, amst_options_get_real(options, keys[i], &real));
    }
    amst_options_destroy(options);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(integers_have_defaults_and_ranges),
        cmocka_unit_test(reals_have_defaults_and_ranges),
        cmocka_unit_test(unknown_keys_are_not_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
