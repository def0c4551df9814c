// The module alphamst._alphamst: every function of alphamst.h under its own name, with its arguments in its
// order. The package beside it makes them Python's.
#include "call.hpp"
#include "callback.hpp"

namespace {

PyObject *status_name(PyObject *, PyObject *status) {
    int32_t value = 0;
    return from_python(status, value) ? PyUnicode_FromString(amst_status_name(value)) : nullptr;
}

PyObject *has(PyObject *, PyObject *feature) {
    const char *name = PyUnicode_AsUTF8AndSize(feature, nullptr);
    return name == nullptr ? nullptr : PyLong_FromLong(amst_has(name));
}

PyObject *version(PyObject *, PyObject *) { return PyLong_FromLong(amst_version()); }
PyObject *version_string(PyObject *, PyObject *) { return PyUnicode_FromString(amst_version_string()); }

// The only output without a capacity; it has one element for each pair.
amst_status find_edges(const amst_mesh *mesh, const amst_id *pairs, int64_t n, amst_id *out,
                       int64_t capacity) {
    return amst_mesh_find_edges(mesh, pairs, capacity < n ? capacity : n, out);
}

// Without room for an offset of each vertex, and one more, only what is needed is told.
amst_status get_vertex_faces(const amst_mesh *mesh, int32_t *offsets, int64_t room, amst_id *out,
                             int64_t capacity, int64_t *needed) {
    int64_t n_vertices = 0;
    const amst_status status = amst_mesh_get_count(mesh, AMST_VERTEX, &n_vertices);
    if (status != AMST_OK)
        return status;
    if (room <= n_vertices)
        return amst_mesh_get_vertex_faces(mesh, nullptr, nullptr, 0, needed);
    return amst_mesh_get_vertex_faces(mesh, offsets, out, capacity, needed);
}

// Where room is lacking only the rows needed are told: asking would cost as much as the answer.
amst_status get_overlap(const amst_mesh *before, const amst_mesh *after, amst_id *before_faces,
                        int64_t capacity, amst_id *after_faces, int64_t, double *areas, int64_t,
                        int64_t *needed) {
    const amst_status status =
        amst_mesh_get_overlap(before, after, before_faces, after_faces, areas, capacity, needed);
    return status == AMST_ERR_BUFFER_TOO_SMALL ? AMST_OK : status;
}

template <auto function, Way way> constexpr PyMethodDef method(const char *name) {
    return {name, reinterpret_cast<PyCFunction>(reinterpret_cast<void *>(&Function<function, way>::call)),
            METH_FASTCALL, nullptr};
}
PyMethodDef method(const char *name, PyObject *(*function)(PyObject *, PyObject *const *, Py_ssize_t)) {
    return {name, reinterpret_cast<PyCFunction>(reinterpret_cast<void *>(function)), METH_FASTCALL, nullptr};
}

#define QUICK(name) method<name, Way::quick>(#name)
#define SLOW(name) method<name, Way::slow>(#name)
#define FREE(name) method<name, Way::free>(#name)

PyMethodDef methods[] = {{"set_failure", set_failure, METH_O, nullptr},
                         {"amst_version", version, METH_NOARGS, nullptr},
                         {"amst_version_string", version_string, METH_NOARGS, nullptr},
                         {"amst_has", has, METH_O, nullptr},
                         {"amst_status_name", status_name, METH_O, nullptr},

                         QUICK(amst_context_create),
                         QUICK(amst_context_set_threads),
                         method("amst_context_set_log", set_log),
                         method("amst_context_set_progress", set_progress),
                         FREE(amst_context_set_cancel),
                         FREE(amst_context_get_progress),

                         QUICK(amst_options_create),
                         QUICK(amst_options_set_int),
                         QUICK(amst_options_set_real),
                         QUICK(amst_options_get_int),
                         QUICK(amst_options_get_real),
                         QUICK(amst_options_set_edges),
                         QUICK(amst_options_get_edges),

                         SLOW(amst_mesh_create),
                         SLOW(amst_mesh_create_i64),
                         SLOW(amst_mesh_read),
                         SLOW(amst_mesh_write),
                         SLOW(amst_mesh_clone),
                         SLOW(amst_mesh_clone_into),
                         QUICK(amst_mesh_get_dim),
                         QUICK(amst_mesh_get_count),
                         QUICK(amst_mesh_get_revision),
                         QUICK(amst_mesh_get_points),
                         QUICK(amst_mesh_set_points),
                         QUICK(amst_mesh_get_faces),
                         QUICK(amst_mesh_get_edges),
                         QUICK(amst_mesh_get_edge_faces),
                         method<get_vertex_faces, Way::quick>("amst_mesh_get_vertex_faces"),
                         QUICK(amst_mesh_get_geometry),
                         method<find_edges, Way::quick>("amst_mesh_find_edges"),
                         QUICK(amst_mesh_get_crossed_edges),
                         QUICK(amst_mesh_get_split_edges),
                         QUICK(amst_mesh_get_valences),
                         QUICK(amst_mesh_get_singularities),
                         SLOW(amst_mesh_check),
                         SLOW(amst_mesh_get_checksum),

                         QUICK(amst_mesh_set_flags),
                         QUICK(amst_mesh_get_flags),
                         SLOW(amst_mesh_detect_features),
                         QUICK(amst_mesh_set_markers),
                         QUICK(amst_mesh_get_markers),
                         QUICK(amst_mesh_get_marker_list),
                         QUICK(amst_mesh_set_marker_name),
                         QUICK(amst_mesh_get_marker_name),

                         QUICK(amst_mesh_set_field),
                         QUICK(amst_mesh_get_field),
                         QUICK(amst_mesh_remove_field),
                         SLOW(amst_mesh_size_from_indicator),
                         method<get_overlap, Way::slow>("amst_mesh_get_overlap"),
                         SLOW(amst_mesh_compute_cross_field),
                         SLOW(amst_mesh_get_alignment),
                         SLOW(amst_mesh_set_surface),
                         method("amst_mesh_set_projection", set_projection),

                         QUICK(amst_mesh_mark),
                         SLOW(amst_mesh_rollback),
                         QUICK(amst_mesh_forget),

                         SLOW(amst_patches_create),
                         SLOW(amst_patches_add_faces),
                         SLOW(amst_patches_add_rings),
                         SLOW(amst_patches_add_ball),
                         SLOW(amst_patches_add_box),
                         SLOW(amst_patches_decompose),
                         QUICK(amst_patches_set_corners),
                         QUICK(amst_patches_set_alpha),
                         QUICK(amst_patches_get_count),
                         QUICK(amst_patches_get_faces),
                         QUICK(amst_patches_get_boundary),
                         QUICK(amst_patches_get_corners),
                         QUICK(amst_patches_check),
                         SLOW(amst_patches_write),
                         SLOW(amst_patches_predict),

                         SLOW(amst_adapt),
                         SLOW(amst_reduce_singularities),
                         SLOW(amst_smooth),
                         SLOW(amst_clean),

                         SLOW(amst_mesh_get_chord),
                         SLOW(amst_mesh_get_chord_ids),
                         SLOW(amst_mesh_get_chords),
                         SLOW(amst_collapse_chord),
                         SLOW(amst_split_chord),
                         SLOW(amst_insert_chords),

                         SLOW(amst_mesh_get_quality),
                         SLOW(amst_mesh_get_summary),

                         QUICK(amst_report_get_int),
                         QUICK(amst_report_get_real),
                         QUICK(amst_report_get_valence),
                         QUICK(amst_report_get_origin),
                         {nullptr, nullptr, 0, nullptr}};

PyModuleDef definition = {PyModuleDef_HEAD_INIT,
                          "_alphamst",
                          "The functions of alphamst.h, as they are.",
                          -1,
                          methods,
                          nullptr,
                          nullptr,
                          nullptr,
                          nullptr};

} // namespace

PyMODINIT_FUNC PyInit__alphamst() {
    if (!make_handle_type())
        return nullptr;
    PyObject *module = PyModule_Create(&definition);
    if (module != nullptr && PyModule_AddObjectRef(module, "Handle", handle_type) == 0)
        return module;
    Py_XDECREF(module);
    return nullptr;
}
