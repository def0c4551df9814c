/* Chords through the interface: queries, what is refused and why, operations, undoing. */
#include "grid.h"

static int64_t *property(const amst_mesh *mesh, int32_t which, const amst_options *options, int64_t *n) {
    must(amst_mesh_get_chords(mesh, which, options, NULL, 0, n));
    int64_t *values = memory(sizeof(int64_t) * (size_t)*n);
    must(amst_mesh_get_chords(mesh, which, options, values, *n, n));
    return values;
}

static int64_t sum_of(const amst_mesh *mesh, int32_t which) {
    int64_t n, sum = 0, *values = property(mesh, which, NULL, &n);
    for (int64_t i = 0; i < n; ++i)
        sum += values[i];
    free(values);
    return sum;
}

/* An edge of the first closed chord that can be collapsed, and what the table says of it. */
static amst_id free_ring(const amst_mesh *mesh, int64_t *length, int64_t *singular_after) {
    int64_t n, *edges = property(mesh, AMST_CHORD_EDGE, NULL, &n);
    int64_t *closed = property(mesh, AMST_CHORD_CLOSED, NULL, &n);
    int64_t *lengths = property(mesh, AMST_CHORD_LENGTH, NULL, &n);
    int64_t *refusal = property(mesh, AMST_CHORD_REFUSAL, NULL, &n);
    int64_t *after = property(mesh, AMST_CHORD_SINGULAR_AFTER, NULL, &n);
    amst_id edge = -1;
    for (int64_t i = n; i-- > 0;)
        if (closed[i] && refusal[i] == 0) {
            edge = (amst_id)edges[i];
            *length = lengths[i];
            *singular_after = after[i];
        }
    free(edges);
    free(closed);
    free(lengths);
    free(refusal);
    free(after);
    return edge;
}

/* An edge of the last chord of three faces. */
static amst_id column(const amst_mesh *mesh) {
    int64_t n, *edges = property(mesh, AMST_CHORD_EDGE, NULL, &n);
    int64_t *lengths = property(mesh, AMST_CHORD_LENGTH, NULL, &n);
    amst_id edge = -1;
    for (int64_t i = 0; i < n; ++i)
        if (lengths[i] == 3)
            edge = (amst_id)edges[i];
    free(edges);
    free(lengths);
    return edge;
}

