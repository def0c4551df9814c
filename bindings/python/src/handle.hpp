// The one type of the extension: a handle of the library, with what it needs as long as it lives.
#pragma once

// One build serves every Python from 3.11 on.
#define Py_LIMITED_API 0x030B0000
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include <alphamst/alphamst.h>

enum class Kind { none, context, options, mesh, patches, report };

template <class T> constexpr Kind kind_of = Kind::none;
template <> inline constexpr Kind kind_of<amst_context> = Kind::context;
template <> inline constexpr Kind kind_of<amst_options> = Kind::options;
template <> inline constexpr Kind kind_of<amst_mesh> = Kind::mesh;
template <> inline constexpr Kind kind_of<amst_patches> = Kind::patches;
template <> inline constexpr Kind kind_of<amst_report> = Kind::report;

struct Handle {
    PyObject_HEAD

        Kind kind;
    void *pointer;      // nullptr: not made yet, or closed
    Handle *parent;     // whose callbacks and data it uses: the context of a mesh, the mesh of patches
    PyObject *progress; // callbacks of a context, nullptr if none
    PyObject *log;
    PyObject *projection; // of a mesh: a function and the dim, as a tuple
    unsigned long worker; // the thread that changes it without the interpreter's lock, 0 if none
    int readers;          // calls that read it without the lock
};

extern PyObject *handle_type;
bool make_handle_type();

// The name of the object's class, a new reference.
PyObject *class_name(PyObject *object);

// What `create` has written becomes the empty handle's own; `parent` may be nullptr.
void fill(Handle *handle, Kind kind, void *pointer, Handle *parent);

// The open handle of that kind that `object` is, or nullptr with an exception.
Handle *open_handle(PyObject *object, Kind kind);
// Likewise one that nothing is in yet.
Handle *empty_handle(PyObject *object);
