// Chords: what they are, and operations on them.
#include <string>

#include "capi/array.h"
#include "capi/change.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/ids.h"
#include "capi/limits.h"
#include "chord/table.h"
#include "chords/edit.h"

namespace alphamst::capi {
namespace {

const mesh::QuadMesh &current(const amst_mesh *mesh) { return *required(mesh, "mesh").impl->current; }

std::int64_t value_of(const chord::Row &row, std::int32_t property, int base) {
    switch (property) {
    case AMST_CHORD_EDGE:
        return out(base, row.edge);
    case AMST_CHORD_CLOSED:
        return row.closed ? 1 : 0;
    case AMST_CHORD_LENGTH:
        return row.length;
    case AMST_CHORD_FACES:
        return row.length - row.crossings;
    case AMST_CHORD_CROSSINGS:
        return row.crossings;
    case AMST_CHORD_TOUCHES:
        return row.touches;
    case AMST_CHORD_SINGULARITIES:
        return row.singularities;
    case AMST_CHORD_REFUSAL:
        return row.reasons;
    default:
        return row.singular_after;
    }
}

// Faces get so many times longer than wide; beyond that no smoothing gives them a shape, in a long time.
constexpr std::int32_t most_copies = 1000;

void require_count(std::int32_t n) {
    if (n < 1 || n > most_copies)
        throw Failure(Fault::range, "n must be from 1 to " + std::to_string(most_copies) + ", it is " +
                                        std::to_string(n) + "; to refine more, call again");
}

int edge_in(const amst_mesh *mesh, amst_id edge) {
    return in(index_base(mesh), edge, current(mesh).n_edges(), Entity::edge);
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_get_chord(const amst_mesh *mesh, amst_id edge, std::int32_t *closed,
                                std::int64_t *crossings, amst_id *out, std::int64_t capacity,
                                std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const chord::Chord chord = chord::trace(current(mesh), edge_in(mesh, edge));
        const bool wanted = answer(out, capacity, needed, static_cast<std::int64_t>(chord.sides.size()));
        if (closed != nullptr)
            *closed = chord.closed ? 1 : 0;
        if (crossings != nullptr)
            *crossings = chord.crossings;
        if (wanted)
            for (const int side : chord.sides)
                *out++ = capi::out(index_base(mesh), side / 2);
    });
}

amst_status amst_mesh_get_chord_ids(const amst_mesh *mesh, std::int64_t *n_chords, amst_id *out,
                                    std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = current(mesh);
        const bool wanted = answer(out, capacity, needed, asked.n_edges());
        if (!wanted && n_chords == nullptr)
            return;
        const chord::Labels labels = chord::label(asked);
        if (n_chords != nullptr)
            *n_chords = static_cast<std::int64_t>(labels.first.size());
        if (wanted)
            for (const int number : labels.of_edge)
                *out++ = capi::out(index_base(mesh), number);
    });
}

amst_status amst_mesh_get_chords(const amst_mesh *mesh, std::int32_t property, const amst_options *options,
                                 std::int64_t *out, std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = current(mesh);
        if (property < AMST_CHORD_EDGE || property > AMST_CHORD_SINGULAR_AFTER)
            throw Failure(Fault::argument,
                          "there is no property of chords with number " + std::to_string(property));
        if (out == nullptr) {
            answer(out, capacity, needed, static_cast<std::int64_t>(chord::label(asked).first.size()));
            return;
        }
        const std::vector<chord::Row> rows = chord::table(asked, rules_of(options_of(options)));
        if (answer(out, capacity, needed, static_cast<std::int64_t>(rows.size())))
            for (const chord::Row &row : rows)
                *out++ = value_of(row, property, index_base(mesh));
    });
}

amst_status amst_collapse_chord(amst_mesh *mesh, amst_id edge, const amst_options *options,
                                amst_report **report) {
    return guarded(index_base(mesh), [&] {
        const int index = edge_in(mesh, edge);
        const Options chosen = options_of(options);
        Change change("collapse_chord", *mesh, nullptr);
        const Settings settings = change.settings(chosen);
        return change.finish(
            {chords::collapse_chord(change.mesh(), index, rules_of(chosen), settings, change.progress())},
            true, {AMST_OPT_EDIT_BOUNDARY, AMST_OPT_SIZE_WEIGHT}, report);
    });
}

amst_status amst_split_chord(amst_mesh *mesh, amst_id edge, std::int32_t n, const amst_options *options,
                             amst_report **report) {
    return guarded(index_base(mesh), [&] {
        const int index = edge_in(mesh, edge);
        require_count(n);
        const Options chosen = options_of(options);
        Change change("split_chord", *mesh, nullptr);
        const Settings settings = change.settings(chosen);
        return change.finish({chords::split_chord(change.mesh(), index, n, max_faces, rules_of(chosen),
                                                  settings, change.progress())},
                             true, {AMST_OPT_EDIT_BOUNDARY, AMST_OPT_SIZE_WEIGHT}, report);
    });
}

amst_status amst_insert_chords(amst_mesh *mesh, amst_patches *patches, std::int32_t n,
                               const amst_options *options, amst_report **report) {
    return guarded(index_base(mesh), [&] {
        required(mesh, "mesh");
        required(patches, "patches");
        require_count(n);
        const Options chosen = options_of(options);
        Change change("insert_chords", *mesh, patches);
        std::int64_t most = change.mesh().n_faces(); // a patch has no more boundary edges than 4 a face
        for (const Patch &region : change.regions())
            most += 4 * static_cast<std::int64_t>(n) * static_cast<std::int64_t>(region.faces.size());
        if (most > max_faces)
            throw Failure(Fault::range, "n is " + std::to_string(n) +
                                            "; the mesh would have more faces than 32-bit ids can name");
        const Settings settings = change.settings(chosen);
        return change.finish(
            chords::insert_chords(change.mesh(), change.regions(), n, settings, change.progress()), true,
            {AMST_OPT_MIN_QUALITY, AMST_OPT_CHART}, report);
    });
}
