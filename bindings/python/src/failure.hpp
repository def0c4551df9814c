// Failures of the library and of callbacks as exceptions of Python.
#pragma once

#include "handle.hpp"

// make(status, text, entity, id, patch) of error.py gives the exception.
PyObject *set_failure(PyObject *module, PyObject *make);

// The failure of the call just made on this thread. Always nullptr.
PyObject *raise_last(amst_status status);
void raise_busy(const Handle *handle);

// No exception may enter the library: one of a callback is kept until the call is over.
void keep_exception();
bool is_exception_kept();
// Whether there was one, which is now under way.
bool raise_kept();
