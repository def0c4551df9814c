// Arguments of the library's functions, each told by its type and its neighbours: what is read from Python
// before the call and what goes back after it.
#pragma once

#include "buffer.hpp"
#include "use.hpp"

#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

// What a call of Python is given, and works with.
struct Given {
    PyObject *const *next;
    int array_flags = 0; // PyBUF_STRIDES: arrays that are read need not be packed
    Uses uses{};
};

enum class Role {
    handle,   // mesh: an open handle; options and patches may be None
    create,   // amst_mesh **out: an empty handle, or None for a report
    number,   // taken by value
    text,     // const char *: a str, or None
    input,    // const T *, before a length: an array
    length,   // rows of the input before it
    three,    // const double[3]
    output,   // T *, before a capacity: an array that is filled, or None
    capacity, // elements of the output before it
    value     // T *, what is written there is returned
};

template <class C> constexpr bool is_array = false;
template <class T> constexpr bool is_array<T *> = std::is_arithmetic_v<T>;

template <class Before, class C, class After> consteval Role role_of() {
    using T = std::remove_pointer_t<C>;
    constexpr bool counted = std::is_same_v<After, int64_t>;
    if constexpr (!std::is_pointer_v<C>) {
        if constexpr (!std::is_same_v<C, int64_t> || !is_array<Before>)
            return Role::number;
        else
            return std::is_const_v<std::remove_pointer_t<Before>> ? Role::length : Role::capacity;
    } else if constexpr (std::is_pointer_v<T>)
        return Role::create;
    else if constexpr (kind_of<std::remove_const_t<T>> != Kind::none)
        return Role::handle;
    else if constexpr (std::is_same_v<T, const char>)
        return Role::text;
    else if constexpr (std::is_const_v<T>)
        return counted ? Role::input : Role::three;
    else
        return counted ? Role::output : Role::value;
}

inline PyObject *to_python(int32_t value) { return PyLong_FromLong(value); }
inline PyObject *to_python(int64_t value) { return PyLong_FromLongLong(value); }
inline PyObject *to_python(double value) { return PyFloat_FromDouble(value); }
inline PyObject *to_python(const amst_summary &value) {
    return Py_BuildValue("LLdddd", static_cast<long long>(value.count),
                         static_cast<long long>(value.acceptable), value.min, value.max, value.mean,
                         value.stddev);
}

inline bool from_python(PyObject *object, double &value) {
    value = PyFloat_AsDouble(object);
    return value != -1 || PyErr_Occurred() == nullptr;
}

template <class T> bool from_python(PyObject *object, T &value) {
    const long long given = PyLong_AsLongLong(object);
    if (given == -1 && PyErr_Occurred() != nullptr)
        return false;
    value = static_cast<T>(given);
    if (value == given)
        return true;
    PyErr_Format(PyExc_OverflowError, "%lld needs more than %d bits", given, static_cast<int>(8 * sizeof(T)));
    return false;
}

template <Role role, class C> struct Argument;

template <class T> struct Argument<Role::handle, T *> {
    T *passed = nullptr;

    bool read(PyObject *object, Given &call) {
        constexpr Kind kind = kind_of<std::remove_const_t<T>>;
        if ((kind == Kind::options || kind == Kind::patches) && object == Py_None)
            return true;
        Handle *handle = open_handle(object, kind);
        if (handle == nullptr)
            return false;
        call.uses.add(handle, !std::is_const_v<T>);
        passed = static_cast<T *>(handle->pointer);
        return true;
    }
};

template <class T> struct Argument<Role::create, T **> {
    Handle *handle = nullptr;
    T *made = nullptr;
    T **passed = nullptr;

    bool read(PyObject *object, Given &) {
        if (object == Py_None)
            return true;
        passed = &made;
        return (handle = empty_handle(object)) != nullptr;
    }
    // Options and reports need nothing; the rest is made in a context or, like a copy, has all of its
    // original.
    void keep(const Uses &uses) {
        if (made == nullptr)
            return;
        constexpr Kind kind = kind_of<T>;
        Handle *source = nullptr;
        if constexpr (kind == Kind::mesh || kind == Kind::patches)
            source = uses.source();
        const bool copy = source != nullptr && source->kind == kind;
        fill(handle, kind, made, copy ? source->parent : source);
        if (copy)
            Py_XINCREF(handle->projection = source->projection);
    }
};

template <class T> struct Argument<Role::number, T> {
    T passed = 0;

    bool read(PyObject *object, Given &) { return from_python(object, passed); }
};

template <> struct Argument<Role::text, const char *> {
    const char *passed = nullptr;

    bool read(PyObject *object, Given &) {
        Py_ssize_t length = 0;
        if (object == Py_None)
            return true;
        passed = PyUnicode_AsUTF8AndSize(object, &length);
        if (passed == nullptr)
            return false;
        if (static_cast<Py_ssize_t>(std::strlen(passed)) == length)
            return true;
        PyErr_SetString(PyExc_ValueError, "embedded null character");
        return false;
    }
};

template <class T> struct Argument<Role::input, const T *> {
    Buffer buffer;
    const T *passed = nullptr;
    int64_t count = 0;

    bool read(PyObject *object, Given &call) {
        if (object == Py_None)
            return true;
        if (!buffer.open(object, format_of<T>, call.array_flags))
            return false;
        passed = static_cast<const T *>(buffer.address());
        count = buffer.rows();
        return true;
    }
};

template <> struct Argument<Role::three, const double *> {
    Buffer buffer;
    const double *passed = nullptr;

    bool read(PyObject *object, Given &) {
        if (!buffer.open(object, format_of<double>, 0))
            return false;
        passed = static_cast<const double *>(buffer.address());
        if (buffer.elements() == 3)
            return true;
        PyErr_SetString(PyExc_ValueError, "a point has 3 coordinates");
        return false;
    }
};

template <class T> struct Argument<Role::output, T *> {
    Buffer buffer;
    T *passed = nullptr;
    int64_t count = 0;

    bool read(PyObject *object, Given &) {
        if (object == Py_None)
            return true;
        if (!buffer.open(object, format_of<T>, PyBUF_WRITABLE))
            return false;
        passed = static_cast<T *>(buffer.address());
        count = buffer.elements();
        return true;
    }
};

template <class T> struct Argument<Role::value, T *> {
    T written{};
    T *passed = &written;
};

// Of the array before it.
template <> struct Argument<Role::length, int64_t> {};
template <> struct Argument<Role::capacity, int64_t> {};
