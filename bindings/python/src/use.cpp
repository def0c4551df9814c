#include "use.hpp"

#include "failure.hpp"

namespace {

// What is used with a handle: of patches that are read the mesh, which may be read by others.
Handle *next(const Handle *handle, bool changes) {
    return changes || handle->kind == Kind::patches ? handle->parent : nullptr;
}

bool is_free(const Handle *handle, bool changes) {
    if (handle->worker != 0 && handle->worker != PyThread_get_thread_ident())
        return false;
    return !changes || handle->readers == 0;
}

} // namespace

Handle *Uses::source() const {
    for (int i = 0; i < n_used; ++i)
        if (used[i].handle->kind == Kind::context)
            return used[i].handle;
    return n_used > 0 ? used[0].handle : nullptr;
}

bool Uses::allowed() const {
    for (int i = 0; i < n_used; ++i)
        for (Handle *handle = used[i].handle; handle != nullptr; handle = next(handle, used[i].changes))
            if (!is_free(handle, used[i].changes))
                return raise_busy(handle), false;
    return true;
}

void Uses::mark() {
    const unsigned long here = PyThread_get_thread_ident();
    for (int i = 0; i < n_used; ++i)
        for (Handle *handle = used[i].handle; handle != nullptr; handle = next(handle, used[i].changes)) {
            marked[n_marked++] = {handle, used[i].changes, handle->worker};
            if (used[i].changes)
                handle->worker = here;
            else
                ++handle->readers;
        }
}

Uses::~Uses() {
    while (n_marked > 0) {
        const Marked &last = marked[--n_marked];
        if (last.changes)
            last.handle->worker = last.worker_before;
        else
            --last.handle->readers;
    }
}
