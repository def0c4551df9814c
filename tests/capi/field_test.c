/* Fields: what is kept of them, and what operations make of them. */
#include <math.h>

#include "grid.h"

enum { n = 10, row = n + 1, n_vertices = row * row, n_faces = n * n, n_edges = 2 * n * row };

static amst_context *ctx;
static amst_mesh *mesh;
static amst_patches *set;

static int setup(void **state) {
    (void)state;
    ctx = new_context(0);
    mesh = new_grid(ctx, 0, n, n);
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, n, 2, 7);
    return 0;
}

static int teardown(void **state) {
    (void)state;
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
    return 0;
}

static double *field_of(const amst_mesh *asked, int32_t entity, const char *name, int64_t *count) {
    must(amst_mesh_get_field(asked, entity, name, NULL, 0, count));
    double *values = memory(sizeof(double) * (size_t)*count);
    must(amst_mesh_get_field(asked, entity, name, values, *count, count));
    return values;
}

static void assert_field(const amst_mesh *asked, int32_t entity, const char *name, const double *values,
                         int64_t expected) {
    int64_t count;
    double *found = field_of(asked, entity, name, &count);
    assert_int_equal(count, expected);
    assert_memory_equal(found, values, sizeof(double) * (size_t)expected);
    free(found);
}

/* 1, 2, 3, ... */
static double *numbers(int64_t count) {
    double *values = memory(sizeof(double) * (size_t)count);
    for (int64_t i = 0; i < count; ++i)
        values[i] = (double)(i + 1);
    return values;
}

static void each_entity_has_fields_of_its_own(void **state) {
    (void)state;
    int64_t count;
    double *values = numbers(2 * n_edges), *others = numbers(n_edges);
    others[3] = -1e300;
    const int64_t digest = checksum(mesh), number = revision(mesh);
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "a", 1, AMST_CARRY_LINEAR, values, n_vertices));
    must(amst_mesh_set_field(mesh, AMST_EDGE, "a", 2, AMST_CARRY_INHERIT, values, n_edges));
    must(amst_mesh_set_field(mesh, AMST_FACE, "a", 1, AMST_CARRY_CONSERVE, values, n_faces));
    must(amst_mesh_set_field(mesh, AMST_FACE, "b", 1, AMST_CARRY_DROP, others, n_faces));
    assert_field(mesh, AMST_VERTEX, "a", values, n_vertices);
    assert_field(mesh, AMST_EDGE, "a", values, 2 * n_edges);
    assert_field(mesh, AMST_FACE, "a", values, n_faces);
    assert_field(mesh, AMST_FACE, "b", others, n_faces);
    must(amst_mesh_set_field(mesh, AMST_EDGE, "a", 1, AMST_CARRY_DROP, others, n_edges)); /* replaces */
    assert_field(mesh, AMST_EDGE, "a", others, n_edges);
    must(amst_mesh_remove_field(mesh, AMST_FACE, "a"));
    refused(AMST_ERR_NOT_FOUND, amst_mesh_get_field(mesh, AMST_FACE, "a", NULL, 0, &count));
    refused(AMST_ERR_NOT_FOUND, amst_mesh_remove_field(mesh, AMST_FACE, "a"));
    assert_string_equal(amst_last_error(), "there is no field \"a\" on faces");
    assert_field(mesh, AMST_VERTEX, "a", values, n_vertices);
    assert_field(mesh, AMST_FACE, "b", others, n_faces);
    assert_true(checksum(mesh) == digest);
    assert_int_equal(revision(mesh), number);
    free(values);
    free(others);
}

