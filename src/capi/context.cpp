#include <string>
#include <thread>

#include "capi/guard.h"
#include "capi/handles.h"
#include "stop.h"

namespace alphamst::capi {

void Context::require_idle() const {
    if (busy.load(std::memory_order_acquire))
        refuse_while_busy();
}

void Context::refuse_while_busy() const {
    if (worker.load() == std::this_thread::get_id())
        throw Failure(Fault::state, "an operation of this context is under way; a callback may only ask");
    throw Failure(Fault::state,
                  "an operation of this context is under way on another thread; threads that work at "
                  "the same time need a context each: clone the mesh by amst_mesh_clone_into");
}

void Context::say(std::int32_t level, const std::string &message) const {
    const Stop none(nullptr); // what the caller does there is no part of the operation, see UnderWay
    if (log != nullptr && level <= log_level)
        log(log_user, level, message.c_str());
}

} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_context_create(std::int32_t index_base, amst_context **out) {
    return guarded(0, [&] {
        amst_context *&created = required(out, "out");
        if (index_base != 0 && index_base != 1)
            throw Failure(Fault::argument, "index_base must be 0 or 1, it is " + std::to_string(index_base));
        created = new amst_context{std::make_shared<Context>(index_base)};
    });
}

void amst_context_destroy(amst_context *ctx) { delete ctx; }

amst_status amst_context_set_threads(amst_context *ctx, std::int32_t n) {
    return guarded(index_base(ctx), [&] {
        Context &context = *required(ctx, "ctx").impl;
        context.require_idle();
        if (n < 0)
            throw Failure(Fault::range, "n is negative: " + std::to_string(n));
        context.threads = n;
    });
}

amst_status amst_context_set_log(amst_context *ctx, std::int32_t level, amst_log_fn fn, void *user) {
    return guarded(index_base(ctx), [&] {
        Context &context = *required(ctx, "ctx").impl;
        context.require_idle();
        if (level < AMST_LOG_OFF || level > AMST_LOG_DEBUG)
            throw Failure(Fault::argument,
                          "level must be AMST_LOG_OFF .. AMST_LOG_DEBUG, it is " + std::to_string(level));
        context.log_level = level;
        context.log = fn;
        context.log_user = user;
    });
}

amst_status amst_context_set_progress(amst_context *ctx, amst_progress_fn fn, void *user) {
    return guarded(index_base(ctx), [&] {
        Context &context = *required(ctx, "ctx").impl;
        context.require_idle();
        context.progress = fn;
        context.progress_user = user;
    });
}

amst_status amst_context_set_cancel(amst_context *ctx, std::int32_t flag) {
    return guarded(index_base(ctx), [&] { required(ctx, "ctx").impl->cancel.store(flag != 0); });
}

amst_status amst_context_get_progress(const amst_context *ctx, double *fraction) {
    return guarded(index_base(ctx), [&] {
        const Context &context = *required(ctx, "ctx").impl;
        required(fraction, "fraction") = context.fraction.load();
    });
}
