#include "handle.hpp"

#include "use.hpp"

#include <cstddef>
#include <structmember.h>

PyObject *handle_type = nullptr;

namespace {

Handle *self_of(PyObject *self) { return reinterpret_cast<Handle *>(self); }

// The library lets handles be destroyed in any order and from any thread.
void destroy(Handle *handle) {
    void *pointer = handle->pointer;
    handle->pointer = nullptr;
    switch (handle->kind) {
    case Kind::none:
        break;
    case Kind::context:
        amst_context_destroy(static_cast<amst_context *>(pointer));
        break;
    case Kind::options:
        amst_options_destroy(static_cast<amst_options *>(pointer));
        break;
    case Kind::mesh:
        amst_mesh_destroy(static_cast<amst_mesh *>(pointer));
        break;
    case Kind::patches:
        amst_patches_destroy(static_cast<amst_patches *>(pointer));
        break;
    case Kind::report:
        amst_report_destroy(static_cast<amst_report *>(pointer));
        break;
    }
}

int traverse(PyObject *self, visitproc visit, void *arg) {
    Py_VISIT(Py_TYPE(self));
    Py_VISIT(self_of(self)->parent);
    Py_VISIT(self_of(self)->progress);
    Py_VISIT(self_of(self)->log);
    Py_VISIT(self_of(self)->projection);
    return 0;
}

int clear(PyObject *self) {
    Py_CLEAR(self_of(self)->parent);
    Py_CLEAR(self_of(self)->progress);
    Py_CLEAR(self_of(self)->log);
    Py_CLEAR(self_of(self)->projection);
    return 0;
}

void deallocate(PyObject *self) {
    PyObject_GC_UnTrack(self);
    PyTypeObject *type = Py_TYPE(self);
    destroy(self_of(self)); // before what its callbacks need
    clear(self);
    reinterpret_cast<freefunc>(PyType_GetSlot(type, Py_tp_free))(self);
    Py_DECREF(type);
}

PyObject *close(PyObject *self, PyObject *) {
    Uses uses;
    uses.add(self_of(self), true);
    if (!uses.allowed())
        return nullptr;
    destroy(self_of(self));
    Py_RETURN_NONE;
}

PyObject *closed(PyObject *self, void *) { return PyBool_FromLong(self_of(self)->pointer == nullptr); }

PyMethodDef methods[] = {{"close", close, METH_NOARGS, "End it now and not when it is collected."}, {}};
PyGetSetDef getters[] = {{"closed", closed, nullptr, "Whether it is closed.", nullptr}, {}};
PyMemberDef members[] = {{"parent", T_OBJECT, offsetof(Handle, parent), READONLY,
                          "Whose callbacks and data it uses: the context of a mesh, the mesh of patches."},
                         {}};

PyType_Slot slots[] = {{Py_tp_new, reinterpret_cast<void *>(PyType_GenericNew)},
                       {Py_tp_dealloc, reinterpret_cast<void *>(deallocate)},
                       {Py_tp_traverse, reinterpret_cast<void *>(traverse)},
                       {Py_tp_clear, reinterpret_cast<void *>(clear)},
                       {Py_tp_methods, methods},
                       {Py_tp_getset, getters},
                       {Py_tp_members, members},
                       {0, nullptr}};
PyType_Spec spec = {"alphamst._alphamst.Handle", sizeof(Handle), 0,
                    Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE | Py_TPFLAGS_HAVE_GC, slots};

} // namespace

bool make_handle_type() { return (handle_type = PyType_FromSpec(&spec)) != nullptr; }

PyObject *class_name(PyObject *object) { return PyType_GetName(Py_TYPE(object)); }

void fill(Handle *handle, Kind kind, void *pointer, Handle *parent) {
    handle->kind = kind;
    handle->pointer = pointer;
    handle->parent = parent;
    Py_XINCREF(reinterpret_cast<PyObject *>(parent));
}

Handle *open_handle(PyObject *object, Kind kind) {
    constexpr const char *names[] = {"", "Context", "Options", "Mesh", "Patches", "Report"};
    const char *wanted = names[static_cast<int>(kind)];
    Handle *handle = self_of(object);
    if (!PyObject_TypeCheck(object, reinterpret_cast<PyTypeObject *>(handle_type)) ||
        (handle->kind != kind && handle->kind != Kind::none)) {
        PyObject *name = class_name(object);
        PyErr_Format(PyExc_TypeError, "a %s is needed, not %U", wanted, name);
        Py_XDECREF(name);
        return nullptr;
    }
    if (handle->pointer == nullptr) // never passed on: NULL means "default" or "all" to some functions
        return PyErr_Format(PyExc_ValueError, "the %s is closed", wanted), nullptr;
    return handle;
}

Handle *empty_handle(PyObject *object) {
    if (PyObject_TypeCheck(object, reinterpret_cast<PyTypeObject *>(handle_type)) &&
        self_of(object)->kind == Kind::none)
        return self_of(object);
    PyErr_SetString(PyExc_TypeError, "an empty handle is needed");
    return nullptr;
}
