#include "callback.hpp"

#include "argument.hpp"
#include "failure.hpp"

#include <chrono>

namespace {

class Lock {
public:
    Lock() : state(PyGILState_Ensure()) {}
    Lock(const Lock &) = delete;
    Lock &operator=(const Lock &) = delete;
    ~Lock() { PyGILState_Release(state); }

private:
    PyGILState_STATE state;
};

// Whether the result, a new reference, is true; an exception is kept and counts as that.
bool is_true(PyObject *result) {
    const int truth = result == nullptr ? -1 : PyObject_IsTrue(result);
    Py_XDECREF(result);
    if (truth < 0)
        keep_exception();
    return truth != 0;
}

// A pressed Ctrl-C is looked for so often: soon enough for whoever waits, and taking the lock costs nothing.
constexpr std::chrono::milliseconds patience{50};

bool is_time_to_look() {
    static thread_local std::chrono::steady_clock::time_point last;
    const auto now = std::chrono::steady_clock::now();
    if (now - last < patience)
        return false;
    last = now;
    return true;
}

int32_t report_progress(void *user, double fraction, const char *stage) {
    if (is_exception_kept())
        return 1;
    PyObject *progress = static_cast<Handle *>(user)->progress;
    if (progress == nullptr && !is_time_to_look())
        return 0;
    const Lock lock;
    if (PyErr_CheckSignals() != 0) {
        keep_exception();
        return 1;
    }
    return progress != nullptr && is_true(PyObject_CallFunction(progress, "ds", fraction, stage)) ? 1 : 0;
}

void report_log(void *user, int32_t level, const char *message) {
    PyObject *log = static_cast<Handle *>(user)->log;
    if (is_exception_kept() || log == nullptr)
        return;
    const Lock lock;
    PyObject *text = PyUnicode_DecodeUTF8(message, static_cast<Py_ssize_t>(std::strlen(message)), "replace");
    is_true(text == nullptr ? nullptr : PyObject_CallFunction(log, "iN", static_cast<int>(level), text));
}

PyObject *memory(const void *address, int64_t bytes, int flags) {
    return PyMemoryView_FromMemory(static_cast<char *>(const_cast<void *>(address)),
                                   static_cast<Py_ssize_t>(bytes), flags);
}

// fn gets memory that is there during the call only: markers, points, and where the result goes. True: it
// has failed.
int32_t project(void *user, int64_t n, const int32_t *marker, const double *points, double *projected) {
    if (is_exception_kept())
        return 1;
    if (n == 0)
        return 0; // the addresses may be NULL
    const Lock lock;
    PyObject *projection = static_cast<PyObject *>(user);
    const int64_t dim = PyLong_AsLongLong(PyTuple_GetItem(projection, 1));
    const int64_t bytes = n * dim * static_cast<int64_t>(sizeof(double));
    return is_true(
        PyObject_CallFunction(PyTuple_GetItem(projection, 0), "NNN",
                              memory(marker, n * static_cast<int64_t>(sizeof(int32_t)), PyBUF_READ),
                              memory(points, bytes, PyBUF_READ), memory(projected, bytes, PyBUF_WRITE)));
}

// The handle that a function is to be set in, if nobody uses it.
Handle *free_handle(PyObject *object, Kind kind) {
    Handle *handle = open_handle(object, kind);
    if (handle == nullptr)
        return nullptr;
    Uses uses;
    uses.add(handle, true);
    return uses.allowed() ? handle : nullptr;
}

bool has_arguments(Py_ssize_t n, Py_ssize_t wanted) {
    if (n != wanted)
        PyErr_Format(PyExc_TypeError, "%zd arguments are needed, not %zd", wanted, n);
    return n == wanted;
}

PyObject *finish(amst_status status, PyObject *&place, PyObject *function) {
    if (status < 0)
        return raise_last(status);
    PyObject *before = place;
    place = function;
    Py_XINCREF(function);
    Py_XDECREF(before);
    Py_RETURN_NONE;
}

PyObject *or_null(PyObject *object) { return object == Py_None ? nullptr : object; }

} // namespace

// The library always has a function to call, which looks for Ctrl-C.
PyObject *set_progress(PyObject *, PyObject *const *given, Py_ssize_t n) {
    if (!has_arguments(n, 2))
        return nullptr;
    Handle *handle = free_handle(given[0], Kind::context);
    if (handle == nullptr)
        return nullptr;
    return finish(
        amst_context_set_progress(static_cast<amst_context *>(handle->pointer), report_progress, handle),
        handle->progress, or_null(given[1]));
}

PyObject *set_log(PyObject *, PyObject *const *given, Py_ssize_t n) {
    int32_t level = 0;
    if (!has_arguments(n, 3) || !from_python(given[1], level))
        return nullptr;
    Handle *handle = free_handle(given[0], Kind::context);
    if (handle == nullptr)
        return nullptr;
    PyObject *function = or_null(given[2]);
    return finish(amst_context_set_log(static_cast<amst_context *>(handle->pointer), level,
                                       function == nullptr ? nullptr : report_log, handle),
                  handle->log, function);
}

PyObject *set_projection(PyObject *, PyObject *const *given, Py_ssize_t n) {
    if (!has_arguments(n, 3))
        return nullptr;
    Handle *handle = free_handle(given[0], Kind::mesh);
    if (handle == nullptr)
        return nullptr;
    auto *mesh = static_cast<amst_mesh *>(handle->pointer);
    if (given[1] == Py_None)
        return finish(amst_mesh_set_projection(mesh, nullptr, nullptr), handle->projection, nullptr);
    // What the library holds lives as long as the mesh and its copies, which have it, too.
    PyObject *projection = PyTuple_Pack(2, given[1], given[2]);
    if (projection == nullptr)
        return nullptr;
    PyObject *done =
        finish(amst_mesh_set_projection(mesh, project, projection), handle->projection, projection);
    Py_DECREF(projection);
    return done;
}
