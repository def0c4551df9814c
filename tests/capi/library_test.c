/* Version, features, names of statuses, the last error. */
#include <stdio.h>

#include "grid.h"

static void version_is_that_of_the_header(void **state) {
    (void)state;
    char text[32];
    assert_int_equal(amst_version(),
                     AMST_VERSION_MAJOR * 10000 + AMST_VERSION_MINOR * 100 + AMST_VERSION_PATCH);
    snprintf(text, sizeof text, "%d.%d.%d", AMST_VERSION_MAJOR, AMST_VERSION_MINOR, AMST_VERSION_PATCH);
    assert_string_equal(amst_version_string(), text);
}

static void features(void **state) {
    (void)state;
    assert_int_equal(amst_has("threads"), 1);
    assert_int_equal(amst_has("teleportation"), 0);
    assert_int_equal(amst_has(""), 0);
    assert_int_equal(amst_has(NULL), 0);
}

static void every_status_has_its_own_name(void **state) {
    (void)state;
    assert_string_equal(amst_status_name(AMST_OK), "AMST_OK");
    assert_string_equal(amst_status_name(AMST_PARTIAL), "AMST_PARTIAL");
    assert_string_equal(amst_status_name(AMST_ERR_STALE), "AMST_ERR_STALE");
    assert_string_equal(amst_status_name(AMST_ERR_INTERNAL), "AMST_ERR_INTERNAL");
    const char *unknown = amst_status_name(-1000);
    assert_non_null(unknown);
    for (int32_t a = AMST_ERR_CHORD; a <= AMST_PARTIAL; ++a) {
        assert_string_not_equal(amst_status_name(a), unknown);
        for (int32_t b = AMST_ERR_CHORD; b < a; ++b)
            assert_string_not_equal(amst_status_name(a), amst_status_name(b));
    }
    assert_string_equal(amst_status_name(AMST_STATUS_MAX), unknown);
}

/* Must run first: no call has failed yet. */
static void no_error_at_first(void **state) {
    (void)state;
    assert_string_equal(amst_last_error(), "");
    assert_error_names(AMST_ENTITY_NONE, -1);
    must(amst_last_error_where(NULL, NULL, NULL));
}

static void error_stays_until_the_next_failure(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    refused(AMST_ERR_RANGE, amst_context_set_threads(ctx, -3));
    char *first = strcpy(memory(strlen(amst_last_error()) + 1), amst_last_error());
    assert_non_null(strstr(first, "-3"));
    must(amst_context_set_threads(ctx, 2));
    amst_context_destroy(ctx);
    amst_mesh_destroy(NULL);
    assert_string_equal(amst_last_error(), first);
    refused(AMST_ERR_NULL, amst_context_set_threads(NULL, 1));
    assert_string_not_equal(amst_last_error(), first);
    assert_non_null(strstr(amst_last_error(), "ctx"));
    free(first);
}

static void error_names_ids_in_the_callers_numbering(void **state) {
    (void)state;
    for (int32_t base = 0; base <= 1; ++base) {
        amst_context *ctx = new_context(base);
        amst_mesh *mesh = new_grid(ctx, base, 3, 3);
        const amst_id pair[2] = {base, 16 + base};
        amst_id edge;
        refused(AMST_ERR_RANGE, amst_mesh_find_edges(mesh, pair, 1, &edge));
        assert_error_names(AMST_VERTEX, 16 + base);
        assert_non_null(strstr(amst_last_error(), base == 0 ? "vertex 16 " : "vertex 17 "));
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_error_at_first),
        cmocka_unit_test(version_is_that_of_the_header),
        cmocka_unit_test(features),
        cmocka_unit_test(every_status_has_its_own_name),
        cmocka_unit_test(error_stays_until_the_next_failure),
        cmocka_unit_test(error_names_ids_in_the_callers_numbering),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
