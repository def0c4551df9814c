# Threads, callbacks and cancelling.

const log_levels = (off = AMST_LOG_OFF, error = AMST_LOG_ERROR, warning = AMST_LOG_WARNING,
                    info = AMST_LOG_INFO, debug = AMST_LOG_DEBUG)

# The library holds the address of this object as `user`. Every mesh and patch set keeps it, since
# a mesh may be used when its context is closed or collected.
mutable struct Callbacks
    progress::Any
    log::Any
    failure::Union{Some,Nothing} # what a callback threw in the call under way
end

# ------------------------------------------------------------------- called by the library

# No exception may enter the library: it is kept, and thrown by `demand` after the call.
guarded(f, user::Ptr{Cvoid}) = guarded(f, unsafe_pointer_to_objref(user)::Callbacks)

function guarded(f, callbacks::Callbacks)
    callbacks.failure === nothing || return true
    try
        return f(callbacks) === true
    catch failure
        callbacks.failure = Some(failure)
        return true
    end
end

progress_thunk(user::Ptr{Cvoid}, fraction::Float64, stage::Cstring) = gc_unsafe(tell_progress, user, fraction, stage)

@noinline tell_progress(user, fraction, stage) =
    Int32(guarded(callbacks -> callbacks.progress(fraction, unsafe_string(stage)), user))

log_thunk(user::Ptr{Cvoid}, level::Int32, message::Cstring) = gc_unsafe(tell_log, user, level, message)

@noinline function tell_log(user, level, message)
    guarded(user) do callbacks
        callbacks.log(name_of(log_levels, level, :debug), unsafe_string(message))
    end
    return nothing
end

# For calls in which callbacks may have run.
function demand(status::Int32, callbacks::Callbacks)
    failure = callbacks.failure
    failure === nothing && return demand(status)
    callbacks.failure = nothing
    throw(something(failure))
end

# ------------------------------------------------------------------------ context

"""
    Context(; threads = 1)

What meshes are made in: number of threads, progress, log and cancelling. One context serves one
thread at a time; different contexts share nothing. Ids are counted from 1. While a thread is in the library
others of Julia go on, and so does the garbage collector.
"""
mutable struct Context <: Handle{amst_context}
    pointer::Ptr{amst_context}
    callbacks::Callbacks

    function Context(; threads::Integer = 1)
        pointer = created(out -> amst_context_create(1, out), amst_context)
        context = finalizer(close, new(pointer, Callbacks(nothing, nothing, nothing)))
        threads == 1 || set_threads!(context, threads)
        return context
    end
end

"""
    set_threads!(context, n)

Threads that an operation works with; 0 is all cores. Results do not depend on it.
"""
function set_threads!(context::Context, n::Integer)
    demand(amst_context_set_threads(context, n))
    return context
end

"""
    set_progress!(f, context)
    set_progress!(nothing, context)

Have `f(fraction, stage)` called while an operation runs, or no longer: `fraction` is from 0 to 1,
`stage` a `String`. If `f` returns `true` the operation stops with the error
`AMST_ERR_CANCELLED`; if it throws, the operation stops and the exception is thrown on to its
caller. Both leave the mesh as it was. `f` is called on the thread of the operation; it may ask and
close, but not change anything of this context, and it should not switch tasks (read, wait, sleep)
in a task that may move to another thread.
"""
function set_progress!(f, context::Context)
    thunk = f === nothing ? C_NULL : @cfunction(progress_thunk, Int32, (Ptr{Cvoid}, Float64, Cstring))
    demand(amst_context_set_progress(context, thunk, pointer_from_objref(context.callbacks)))
    context.callbacks.progress = f
    return context
end

"""
    set_log!(f, context; level = :info)
    set_log!(nothing, context)

Have `f(level, message)` called with messages up to a level, `:error`, `:warning`, `:info` (one a
stage) or `:debug` (one a patch or window), or no longer. `f` gets the level as such a symbol and is bound like that of
[`set_progress!`](@ref); it cannot cancel. If it throws, the exception is thrown on when the
operation has ended, which may then have changed the mesh.
"""
function set_log!(f, context::Context; level = :info)
    thunk = f === nothing ? C_NULL : @cfunction(log_thunk, Cvoid, (Ptr{Cvoid}, Int32, Cstring))
    demand(amst_context_set_log(context, number_of(log_levels, f === nothing ? :off : level), thunk,
                                pointer_from_objref(context.callbacks)))
    context.callbacks.log = f
    return context
end

"""
    set_cancel!(context, flag = true)

Stop the operation of the context that runs now and all later ones with `AMST_ERR_CANCELLED`, until
the flag is lowered with `false`. May be called from any thread.
"""
function set_cancel!(context::Context, flag::Bool = true)
    demand(amst_context_set_cancel(context, flag))
    return context
end

"""
    progress(context)

Fraction, 0 to 1, of the operation under way or else of the last one. May be called from any thread.
"""
progress(context::Context) = scalar(out -> amst_context_get_progress(context, out), Float64)
