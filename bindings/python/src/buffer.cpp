#include "buffer.hpp"

#include <cstring>

namespace {

bool is_format(const Py_buffer &view, Format format) {
    const char *text = view.format == nullptr ? "B" : view.format;
    const auto is_one_of = [text](const char *letters) {
        return std::strlen(text) == 1 && std::strchr(letters, text[0]) != nullptr;
    };
    switch (format) {
    case Format::real:
        return is_one_of("d");
    case Format::int32:
        return is_one_of("il") && view.itemsize == 4;
    case Format::int64:
        return is_one_of("lq") && view.itemsize == 8;
    case Format::byte:
        return is_one_of("bBc");
    }
    return false;
}

} // namespace

bool Buffer::open(PyObject *object, Format format, int flags) {
    if ((flags & PyBUF_STRIDES) != PyBUF_STRIDES)
        flags |= PyBUF_C_CONTIGUOUS;
    if (PyObject_GetBuffer(object, &view, PyBUF_FORMAT | flags) != 0)
        return false;
    is_open = true;
    if (is_format(view, format))
        return true;
    constexpr const char *names[] = {"float64", "int32", "int64", "bytes"};
    PyErr_Format(PyExc_TypeError, "an array of %s is needed", names[static_cast<int>(format)]);
    return false;
}

// NULL has a meaning of its own in some functions, which an empty array has not.
void *Buffer::address() const {
    static double nothing;
    return view.buf == nullptr ? &nothing : view.buf;
}
