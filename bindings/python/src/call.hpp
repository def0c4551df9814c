// A function of the library as a function of Python with the same arguments, but for lengths, capacities and
// what is written through pointers: that is returned.
#pragma once

#include "argument.hpp"
#include "failure.hpp"

#include <tuple>
#include <utility>

enum class Way {
    quick, // keeps the interpreter's lock
    slow,  // releases it, so that other threads go on
    free   // may be called from any thread while an operation runs
};

// Those that take arrays by strides.
template <auto function> constexpr int array_flags = 0;
template <> inline constexpr int array_flags<amst_mesh_create> = PyBUF_STRIDES;
template <> inline constexpr int array_flags<amst_mesh_create_i64> = PyBUF_STRIDES;

template <std::size_t i, class... C> using At = std::tuple_element_t<i, std::tuple<void, C..., void>>;

template <class... C, std::size_t... i>
std::tuple<Argument<role_of<At<i, C...>, C, At<i + 2, C...>>(), C>...>
    arguments_of(std::index_sequence<i...>);

constexpr bool is_taken(Role role) {
    return role != Role::length && role != Role::capacity && role != Role::value;
}

// ------------------------------------------------------------------- steps of a call

template <Role role, class C> bool read(Argument<role, C> &argument, Given &call) {
    if constexpr (is_taken(role))
        return argument.read(*call.next++, call);
    else
        return true;
}

template <std::size_t i, class Arguments> auto pass(Arguments &arguments) {
    if constexpr (requires { std::get<i>(arguments).passed; })
        return std::get<i>(arguments).passed;
    else
        return std::get<i - 1>(arguments).count;
}

template <Role role, class C> void keep(Argument<role, C> &argument, const Uses &uses) {
    if constexpr (role == Role::create)
        argument.keep(uses);
}

// Nothing, one value, or a tuple of several.
template <Role... role, class... C> PyObject *returned(const std::tuple<Argument<role, C>...> &arguments) {
    constexpr Py_ssize_t count = (0 + ... + (role == Role::value ? 1 : 0));
    PyObject *values = count > 1 ? PyTuple_New(count) : nullptr;
    PyObject *only = nullptr;
    Py_ssize_t n = 0;
    const auto add = [&]<Role r, class T>(const Argument<r, T> &argument) {
        if constexpr (r == Role::value) {
            only = to_python(argument.written);
            if (values != nullptr && only != nullptr)
                PyTuple_SetItem(values, n++, only);
        }
    };
    std::apply([&](const auto &...argument) { (add(argument), ...); }, arguments);
    if (count == 0)
        Py_RETURN_NONE;
    if (count == 1 || n == count)
        return count == 1 ? only : values;
    Py_XDECREF(values); // no memory
    return nullptr;
}

// ------------------------------------------------------------------------- the call

template <auto function, Way way, class Arguments, std::size_t... i>
PyObject *call_with(Arguments &arguments, Given &call, std::index_sequence<i...>) {
    if (!(read(std::get<i>(arguments), call) && ...))
        return nullptr;
    if (way != Way::free && !call.uses.allowed())
        return nullptr;
    amst_status status = AMST_OK;
    if constexpr (way == Way::slow) {
        call.uses.mark();
        PyThreadState *state = PyEval_SaveThread();
        status = function(pass<i>(arguments)...);
        PyEval_RestoreThread(state);
    } else
        status = function(pass<i>(arguments)...);
    (keep(std::get<i>(arguments), call.uses), ...); // before an exception can lose it
    if (raise_kept())
        return nullptr;
    return status < 0 ? raise_last(status) : returned(arguments);
}

template <auto function, Way way> struct Function;
template <class... C, amst_status (*function)(C...), Way way> struct Function<function, way> {
    static PyObject *call(PyObject *, PyObject *const *given, Py_ssize_t n) {
        constexpr auto indices = std::index_sequence_for<C...>{};
        decltype(arguments_of<C...>(indices)) arguments;
        constexpr Py_ssize_t wanted =
            []<Role... role, class... T>(std::type_identity<std::tuple<Argument<role, T>...>>) {
            return (Py_ssize_t{0} + ... + (is_taken(role) ? 1 : 0));
        }
        (std::type_identity<decltype(arguments)>{});
        if (n != wanted)
            return PyErr_Format(PyExc_TypeError, "%zd arguments are needed, not %zd", wanted, n);
        Given call{given, array_flags<function>};
        return call_with<function, way>(arguments, call, indices);
    }
};
