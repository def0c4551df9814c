// Memory of arrays, by the buffer protocol of Python: numpy's arrays and others.
#pragma once

#include "handle.hpp"

#include <cstdint>

enum class Format { real, int32, int64, byte };

template <class T> constexpr Format format_of = Format::byte;
template <> inline constexpr Format format_of<double> = Format::real;
template <> inline constexpr Format format_of<int32_t> = Format::int32;
template <> inline constexpr Format format_of<int64_t> = Format::int64;

class Buffer {
public:
    Buffer() = default;
    Buffer(const Buffer &) = delete;
    Buffer &operator=(const Buffer &) = delete;
    ~Buffer() {
        if (is_open)
            PyBuffer_Release(&view);
    }

    // Packed rows of that type, or an exception. flags: PyBUF_WRITABLE, or PyBUF_STRIDES for rows that are
    // not packed.
    bool open(PyObject *object, Format format, int flags);
    void *address() const;
    int64_t rows() const { return view.ndim > 0 ? view.shape[0] : 1; }
    int64_t elements() const { return view.len / view.itemsize; }

private:
    Py_buffer view{};
    bool is_open = false;
};
