// Which thread works with which handles while the interpreter's lock is released. The rules are those of the
// header: reading together is allowed, changing needs a handle alone, and its mesh and context with it.
// Breaking them is an exception here, not a crash.
#pragma once

#include "handle.hpp"

class Uses {
public:
    Uses() = default;
    Uses(const Uses &) = delete;
    Uses &operator=(const Uses &) = delete;
    ~Uses();

    void add(Handle *handle, bool changes) { used[n_used++] = {handle, changes}; }
    // What something new is made of: the context if there is one, else the first.
    Handle *source() const;
    // Whether no other thread is in the way; else there is an exception.
    bool allowed() const;
    // Tell other threads, until this object ends. Called with the lock, as all here.
    void mark();

private:
    struct Use {
        Handle *handle;
        bool changes;
    };
    struct Marked {
        Handle *handle;
        bool changes;
        unsigned long worker_before; // a callback may call the library again on the same thread
    };
    static constexpr int most = 4;    // handles that one function takes: mesh, patches, options; two meshes
    static constexpr int deepest = 3; // patches, their mesh, its context

    Use used[most];
    Marked marked[most * deepest];
    int n_used = 0;
    int n_marked = 0;
};
