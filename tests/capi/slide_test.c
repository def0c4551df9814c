/* Vertices on FEATURE edges of a curved mesh slide along them. */
#include <math.h>

#include "grid.h"

enum { n = 6, side = n + 1, most = side * side * side };

/* A box of edges 1, 2 and 3: vertices bunched at one corner, those inside of its sides pushed about. */
typedef struct box {
    amst_context *ctx;
    amst_mesh *mesh;
    int64_t n_points, n_features;
    int number[most][3]; /* [vertex] 0..n, where it is in the box */
} box;

static int ends(const int number[3]) {
    int on = 0;
    for (int k = 0; k < 3; ++k)
        on += number[k] == 0 || number[k] == n;
    return on;
}

static double place(const int number[3], int axis, unsigned *random) {
    const int i = number[axis];
    double x = (double)i / n;
    if (i > 0 && i < n && ends(number) == 1) {
        *random = *random * 1103515245u + 12345u;
        x += 0.6 / n * ((*random >> 16 & 1023) / 1023.0 - 0.5);
    }
    return (axis + 1) * x * x;
}

static void add_side(int axis, int end, const int *ids, int32_t *faces, int64_t *n_faces) {
    const int step[3] = {1, side, side * side};
    const int base = end * n * step[axis], u = step[(axis + 1) % 3], v = step[(axis + 2) % 3];
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const int corner = base + i * u + j * v;
            int32_t *face = faces + 4 * (*n_faces)++;
            face[0] = ids[corner];
            face[end ? 1 : 3] = ids[corner + u];
            face[2] = ids[corner + u + v];
            face[end ? 3 : 1] = ids[corner + v];
        }
}

static box new_box(int32_t threads) {
    box made;
    int ids[most];
    double points[3 * most];
    int32_t faces[4 * 6 * n * n];
    unsigned random = 7;
    int64_t n_faces = 0;
    made.n_points = 0;
    for (int i = 0; i < most; ++i) {
        const int number[3] = {i % side, i / side % side, i / (side * side)};
        if (ends(number) == 0)
            continue;
        memcpy(made.number[made.n_points], number, sizeof number);
        for (int k = 0; k < 3; ++k)
            points[3 * made.n_points + k] = place(number, k, &random);
        ids[i] = (int)made.n_points++;
    }
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            add_side(axis, end, ids, faces, &n_faces);
    made.ctx = new_context(0);
    must(amst_context_set_threads(made.ctx, threads));
    must(amst_mesh_create(made.ctx, 3, points, made.n_points, 0, 0, faces, n_faces, 0, 0, 4, NULL,
                          &made.mesh));
    must(amst_mesh_detect_features(made.mesh, 40, &made.n_features));
    assert_int_equal(made.n_features, 12 * n);
    return made;
}

static void free_box(box *made) {
    amst_mesh_destroy(made->mesh);
    amst_context_destroy(made->ctx);
}

static int64_t count_features(const amst_mesh *mesh) {
    int64_t needed, found = 0;
    must(amst_mesh_get_flags(mesh, AMST_EDGE, NULL, 0, &needed));
    int32_t *flags = memory(sizeof(int32_t) * (size_t)needed);
    must(amst_mesh_get_flags(mesh, AMST_EDGE, flags, needed, &needed));
    for (int64_t e = 0; e < needed; ++e)
        found += (flags[e] & AMST_FLAG_FEATURE) != 0;
    free(flags);
    return found;
}

/* Farthest that a vertex on an edge of the box is from where it would be if all were even. */
static double unevenness(const box *asked) {
    double *points = points_of(asked->mesh), far = 0;
    for (int64_t v = 0; v < asked->n_points; ++v)
        for (int k = 0; k < 3; ++k)
            if (ends(asked->number[v]) == 2)
                far = fmax(far, fabs(points[3 * v + k] / (k + 1) - (double)asked->number[v][k] / n));
    free(points);
    return far;
}