static void queries_in_both_bases(void **state) {
    (void)state;
    for (int32_t base = 0; base <= 1; ++base) {
        amst_context *ctx = new_context(base);
        amst_mesh *mesh = new_grid(ctx, base, 5, 3);
        const int64_t n_edges = count_of(mesh, AMST_EDGE);
        amst_id *ids = memory(sizeof(amst_id) * (size_t)n_edges), out[6];
        int64_t n_chords = 0, needed = 0, crossings = -1;
        int32_t closed = -1;
        must(amst_mesh_get_chord_ids(mesh, &n_chords, ids, n_edges, &needed));
        assert_int_equal(n_chords, 8);
        assert_int_equal(ids[0], base);
        assert_int_equal(sum_of(mesh, AMST_CHORD_LENGTH), 2 * 15);
        assert_int_equal(sum_of(mesh, AMST_CHORD_FACES), 2 * 15);
        assert_int_equal(sum_of(mesh, AMST_CHORD_CLOSED), 0);
        assert_int_equal(sum_of(mesh, AMST_CHORD_CROSSINGS), 0);
        assert_int_equal(sum_of(mesh, AMST_CHORD_TOUCHES), 0);
        assert_int_equal(sum_of(mesh, AMST_CHORD_SINGULARITIES), 0);
        assert_int_equal(sum_of(mesh, AMST_CHORD_SINGULAR_AFTER), 0);
        must(amst_mesh_get_chord(mesh, base, &closed, &crossings, out, 6, &needed));
        assert_int_equal(closed, 0);
        assert_int_equal(crossings, 0);
        assert_int_equal(needed, 4);
        for (int i = 0; i < 4; ++i)
            assert_int_equal(ids[out[i] - base], base);
        must(amst_mesh_get_chord(mesh, base, NULL, NULL, NULL, 0, &needed));
        must(amst_mesh_get_chord_ids(mesh, NULL, NULL, 0, &needed));
        assert_int_equal(needed, n_edges);
        closed = -1;
        refused(AMST_ERR_BUFFER_TOO_SMALL, amst_mesh_get_chord(mesh, base, &closed, NULL, out, 3, &needed));
        assert_int_equal(closed, -1);
        refused(AMST_ERR_RANGE, amst_mesh_get_chord(mesh, base - 1, NULL, NULL, out, 6, &needed));
        assert_error_names(AMST_EDGE, base - 1);
        refused(AMST_ERR_ARGUMENT, amst_mesh_get_chords(mesh, 99, NULL, NULL, 0, &needed));
        refused(AMST_ERR_ARGUMENT, amst_mesh_get_chords(mesh, -1, NULL, NULL, 0, &needed));
        free(ids);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

static void the_boundary_is_the_callers(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 5, 3);
    amst_options *options = NULL;
    amst_report *report = NULL;
    int64_t n, *reasons = property(mesh, AMST_CHORD_REFUSAL, NULL, &n);
    const int64_t before = checksum(mesh);
    assert_int_equal(n, 8);
    for (int64_t i = 0; i < n; ++i)
        assert_int_equal(reasons[i], AMST_REFUSAL_BOUNDARY);
    free(reasons);
    refused(AMST_ERR_CHORD, amst_collapse_chord(mesh, 0, NULL, &report));
    assert_non_null(strstr(amst_last_error(), "boundary"));
    refused(AMST_ERR_CHORD, amst_split_chord(mesh, 0, 1, NULL, &report));
    assert_null(report);
    assert_true(checksum(mesh) == before);
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    must(amst_split_chord(mesh, 0, 2, options, &report));
    must(amst_mesh_check(mesh));
    assert_int_equal(count_of(mesh, AMST_FACE), 21);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_BEFORE), 15);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_AFTER), 21);
    amst_id *origin = origin_of(report, AMST_FACE); /* pieces are new, the other faces are what they were */
    for (int f = 0; f < 21; ++f)
        assert_int_equal(origin[f], f < 15 && f % 5 != 0 ? f : -1);
    free(origin);
    amst_report_destroy(report);
    must(amst_collapse_chord(mesh, column(mesh), options, NULL));
    must(amst_collapse_chord(mesh, column(mesh), options, NULL));
    must(amst_mesh_check(mesh));
    assert_int_equal(count_of(mesh, AMST_FACE), 15);
    assert_int_equal(count_of(mesh, AMST_VERTEX), 24);
    amst_options_destroy(options);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void rings_in_and_out_again(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 8, 8);
    amst_patches *set = NULL;
    amst_report *report = NULL;
    int64_t first, length, after;
    const int64_t digest = checksum(mesh);
    double values[64];
    for (int f = 0; f < 64; ++f)
        values[f] = f;
    must(amst_mesh_set_field(mesh, AMST_FACE, "load", 1, AMST_CARRY_CONSERVE, values, 64));
    must(amst_mesh_mark(mesh, &first));
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 8, 2, 6);
    must(amst_insert_chords(mesh, set, 3, NULL, &report));
    must(amst_mesh_check(mesh));
    assert_int_equal(count_of(mesh, AMST_FACE), 64 + 3 * 16);
    assert_int_equal(result(report, 0, AMST_RESULT_FACES_AFTER), 16 + 3 * 16);
    assert_int_equal(n_singular(mesh), 8);
    amst_report_destroy(report);
    for (int ring = 3; ring > 0; --ring) {
        const amst_id edge = free_ring(mesh, &length, &after);
        assert_true(edge >= 0);
        assert_int_equal(length, 16);
        assert_int_equal(after, ring > 1 ? 8 : 0);
        must(amst_collapse_chord(mesh, edge, NULL, NULL));
        must(amst_mesh_check(mesh));
        assert_int_equal(n_singular(mesh), after);
        int64_t needed;
        double load[200], sum = 0, area[200];
        must(amst_mesh_get_field(mesh, AMST_FACE, "load", load, 200, &needed));
        must(amst_mesh_get_quality(mesh, AMST_METRIC_AREA, area, 200, &needed));
        for (int64_t f = 0; f < needed; ++f)
            sum += load[f] * area[f];
        assert_true(sum > 2015.99 && sum < 2016.01);
    }
    assert_int_equal(count_of(mesh, AMST_FACE), 64);
    must(amst_mesh_rollback(mesh, first));
    assert_true(checksum(mesh) == digest);
    refused(AMST_ERR_STALE, amst_patches_add_rings(set, 0, 1, NULL)); /* it went along with the rings */
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void patches_that_do_not_fit_are_left(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 8, 8);
    amst_patches *set = NULL;
    amst_report *report = NULL;
    const amst_id angle[] = {18, 19, 20, 26, 27, 28, 34}; /* seven faces with a concave corner */
    const int64_t before = checksum(mesh);
    must(amst_patches_create(mesh, NULL, &set));
    must(amst_patches_add_faces(set, angle, 7, NULL));
    assert_int_equal(amst_insert_chords(mesh, set, 1, NULL, &report), AMST_PARTIAL);
    assert_int_equal(result(report, 0, AMST_RESULT_STATUS), AMST_ERR_PATCH);
    assert_true(checksum(mesh) == before);
    amst_report_destroy(report);
    refused(AMST_ERR_RANGE, amst_insert_chords(mesh, set, 0, NULL, NULL));
    refused(AMST_ERR_RANGE, amst_insert_chords(mesh, set, INT32_MAX, NULL, NULL));
    refused(AMST_ERR_RANGE, amst_split_chord(mesh, 0, 0, NULL, NULL));
    refused(AMST_ERR_RANGE, amst_split_chord(mesh, 999, 1, NULL, NULL));
    refused(AMST_ERR_RANGE, amst_collapse_chord(mesh, -1, NULL, NULL));
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void a_split_may_not_outgrow_the_ids(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 4, 4);
    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    refused(AMST_ERR_RANGE, amst_split_chord(mesh, 0, INT32_MAX, options, NULL));
    amst_options_destroy(options);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void whole_meshes_adapt_by_chords(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 12, 12);
    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_STRATEGY, 1));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    must(amst_adapt(mesh, NULL, 0.5, options, NULL));
    must(amst_mesh_check(mesh));
    assert_int_equal(count_of(mesh, AMST_FACE), 72);
    assert_int_equal(n_singular(mesh), 0);
    assert_int_equal(amst_adapt(mesh, NULL, 1.3, options, NULL), AMST_PARTIAL);
    must(amst_mesh_check(mesh));
    assert_true(count_of(mesh, AMST_FACE) > 80 && count_of(mesh, AMST_FACE) <= 94);
    refused(AMST_ERR_RANGE, amst_options_set_int(options, AMST_OPT_STRATEGY, 2));
    amst_options_destroy(options);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(queries_in_both_bases),           cmocka_unit_test(the_boundary_is_the_callers),
        cmocka_unit_test(rings_in_and_out_again),          cmocka_unit_test(patches_that_do_not_fit_are_left),
        cmocka_unit_test(a_split_may_not_outgrow_the_ids), cmocka_unit_test(whole_meshes_adapt_by_chords),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
