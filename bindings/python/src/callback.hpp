// Functions of Python that the library calls. They run on the thread of the call that they belong to.
#pragma once

#include "handle.hpp"

// amst_context_set_progress(context, fn), amst_context_set_log(context, level, fn) and
// amst_mesh_set_projection(mesh, fn, dim); fn None switches off.
PyObject *set_progress(PyObject *module, PyObject *const *given, Py_ssize_t n);
PyObject *set_log(PyObject *module, PyObject *const *given, Py_ssize_t n);
PyObject *set_projection(PyObject *module, PyObject *const *given, Py_ssize_t n);