/* The sides are along the axes, so that nothing is rounded: what is on an edge is so to the last bit. */
static void assert_on_edges(const box *asked, const double *before) {
    double *points = points_of(asked->mesh);
    for (int64_t v = 0; v < asked->n_points; ++v) {
        const int *number = asked->number[v];
        if (ends(number) == 3)
            assert_memory_equal(points + 3 * v, before + 3 * v, 3 * sizeof(double));
        for (int k = 0; ends(number) >= 2 && k < 3; ++k)
            if (number[k] == 0 || number[k] == n)
                assert_true(points[3 * v + k] == before[3 * v + k]);
            else
                assert_true(points[3 * v + k] > 0 && points[3 * v + k] < k + 1);
    }
    assert_int_equal(count_features(asked->mesh), asked->n_features);
    free(points);
}

static void smoothing_spreads_vertices_along_features(void **state) {
    (void)state;
    box b = new_box(1);
    double *before = points_of(b.mesh);
    const double quality = worst_scaled_jacobian(b.mesh);
    assert_true(unevenness(&b) > 0.24);
    for (int i = 0; i < 3; ++i) {
        must(amst_smooth(b.mesh, NULL, NULL, NULL));
        assert_on_edges(&b, before);
    }
    assert_true(unevenness(&b) < 0.02);
    assert_true(worst_scaled_jacobian(b.mesh) > quality);
    assert_int_equal(revision(b.mesh), 0);
    free(before);
    free_box(&b);
}

static void what_is_fixed_or_flagged_otherwise_stays(void **state) {
    (void)state;
    const int32_t flags[] = {AMST_FLAG_FIXED, AMST_FLAG_CORNER, AMST_FLAG_FEATURE};
    for (size_t f = 0; f < 3; ++f) {
        box b = new_box(1);
        double *before = points_of(b.mesh);
        must(amst_mesh_set_flags(b.mesh, AMST_VERTEX, NULL, 0, flags[f], flags[f]));
        for (amst_id v = 0; v < b.n_points; ++v) /* those inside move */
            if (ends(b.number[v]) == 1)
                must(amst_mesh_set_flags(b.mesh, AMST_VERTEX, &v, 1, 7, 0));
        must(amst_smooth(b.mesh, NULL, NULL, NULL));
        double *points = points_of(b.mesh);
        int moved = 0;
        for (int64_t v = 0; v < b.n_points; ++v)
            moved +=
                ends(b.number[v]) == 2 && memcmp(points + 3 * v, before + 3 * v, 3 * sizeof(double)) != 0;
        assert_true(flags[f] == AMST_FLAG_FEATURE ? moved > 6 * (n - 1) : moved == 0);
        free(before);
        free(points);
        free_box(&b);
    }
}

static void the_result_is_the_same_for_any_number_of_threads_and_after_undoing(void **state) {
    (void)state;
    int64_t smoothed[3], adapted[3];
    const int32_t threads[] = {1, 2, 4};
    for (int i = 0; i < 3; ++i) {
        box b = new_box(threads[i]);
        int64_t mark;
        must(amst_mesh_mark(b.mesh, &mark));
        must(amst_smooth(b.mesh, NULL, NULL, NULL));
        smoothed[i] = checksum(b.mesh);
        must(amst_mesh_rollback(b.mesh, mark));
        must(amst_smooth(b.mesh, NULL, NULL, NULL));
        assert_true(checksum(b.mesh) == smoothed[i]);
        assert_true(amst_adapt(b.mesh, NULL, 1.3, NULL, NULL) >= 0);
        adapted[i] = checksum(b.mesh);
        free_box(&b);
    }
    for (int i = 1; i < 3; ++i) {
        assert_true(smoothed[i] == smoothed[0]);
        assert_true(adapted[i] == adapted[0]);
    }
}

