#include "failure.hpp"

#include <cstring>

namespace {

PyObject *make_failure = nullptr;

struct Kept {
    PyObject *type = nullptr;
    PyObject *value = nullptr;
    PyObject *traceback = nullptr;
};
thread_local Kept kept;

void raise(amst_status status, PyObject *text, int32_t entity, amst_id id, amst_id patch) {
    PyObject *failure =
        text == nullptr
            ? nullptr
            : PyObject_CallFunction(make_failure, "iOiii", static_cast<int>(status), text,
                                    static_cast<int>(entity), static_cast<int>(id), static_cast<int>(patch));
    Py_XDECREF(text);
    if (failure == nullptr)
        return;
    PyErr_SetObject(reinterpret_cast<PyObject *>(Py_TYPE(failure)), failure);
    Py_DECREF(failure);
}

} // namespace

PyObject *set_failure(PyObject *, PyObject *make) {
    Py_INCREF(make);
    Py_XDECREF(make_failure);
    make_failure = make;
    Py_RETURN_NONE;
}

PyObject *raise_last(amst_status status) {
    int32_t entity = AMST_ENTITY_NONE;
    amst_id id = -1;
    amst_id patch = -1;
    // It cannot fail where an output is given.
    static_cast<void>(amst_last_error_where(&entity, &id, &patch) == AMST_OK);
    const char *text = amst_last_error();
    raise(status, PyUnicode_DecodeUTF8(text, static_cast<Py_ssize_t>(strlen(text)), "replace"), entity, id,
          patch);
    return nullptr;
}

void raise_busy(const Handle *handle) {
    PyObject *name = class_name(reinterpret_cast<PyObject *>(const_cast<Handle *>(handle)));
    PyObject *text = name == nullptr ? nullptr : PyUnicode_FromFormat("the %U is in use", name);
    Py_XDECREF(name);
    raise(AMST_ERR_STATE, text, AMST_ENTITY_NONE, -1, -1);
}

void keep_exception() { PyErr_Fetch(&kept.type, &kept.value, &kept.traceback); }

bool is_exception_kept() { return kept.type != nullptr; }

bool raise_kept() {
    if (!is_exception_kept())
        return false;
    PyErr_Restore(kept.type, kept.value, kept.traceback);
    kept = {};
    return true;
}