static void what_is_wrong_is_refused(void **state) {
    (void)state;
    double *values = numbers(n_edges);
    double *old = numbers(n_vertices);
    int64_t count = -7;
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "a", 1, AMST_CARRY_DROP, old, n_vertices));
#define no(status, entity, name, components, carry, count)                                                   \
    refused(status, amst_mesh_set_field(mesh, entity, name, components, carry, values, count))
    no(AMST_ERR_ARGUMENT, AMST_ENTITY_NONE, "a", 1, AMST_CARRY_DROP, n_vertices);
    no(AMST_ERR_ARGUMENT, 3, "a", 1, AMST_CARRY_DROP, n_vertices);
    no(AMST_ERR_ARGUMENT, AMST_VERTEX, "", 1, AMST_CARRY_DROP, n_vertices);
    no(AMST_ERR_ARGUMENT, AMST_VERTEX, "a", 1, AMST_CARRY_INVALID, n_vertices);
    no(AMST_ERR_ARGUMENT, AMST_VERTEX, "a", 1, 5, n_vertices);
    no(AMST_ERR_ARGUMENT, AMST_EDGE, "a", 1, AMST_CARRY_LINEAR, n_edges);
    no(AMST_ERR_ARGUMENT, AMST_FACE, "a", 1, AMST_CARRY_LINEAR, n_faces);
    no(AMST_ERR_ARGUMENT, AMST_EDGE, "a", 1, AMST_CARRY_CONSERVE, n_edges);
    no(AMST_ERR_ARGUMENT, AMST_EDGE, "a", 1, AMST_CARRY_AVERAGE, n_edges);
    assert_string_equal(amst_last_error(),
                        "AMST_CARRY_AVERAGE is for fields on faces or vertices, not on edges");
    no(AMST_ERR_RANGE, AMST_VERTEX, "a", 0, AMST_CARRY_DROP, n_vertices);
    no(AMST_ERR_RANGE, AMST_VERTEX, "a", -1, AMST_CARRY_DROP, n_vertices);
    no(AMST_ERR_RANGE, AMST_VERTEX, "a", 1, AMST_CARRY_DROP, n_vertices - 1);
    no(AMST_ERR_RANGE, AMST_VERTEX, "a", 1, AMST_CARRY_DROP, n_vertices + 1);
    no(AMST_ERR_RANGE, AMST_VERTEX, "a", 1, AMST_CARRY_DROP, -1);
    values[7] = NAN;
    no(AMST_ERR_NOT_FINITE, AMST_VERTEX, "a", 1, AMST_CARRY_DROP, n_vertices);
    assert_error_names(AMST_VERTEX, 7);
    values[7] = INFINITY;
    no(AMST_ERR_NOT_FINITE, AMST_EDGE, "a", 1, AMST_CARRY_DROP, n_edges);
    assert_error_names(AMST_EDGE, 7);
    no(AMST_ERR_NOT_FINITE, AMST_FACE, "a", 2, AMST_CARRY_DROP, n_faces);
    assert_error_names(AMST_FACE, 3);
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_field(mesh, 5, "a", NULL, 0, &count));
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_field(mesh, AMST_VERTEX, "", NULL, 0, &count));
    refused(AMST_ERR_NOT_FOUND, amst_mesh_get_field(mesh, AMST_VERTEX, "A", NULL, 0, &count));
    refused(AMST_ERR_ARGUMENT, amst_mesh_remove_field(mesh, 5, "a"));
    refused(AMST_ERR_ARGUMENT, amst_mesh_remove_field(mesh, AMST_VERTEX, ""));
    assert_int_equal(count, -7);
    assert_field(mesh, AMST_VERTEX, "a", old, n_vertices);
    free(values);
    free(old);
}

static void size_is_a_length_at_vertices(void **state) {
    (void)state;
    double *values = numbers(2 * n_edges); /* enough for two components */
    int64_t count;
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, values, n_vertices));
    no(AMST_ERR_ARGUMENT, AMST_FACE, "size", 1, AMST_CARRY_INHERIT, n_faces);
    no(AMST_ERR_ARGUMENT, AMST_EDGE, "size", 1, AMST_CARRY_INHERIT, n_edges);
    no(AMST_ERR_RANGE, AMST_VERTEX, "size", 2, AMST_CARRY_LINEAR, n_vertices);
    for (int i = 0; i < 2; ++i) {
        values[4] = i == 0 ? 0 : -0.5;
        no(AMST_ERR_RANGE, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, n_vertices);
        assert_error_names(AMST_VERTEX, 4);
    }
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "sizes", 1, AMST_CARRY_LINEAR, values, n_vertices));
    values[4] = NAN;
    no(AMST_ERR_NOT_FINITE, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, n_vertices);
    values[4] = 5;
    assert_field(mesh, AMST_VERTEX, "size", values, n_vertices);
    must(amst_mesh_remove_field(mesh, AMST_VERTEX, "size"));
    refused(AMST_ERR_NOT_FOUND, amst_mesh_get_field(mesh, AMST_VERTEX, "size", NULL, 0, &count));
    free(values);
}

