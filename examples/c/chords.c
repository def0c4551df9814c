/* Chords: those of a plate with a hole in colour; two rings more around the hole, and one less.
 *
 *   build/release/examples/c/chords examples/data/plate.off [chords_] */
#include <stdlib.h>
#include <string.h>

#include "check.h"

/* The number of the chord of each edge; the caller frees it. */
static amst_id *chord_ids(const amst_mesh *mesh, int64_t *n_edges, int64_t *n_chords) {
    check(amst_mesh_get_count(mesh, AMST_EDGE, n_edges));
    amst_id *ids = malloc((size_t)*n_edges * sizeof *ids);
    check(amst_mesh_get_chord_ids(mesh, n_chords, ids, *n_edges, n_edges));
    return ids;
}

/* An edge of the shortest closed chord. */
static amst_id ring(const amst_mesh *mesh, int64_t *n_closed) {
    enum { most = 1000 };
    int64_t edges[most], closed[most], lengths[most], n = 0, best = -1;
    check(amst_mesh_get_chords(mesh, AMST_CHORD_EDGE, NULL, edges, most, &n));
    check(amst_mesh_get_chords(mesh, AMST_CHORD_CLOSED, NULL, closed, most, &n));
    check(amst_mesh_get_chords(mesh, AMST_CHORD_LENGTH, NULL, lengths, most, &n));
    *n_closed = 0;
    for (int64_t i = 0; i < n; ++i)
        if (closed[i]) {
            ++*n_closed;
            if (best < 0 || lengths[i] < lengths[best])
                best = i;
        }
    return best < 0 ? -1 : (amst_id)edges[best];
}

/* A row of the table and, if there is a prefix, a picture with the chords in colour. */
static void show(const char *what, amst_mesh *mesh, const char *prefix, const char *name) {
    int64_t faces = 0, n_edges = 0, n_chords = 0, n_closed = 0, needed = 0;
    amst_id *ids = chord_ids(mesh, &n_edges, &n_chords);
    check(amst_mesh_get_count(mesh, AMST_FACE, &faces));
    check(amst_mesh_get_singularities(mesh, NULL, 0, &needed));
    ring(mesh, &n_closed);
    printf("%-16s %6lld %9lld %7lld %7lld\n", what, (long long)faces, (long long)needed, (long long)n_chords,
           (long long)n_closed);
    if (prefix != NULL) {
        char path[1024];
        double *colours = malloc((size_t)n_edges * sizeof *colours);
        for (int64_t e = 0; e < n_edges; ++e)
            colours[e] = ids[e];
        check(amst_mesh_set_field(mesh, AMST_EDGE, "chord", 1, AMST_CARRY_DROP, colours, n_edges));
        snprintf(path, sizeof path, "%s%s.svg", prefix, name);
        check(amst_mesh_write(mesh, path));
        free(colours);
    }
    free(ids);
}

int main(int argc, char **argv) {
    amst_context *context = NULL;
    amst_mesh *mesh = NULL;
    int64_t n_closed = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: chords MESH [PREFIX]\n");
        return 2;
    }
    const char *prefix = argc > 2 ? argv[2] : NULL;
    check(amst_context_create(0, &context));
    check(amst_mesh_read(context, argv[1], NULL, &mesh));
    printf("%-16s %6s %9s %7s %7s\n", "mesh", "faces", "singular", "chords", "closed");
    show("read", mesh, prefix, "read");
    check(amst_split_chord(mesh, ring(mesh, &n_closed), 2, NULL, NULL));
    show("two rings in", mesh, prefix, "in");
    check(amst_collapse_chord(mesh, ring(mesh, &n_closed), NULL, NULL));
    show("one ring out", mesh, prefix, "out");
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
    return 0;
}
