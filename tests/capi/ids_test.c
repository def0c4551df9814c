/* Index base 0 and 1 give the same answers, ids differing by exactly one. */
#include "grid.h"

typedef struct world {
    amst_context *ctx;
    amst_mesh *mesh;
    amst_patches *set;
    amst_report *report;
} world;

static world new_world(int32_t base) {
    world w = {0};
    const double low[3] = {2, 2, 0}, high[3] = {7, 7, 0};
    const amst_id held = base + 3, pair[2] = {base + 50, base + 51};
    amst_id edge = -7, patch = -7;
    w.ctx = new_context(base);
    w.mesh = new_grid(w.ctx, base, 10, 10);
    must(amst_mesh_find_edges(w.mesh, pair, 1, &edge));
    must(amst_mesh_set_flags(w.mesh, AMST_FACE, &held, 1, AMST_FLAG_FIXED, AMST_FLAG_FIXED));
    must(amst_patches_create(w.mesh, NULL, &w.set));
    must(amst_patches_add_box(w.set, low, high, &patch));
    assert_int_equal(patch, base);
    must(amst_patches_add_rings(w.set, base + 9 * 11 + 8, 1, &patch));
    assert_int_equal(patch, base + 1);
    assert_true(amst_adapt(w.mesh, w.set, 2, NULL, &w.report) >= 0); /* four faces may be too few */
    assert_int_equal(result(w.report, base, AMST_RESULT_STATUS), AMST_OK);
    return w;
}

static void end_world(world *w) {
    amst_report_destroy(w->report);
    amst_patches_destroy(w->set);
    amst_mesh_destroy(w->mesh);
    amst_context_destroy(w->ctx);
}

typedef amst_status (*getter)(const world *w, int32_t base, int32_t *out, int64_t capacity, int64_t *needed);

#define GETTER(name, call)                                                                                   \
    static amst_status name(const world *w, int32_t base, int32_t *out, int64_t capacity, int64_t *needed) { \
        (void)base;                                                                                          \
        return call;                                                                                         \
    }

GETTER(faces, amst_mesh_get_faces(w->mesh, out, capacity, needed))
GETTER(edges, amst_mesh_get_edges(w->mesh, out, capacity, needed))
GETTER(edge_faces, amst_mesh_get_edge_faces(w->mesh, out, capacity, needed))
GETTER(singularities, amst_mesh_get_singularities(w->mesh, out, capacity, needed))
GETTER(patch_faces, amst_patches_get_faces(w->set, base, out, capacity, needed))
GETTER(patch_boundary, amst_patches_get_boundary(w->set, base, out, capacity, needed))
GETTER(patch_corners, amst_patches_get_corners(w->set, base + 1, out, capacity, needed))
GETTER(vertex_origin, amst_report_get_origin(w->report, AMST_VERTEX, out, capacity, needed))
GETTER(edge_origin, amst_report_get_origin(w->report, AMST_EDGE, out, capacity, needed))
GETTER(face_origin, amst_report_get_origin(w->report, AMST_FACE, out, capacity, needed))
/* not ids: equal in both */
GETTER(valences, amst_mesh_get_valences(w->mesh, out, capacity, needed))
GETTER(face_flags, amst_mesh_get_flags(w->mesh, AMST_FACE, out, capacity, needed))

static void differ_by(const world *zero, const world *one, getter get, int32_t difference) {
    int64_t n = -1, m = -2;
    must(get(zero, 0, NULL, 0, &n));
    must(get(one, 1, NULL, 0, &m));
    assert_int_equal(n, m);
    int32_t *a = memory(sizeof(int32_t) * (size_t)n), *b = memory(sizeof(int32_t) * (size_t)n);
    must(get(zero, 0, a, n, &n));
    must(get(one, 1, b, n, &n));
    for (int64_t i = 0; i < n; ++i)
        assert_int_equal(b[i] - a[i], difference);
    free(a);
    free(b);
}

static void every_query(void **state) {
    (void)state;
    world zero = new_world(0), one = new_world(1);
    assert_true(checksum(zero.mesh) == checksum(one.mesh));
    const getter ids[] = {faces,          edges,         edge_faces,    singularities, patch_faces,
                          patch_boundary, patch_corners, vertex_origin, edge_origin,   face_origin};
    for (size_t k = 0; k < sizeof ids / sizeof *ids; ++k)
        differ_by(&zero, &one, ids[k], 1);
    differ_by(&zero, &one, valences, 0);
    differ_by(&zero, &one, face_flags, 0);
    end_world(&zero);
    end_world(&one);
}

static void none_is_one_below(void **state) {
    (void)state;
    for (int32_t base = 0; base <= 1; ++base) {
        amst_context *ctx = new_context(base);
        amst_mesh *mesh = new_grid(ctx, base, 2, 2);
        const amst_id diagonal[2] = {base, base + 4};
        amst_id edge = -7, sides[24];
        int64_t n;
        int none = 0;
        must(amst_mesh_find_edges(mesh, diagonal, 1, &edge));
        assert_int_equal(edge, base - 1);
        must(amst_mesh_get_edge_faces(mesh, sides, 24, &n));
        for (int i = 0; i < 24; ++i)
            none += sides[i] == base - 1;
        assert_int_equal(none, 8);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_query),
        cmocka_unit_test(none_is_one_below),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