static double linear(const double *p) { return 2 + 3 * p[0] - 0.25 * p[1]; }

static double total(const amst_mesh *asked, const char *name) {
    int64_t count, needed;
    double *values = field_of(asked, AMST_FACE, name, &count), sum = 0;
    double *areas = memory(sizeof(double) * (size_t)count);
    must(amst_mesh_get_quality(asked, AMST_METRIC_AREA, areas, count, &needed));
    for (int64_t f = 0; f < count; ++f)
        sum += values[f] * areas[f];
    free(values);
    free(areas);
    return sum;
}

static void set_every_rule(void) {
    double *values = numbers(n_edges), at_vertices[n_vertices], *points = points_of(mesh);
    for (int v = 0; v < n_vertices; ++v)
        at_vertices[v] = linear(points + 2 * v);
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "linear", 1, AMST_CARRY_LINEAR, at_vertices, n_vertices));
    must(amst_mesh_set_field(mesh, AMST_FACE, "mass", 1, AMST_CARRY_CONSERVE, values, n_faces));
    must(amst_mesh_set_field(mesh, AMST_EDGE, "label", 1, AMST_CARRY_INHERIT, values, n_edges));
    must(amst_mesh_set_field(mesh, AMST_FACE, "gone", 1, AMST_CARRY_DROP, values, n_faces));
    free(values);
    free(points);
}

/* Values of what stayed are the old ones, bit for bit. */
static void assert_kept(const amst_report *report, int32_t entity, const char *name, const double *before) {
    int64_t count;
    double *values = field_of(mesh, entity, name, &count);
    amst_id *origin = origin_of(report, entity);
    assert_int_equal(count, count_of(mesh, entity));
    for (int64_t i = 0; i < count; ++i)
        if (origin[i] != -1)
            assert_memory_equal(values + i, before + origin[i], sizeof(double));
    free(values);
    free(origin);
}

static void operations_carry(void **state) {
    (void)state;
    const double alphas[] = {2, 0.6, 1};
    set_every_rule();
    for (int i = 0; i < 3; ++i) {
        int64_t count;
        amst_report *report = NULL;
        if (i > 0) {
            amst_patches_destroy(set);
            must(amst_patches_create(mesh, NULL, &set));
            const double low[3] = {1, 1, 0}, high[3] = {6, 8, 0};
            must(amst_patches_add_box(set, low, high, NULL));
        }
        double *mass = field_of(mesh, AMST_FACE, "mass", &count);
        double *label = field_of(mesh, AMST_EDGE, "label", &count);
        const double before = total(mesh, "mass");
        assert_true(amst_adapt(mesh, set, alphas[i], NULL, &report) >= 0);
        assert_true(revision(mesh) > 0);
        assert_true(fabs(total(mesh, "mass") - before) <= 1e-12 * before);
        assert_kept(report, AMST_FACE, "mass", mass);
        assert_kept(report, AMST_EDGE, "label", label);
        double *values = field_of(mesh, AMST_VERTEX, "linear", &count), *points = points_of(mesh);
        assert_int_equal(count, count_of(mesh, AMST_VERTEX));
        for (int64_t v = 0; v < count; ++v)
            assert_true(fabs(values[v] - linear(points + 2 * v)) <= 1e-12);
        refused(AMST_ERR_NOT_FOUND, amst_mesh_get_field(mesh, AMST_FACE, "gone", NULL, 0, &count));
        free(mass);
        free(label);
        free(values);
        free(points);
        amst_report_destroy(report);
    }
}

