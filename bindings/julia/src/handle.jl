# What contexts, options, meshes, patch sets and reports have in common: a handle of the library
# that is destroyed once, by `close` or by the garbage collector. The library lets handles be
# destroyed in any order and from any thread, so no object keeps another one for that.

abstract type Handle{T} end

"""
    close(x)

End a `Context`, `Options`, `Mesh`, `Patches` or `Report` now and not when it is collected. The
others may go on; a second `close` does nothing. No other call may be using `x` on another thread.
"""
function Base.close(handle::Handle)
    pointer = handle.pointer
    handle.pointer = C_NULL
    pointer == C_NULL || destroy(pointer)
    return nothing
end

destroy(pointer::Ptr{amst_context}) = amst_context_destroy(pointer)
destroy(pointer::Ptr{amst_options}) = amst_options_destroy(pointer)
destroy(pointer::Ptr{amst_mesh}) = amst_mesh_destroy(pointer)
destroy(pointer::Ptr{amst_patches}) = amst_patches_destroy(pointer)
destroy(pointer::Ptr{amst_report}) = amst_report_destroy(pointer)

Base.isopen(handle::Handle) = handle.pointer != C_NULL

# An object itself is the argument of a raw call, which thereby keeps it from being collected. A
# closed one is never passed on: NULL means "default" or "all" to some functions.
Base.cconvert(::Type{Ptr{T}}, handle::Handle{T}) where {T} = handle
function Base.unsafe_convert(::Type{Ptr{T}}, handle::Handle{T}) where {T}
    isopen(handle) || throw(InvalidStateException("the $(nameof(typeof(handle))) is closed", :closed))
    return handle.pointer
end

# No options are all defaults, no patches are the whole mesh.
const Optional = Union{amst_options,amst_patches}
Base.cconvert(::Type{Ptr{T}}, ::Nothing) where {T<:Optional} = Ptr{T}(C_NULL)

Base.show(io::IO, handle::Handle) = print(io, nameof(typeof(handle)), isopen(handle) ? "" : " (closed)")

# A copy of the object would destroy the handle a second time.
Base.deepcopy_internal(handle::Handle, ::IdDict) =
    throw(ArgumentError("a $(nameof(typeof(handle))) cannot be copied with deepcopy"))

# The handle that `create` writes through its argument.
function created(create, ::Type{T}) where {T}
    out = Ref{Ptr{T}}(C_NULL)
    demand(create(out))
    return out[]
end
