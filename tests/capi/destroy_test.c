/* Handles end in any order and on any thread; what is left still works. */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>

#include "grid.h"

typedef struct world {
    amst_context *ctx;
    amst_mesh *mesh;
    amst_patches *set;
    amst_report *report;
} world;

static world new_world(void) {
    world w = {0};
    w.ctx = new_context(0);
    w.mesh = new_grid(w.ctx, 0, 8, 8);
    must(amst_patches_create(w.mesh, NULL, &w.set));
    add_square(w.set, 8, 2, 6);
    must(amst_smooth(w.mesh, w.set, NULL, &w.report));
    return w;
}

static void end(world *w, int which) {
    switch (which) {
    case 0:
        amst_context_destroy(w->ctx);
        w->ctx = NULL;
        break;
    case 1:
        amst_mesh_destroy(w->mesh);
        w->mesh = NULL;
        break;
    case 2:
        amst_patches_destroy(w->set);
        w->set = NULL;
        break;
    default:
        amst_report_destroy(w->report);
        w->report = NULL;
    }
}

static void use_what_is_left(world *w) {
    int64_t n;
    int32_t defects;
    if (w->ctx != NULL)
        must(amst_context_set_threads(w->ctx, 1));
    if (w->mesh != NULL) {
        must(amst_mesh_check(w->mesh));
        must(amst_smooth(w->mesh, w->set, NULL, NULL));
    }
    if (w->set != NULL) {
        must(amst_patches_check(w->set, 0, &defects, NULL));
        must(amst_patches_get_boundary(w->set, 0, NULL, 0, &n));
        assert_int_equal(n, 16);
    }
    if (w->report != NULL)
        assert_int_equal(result(w->report, 0, AMST_RESULT_FACES_AFTER), 16);
}

static void *end_elsewhere(void *p) {
    const struct {
        world *w;
        int which;
    } *task = p;
    end(task->w, task->which);
    return NULL;
}

static void all_orders(int elsewhere) {
    for (int code = 0; code < 256; ++code) {
        const int order[4] = {code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6};
        if ((1 << order[0] | 1 << order[1] | 1 << order[2] | 1 << order[3]) != 15)
            continue;
        world w = new_world();
        for (int i = 0; i < 4; ++i) {
            if (elsewhere) {
                struct {
                    world *w;
                    int which;
                } task = {&w, order[i]};
                pthread_t thread;
                assert_int_equal(pthread_create(&thread, NULL, end_elsewhere, &task), 0);
                assert_int_equal(pthread_join(thread, NULL), 0);
            } else {
                end(&w, order[i]);
            }
            use_what_is_left(&w);
        }
    }
}

static void in_any_order(void **state) {
    (void)state;
    all_orders(0);
}

static void on_another_thread(void **state) {
    (void)state;
    all_orders(1);
}

/* One after the other on two threads at once: nothing is shared but counts. */
static void *end_half(void *p) {
    world *w = p;
    end(w, 0);
    end(w, 2);
    return NULL;
}

static void at_the_same_time(void **state) {
    (void)state;
    for (int i = 0; i < 50; ++i) {
        world w = new_world();
        pthread_t thread;
        assert_int_equal(pthread_create(&thread, NULL, end_half, &w), 0);
        end(&w, 1);
        end(&w, 3);
        assert_int_equal(pthread_join(thread, NULL), 0);
    }
}

/* Errors of one thread are not seen by another. */
static void *fail_there(void *p) {
    (void)p;
    if (amst_last_error()[0] != '\0')
        return p;
    return amst_mesh_check(NULL) == AMST_ERR_NULL ? NULL : p;
}

static void errors_stay_on_their_thread(void **state) {
    (void)state;
    pthread_t thread;
    void *failed = NULL;
    int here = 0;
    refused(AMST_ERR_NULL, amst_context_create(0, NULL));
    assert_int_equal(pthread_create(&thread, NULL, fail_there, &here), 0);
    assert_int_equal(pthread_join(thread, &failed), 0);
    assert_null(failed);
    assert_string_equal(amst_last_error(), "out is NULL");
}

/* Const calls may run together. */
static void *read_mesh(void *p) {
    const amst_mesh *mesh = p;
    int64_t digest = 0, n, failed = 0;
    double points[162];
    amst_summary summary;
    for (int i = 0; i < 20; ++i) {
        amst_mesh *copy = NULL;
        amst_patches *set = NULL;
        failed |= amst_mesh_get_checksum(mesh, &digest);
        failed |= amst_mesh_get_points(mesh, points, 162, &n);
        failed |= amst_mesh_get_singularities(mesh, NULL, 0, &n);
        failed |= amst_mesh_get_summary(mesh, AMST_METRIC_SHAPE, &summary);
        failed |= amst_mesh_check(mesh);
        failed |= amst_mesh_clone(mesh, &copy);
        failed |= amst_patches_create(mesh, NULL, &set);
        failed |= amst_patches_add_rings(set, 40, 2, NULL);
        amst_mesh_destroy(copy);
        amst_patches_destroy(set);
    }
    return failed ? p : NULL;
}

static void eight_threads_read_one_mesh(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 8, 8);
    pthread_t threads[8];
    for (int i = 0; i < 8; ++i)
        assert_int_equal(pthread_create(&threads[i], NULL, read_mesh, mesh), 0);
    for (int i = 0; i < 8; ++i) {
        void *failed = NULL;
        assert_int_equal(pthread_join(threads[i], &failed), 0);
        assert_null(failed);
    }
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_any_order),
        cmocka_unit_test(on_another_thread),
        cmocka_unit_test(at_the_same_time),
        cmocka_unit_test(errors_stay_on_their_thread),
        cmocka_unit_test(eight_threads_read_one_mesh),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