/* The caller's own moves take values along; those of operations leave fields where they are. */
static void values_follow_vertices_that_move(void **state) {
    (void)state;
    int64_t count;
    double *points = points_of(mesh);
    points[2 * (5 * row + 5)] += 0.4;
    must(amst_mesh_set_points(mesh, points, n_vertices));
    set_every_rule();
    double *gone = field_of(mesh, AMST_FACE, "gone", &count);
    double *given = field_of(mesh, AMST_VERTEX, "linear", &count);
    points[2 * (5 * row + 5)] -= 0.1;
    must(amst_mesh_set_points(mesh, points, n_vertices));
    assert_field(mesh, AMST_VERTEX, "linear", given, n_vertices);
    points[2 * (5 * row + 5)] += 0.1;
    must(amst_mesh_set_points(mesh, points, n_vertices));
    const double before = total(mesh, "mass");
    must(amst_smooth(mesh, NULL, NULL, NULL));
    double *smoothed = points_of(mesh), *values = field_of(mesh, AMST_VERTEX, "linear", &count);
    int moved = 0;
    for (int v = 0; v < n_vertices; ++v) {
        assert_true(fabs(values[v] - linear(smoothed + 2 * v)) <= 1e-12);
        if (memcmp(smoothed + 2 * v, points + 2 * v, 2 * sizeof(double)) != 0)
            ++moved;
        else
            assert_memory_equal(values + v, given + v, sizeof(double));
    }
    assert_true(moved > 0 && values[5 * row + 5] != given[5 * row + 5]);
    assert_field(mesh, AMST_FACE, "gone", gone, n_faces);
    assert_true(fabs(total(mesh, "mass") - before) <= 1e-12 * before);
    free(gone);
    free(given);
    free(points);
    free(smoothed);
    free(values);
}

/* Of each vertex what the header says that it has: quarters of faces. */
static double *areas_of_vertices(void) {
    double *areas = memory(sizeof(double) * (size_t)count_of(mesh, AMST_VERTEX)), *points = points_of(mesh);
    amst_id *faces = faces_of(mesh);
    for (int64_t v = 0; v < count_of(mesh, AMST_VERTEX); ++v)
        areas[v] = 0;
    for (int64_t f = 0; f < count_of(mesh, AMST_FACE); ++f) {
        const amst_id *corners = faces + 4 * f;
        double centre[2] = {0, 0};
        for (int k = 0; k < 4; ++k)
            for (int c = 0; c < 2; ++c)
                centre[c] += points[2 * corners[k] + c] / 4;
        for (int k = 0; k < 4; ++k) {
            const double *here = points + 2 * corners[k], *next = points + 2 * corners[(k + 1) % 4],
                         *last = points + 2 * corners[(k + 3) % 4];
            const double out[2] = {centre[0] - here[0], centre[1] - here[1]},
                         across[2] = {(last[0] - next[0]) / 2, (last[1] - next[1]) / 2};
            areas[corners[k]] += (out[0] * across[1] - out[1] * across[0]) / 2;
        }
    }
    free(points);
    free(faces);
    return areas;
}

static double total_at_vertices(const char *name) {
    int64_t count;
    double *values = field_of(mesh, AMST_VERTEX, name, &count), *areas = areas_of_vertices(), sum = 0;
    for (int64_t v = 0; v < count; ++v)
        sum += values[v] * areas[v];
    free(values);
    free(areas);
    return sum;
}

static void vertices_conserve(void **state) {
    (void)state;
    double *values = numbers(n_vertices);
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "mass", 1, AMST_CARRY_CONSERVE, values, n_vertices));
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "plain", 1, AMST_CARRY_AVERAGE, values, n_vertices));
    const double before = total_at_vertices("mass");
    for (int i = 0; i < 3; ++i) {
        const amst_status status = i == 0   ? amst_adapt(mesh, set, 2, NULL, NULL)
                                   : i == 1 ? amst_smooth(mesh, NULL, NULL, NULL)
                                            : amst_adapt(mesh, NULL, 0.6, NULL, NULL);
        assert_true(status >= 0);
        assert_true(fabs(total_at_vertices("mass") - before) <= 1e-12 * before);
        assert_true(fabs(total_at_vertices("plain") - before) <= 1e-12 * before);
    }
    free(values);
}

