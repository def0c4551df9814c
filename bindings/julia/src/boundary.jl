# The boundary as the caller knows it.

# The library holds the address of this object as `user`; a mesh and its copies keep it. Mutable, since
# other objects have none.
mutable struct Projection
    f::Any
    dim::Int
    callbacks::Callbacks # take what f throws
end

# Called by the library.
projection_thunk(user::Ptr{Cvoid}, n::Int64, marker::Ptr{Int32}, points::Ptr{Float64}, projected::Ptr{Float64}) =
    gc_unsafe(project, user, n, marker, points, projected)

# The arrays are copied: f may keep what it is given.
@noinline function project(user, n, marker, points, projected)
    n > 0 || return Int32(0) # the addresses may be NULL
    projection = unsafe_pointer_to_objref(user)::Projection
    failed = guarded(projection.callbacks) do callbacks
        size = (projection.dim, Int(n))
        result = projection.f(copy(unsafe_wrap(Array, marker, Int(n))), copy(unsafe_wrap(Array, points, size)))
        result === nothing && return true
        axes(result) == map(Base.OneTo, size) ||
            throw(DimensionMismatch("the projection of $size numbers gives $(map(length, axes(result)))"))
        copyto!(unsafe_wrap(Array, projected, size), result)
        return false
    end
    return Int32(failed)
end

"""
    set_projection!(f, mesh)
    set_projection!(nothing, mesh)

Say where the boundary runs, for operations with `edit_boundary = 1`, or that it runs as the edges of the
mesh do. `f(markers, points)` gives the points of the boundary, (dim, n), that belong to `points`, (dim, n),
which are on or near edges with these `markers`. Such an operation calls it once when it begins, to learn
where the boundary runs, and once in the end, for new vertices, which come to lie where it says, bit for
bit. Copies of the mesh have it, too; files do not.

    set_projection!(mesh) do markers, points
        points ./ sqrt.(sum(abs2, points; dims = 1)) # the circle of radius 1
    end

The operation fails with `AMST_ERR_PROJECTION` if `f` gives `nothing`, if a result is not finite or farther
off than `tolerance` edges, and if a new vertex turned a face over there. If `f` throws, the exception is
thrown on. All leave the mesh as it was. `f` is called on the thread of the operation, gives equal results
for equal points, and is bound like that of [`set_progress!`](@ref). Throws `AlphaMSTError`: STATE (in a
callback).
"""
function set_projection!(f, mesh::Mesh)
    projection = f === nothing ? nothing : Projection(f, dim(mesh), mesh.callbacks)
    thunk = f === nothing ? C_NULL :
            @cfunction(projection_thunk, Int32, (Ptr{Cvoid}, Int64, Ptr{Int32}, Ptr{Float64}, Ptr{Float64}))
    user = f === nothing ? C_NULL : pointer_from_objref(projection)
    demand(amst_mesh_set_projection(mesh, thunk, user))
    mesh.projection = projection
    return mesh
end