/* A ring whose section is a square of edge 1: four sharp circles of 48 edges. */
enum { around = 48, across = 4, ring_points = around * 4 * across };

static amst_mesh *new_ring(amst_context *ctx) {
    double *points = memory(3 * ring_points * sizeof(double));
    int32_t *faces = memory(4 * ring_points * sizeof(int32_t));
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < 4 * across; ++j) {
            const double angle = 2 * acos(-1) * i / around, step = (double)(j % across) / across;
            const double x[] = {step, 1, 1 - step, 0}, z[] = {0, step, 1, 1 - step};
            double *p = points + 3 * (i * 4 * across + j);
            p[0] = (3 + x[j / across]) * cos(angle);
            p[1] = (3 + x[j / across]) * sin(angle);
            p[2] = z[j / across];
            int32_t *face = faces + 4 * (i * 4 * across + j);
            const int next = (i + 1) % around, up = (j + 1) % (4 * across);
            face[0] = i * 4 * across + j;
            face[1] = next * 4 * across + j;
            face[2] = next * 4 * across + up;
            face[3] = i * 4 * across + up;
        }
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 3, points, ring_points, 0, 0, faces, ring_points, 0, 0, 4, NULL, &mesh));
    int64_t n_features;
    must(amst_mesh_detect_features(mesh, 40, &n_features));
    assert_int_equal(n_features, 4 * around);
    free(points);
    free(faces);
    return mesh;
}

/* How far the vertices of features are from the circles' polygons of the beginning, at most. */
static double off_polygons(const amst_mesh *mesh) {
    int64_t n_edges, needed;
    must(amst_mesh_get_count(mesh, AMST_EDGE, &n_edges));
    amst_id *edges = memory(2 * (size_t)n_edges * sizeof(amst_id));
    int32_t *flags = memory((size_t)n_edges * sizeof(int32_t));
    must(amst_mesh_get_edges(mesh, edges, 2 * n_edges, &needed));
    must(amst_mesh_get_flags(mesh, AMST_EDGE, flags, n_edges, &needed));
    double *points = points_of(mesh), far = 0;
    const double half = acos(-1) / around;
    for (int64_t k = 0; k < 2 * n_edges; ++k) {
        if ((flags[k / 2] & AMST_FLAG_FEATURE) == 0)
            continue;
        const double *p = points + 3 * edges[k];
        double angle = fmod(atan2(p[1], p[0]) + 4 * acos(-1), 2 * half);
        const double apothem = hypot(p[0], p[1]) * cos(angle - half) / cos(half); /* radius, if on an edge */
        far = fmax(far, fmin(fabs(apothem - 3), fabs(apothem - 4)));
        far = fmax(far, fmin(fabs(p[2]), fabs(p[2] - 1)));
    }
    free(points);
    free(edges);
    free(flags);
    return far;
}

static void features_are_coarsened_and_refined_on_their_curve(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_ring(ctx);
    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    int64_t faces;
    const double alphas[] = {0.5, 0.5, 4};
    const int64_t wanted[] = {ring_points / 2, ring_points / 4, ring_points};
    for (int i = 0; i < 3; ++i) {
        assert_int_equal(amst_adapt(mesh, NULL, alphas[i], options, NULL), AMST_OK);
        must(amst_mesh_get_count(mesh, AMST_FACE, &faces));
        assert_int_equal(faces, wanted[i]);
        assert_true(off_polygons(mesh) < 1e-9);
        assert_true(worst_scaled_jacobian(mesh) > 0.3);
    }
    assert_true(count_features(mesh) > 4 * around / 2);
    amst_options_destroy(options);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(smoothing_spreads_vertices_along_features),
        cmocka_unit_test(features_are_coarsened_and_refined_on_their_curve),
        cmocka_unit_test(what_is_fixed_or_flagged_otherwise_stays),
        cmocka_unit_test(the_result_is_the_same_for_any_number_of_threads_and_after_undoing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