static void savepoints_and_clones_have_theirs(void **state) {
    (void)state;
    int64_t mark, count;
    amst_mesh *clone = NULL;
    double *values = numbers(n_edges), *others = numbers(n_vertices);
    others[0] = -5;
    set_every_rule();
    must(amst_mesh_clone(mesh, &clone));
    must(amst_mesh_mark(mesh, &mark));
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "later", 1, AMST_CARRY_DROP, others, n_vertices));
    must(amst_mesh_remove_field(mesh, AMST_EDGE, "label"));
    must(amst_adapt(mesh, set, 2, NULL, NULL));
    refused(AMST_ERR_NOT_FOUND, amst_mesh_get_field(mesh, AMST_FACE, "gone", NULL, 0, &count));
    must(amst_mesh_rollback(mesh, mark));
    refused(AMST_ERR_NOT_FOUND, amst_mesh_get_field(mesh, AMST_VERTEX, "later", NULL, 0, &count));
    const amst_mesh *both[2] = {mesh, clone};
    for (int i = 0; i < 2; ++i) {
        assert_field(both[i], AMST_FACE, "gone", values, n_faces);
        assert_field(both[i], AMST_FACE, "mass", values, n_faces);
        assert_field(both[i], AMST_EDGE, "label", values, n_edges);
    }
    must(amst_mesh_set_field(clone, AMST_VERTEX, "linear", 1, AMST_CARRY_DROP, others, n_vertices));
    amst_mesh_destroy(mesh);
    mesh = NULL;
    assert_field(clone, AMST_VERTEX, "linear", others, n_vertices);
    amst_mesh_destroy(clone);
    free(values);
    free(others);
}

/* Refuses at the stage that carries fields, and tries to change them before. */
static int32_t stop_at_carry(void *user, double fraction, const char *stage) {
    const double one = 1;
    (void)fraction;
    refused(AMST_ERR_STATE,
            amst_mesh_set_field(mesh, AMST_VERTEX, "x", 1, AMST_CARRY_DROP, &one, n_vertices));
    refused(AMST_ERR_STATE, amst_mesh_remove_field(mesh, AMST_FACE, "gone"));
    if (strcmp(stage, "carry") != 0)
        return 0;
    return ++*(int *)user == 2;
}

static void cancelling_the_transfer_changes_nothing(void **state) {
    (void)state;
    int calls = 0;
    int64_t count;
    set_every_rule();
    const int64_t digest = checksum(mesh), number = revision(mesh);
    double *values = numbers(n_edges), *before = field_of(mesh, AMST_VERTEX, "linear", &count);
    must(amst_context_set_progress(ctx, stop_at_carry, &calls));
    refused(AMST_ERR_CANCELLED, amst_adapt(mesh, set, 2, NULL, NULL));
    assert_int_equal(calls, 2);
    assert_true(checksum(mesh) == digest);
    assert_int_equal(revision(mesh), number);
    assert_field(mesh, AMST_VERTEX, "linear", before, n_vertices);
    assert_field(mesh, AMST_FACE, "mass", values, n_faces);
    assert_field(mesh, AMST_FACE, "gone", values, n_faces);
    free(values);
    free(before);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(each_entity_has_fields_of_its_own, setup, teardown),
        cmocka_unit_test_setup_teardown(what_is_wrong_is_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(size_is_a_length_at_vertices, setup, teardown),
        cmocka_unit_test_setup_teardown(operations_carry, setup, teardown),
        cmocka_unit_test_setup_teardown(values_follow_vertices_that_move, setup, teardown),
        cmocka_unit_test_setup_teardown(vertices_conserve, setup, teardown),
        cmocka_unit_test_setup_teardown(savepoints_and_clones_have_theirs, setup, teardown),
        cmocka_unit_test_setup_teardown(cancelling_the_transfer_changes_nothing, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
