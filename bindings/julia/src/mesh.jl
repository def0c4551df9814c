# Meshes: arrays and files in and out, what a mesh is asked, flags and savepoints.

"""
Bits of vertices, edges and faces: `FLAGS.fixed` is neither moved, split nor removed,
`FLAGS.feature` lies on a curve that must survive and may slide along it, `FLAGS.corner` is an end
or crossing of such curves and does not move.
"""
const FLAGS = (fixed = AMST_FLAG_FIXED, feature = AMST_FLAG_FEATURE, corner = AMST_FLAG_CORNER)

"""
    Mesh(points, faces; context = Context(), settings...)
    Mesh(path; context = Context(), settings...)

A mesh of quadrilaterals from arrays or from a file.

`points` is (dim, n) with dim 2 or 3. `faces` is (4, m) or (3, m), corners counter-clockwise, at
least one face; 0 as the last of four corners makes a triangle. Triangles are merged in pairs, or
split with `quadrangulate = 1`; all given vertices keep their ids. Faces that run another way round than
their neighbours, or clockwise in the plane, are turned over, and the log tells how many. Strided matrices (also views and `PermutedDimsArray`s) of `Float64` and of `Int32` or `Int64`
are read where they lie; other ones are converted first. Nothing is kept of them.

The format of a file is told by its extension: `.off`, `.obj`, `.ply`, `.msh` (Gmsh 1, 2.2, 4.0
and 4.1 ASCII), `.su2`, `.vtk` (legacy). Dim is 2 when every z is 0. Numbers of points, boundaries and
regions are [`markers`](@ref), with their names; the boundaries of an `.su2` file get the numbers 1, 2, ... in
the order of the file. What numbers could not be kept is told by the log, see [`set_log!`](@ref).

Throws `AlphaMSTError`: ARGUMENT, RANGE (corner), NOT_FINITE, NOT_QUAD, NOT_MANIFOLD, and for files
IO, FORMAT, UNSUPPORTED.
"""
mutable struct Mesh <: Handle{amst_mesh}
    pointer::Ptr{amst_mesh}
    callbacks::Callbacks
    projection::Any # a Projection or nothing; the library has its address

    Mesh(pointer::Ptr{amst_mesh}, callbacks::Callbacks, projection = nothing) =
        finalizer(close, new(pointer, callbacks, projection))
end

function Mesh(points::AbstractMatrix{<:Real}, faces::AbstractMatrix{<:Integer};
              context::Context = Context(), options = nothing, settings...)
    coords = by_strides(points, Float64)
    corners = by_strides(faces, eltype(faces) === Int32 ? Int32 : Int64)
    create = eltype(corners) === Int32 ? amst_mesh_create : amst_mesh_create_i64
    given = chosen(options, settings)
    pointer = created(amst_mesh) do out
        create(context, size(coords, 1), coords, size(coords, 2), stride(coords, 2), stride(coords, 1),
               corners, size(corners, 2), stride(corners, 2), stride(corners, 1), size(corners, 1),
               given, out)
    end
    return Mesh(pointer, context.callbacks)
end

function Mesh(path::AbstractString; context::Context = Context(), options = nothing, settings...)
    given = chosen(options, settings)
    pointer = created(out -> amst_mesh_read(context, path, given, out), amst_mesh)
    return Mesh(pointer, context.callbacks)
end

"""
    write(path, mesh)

Write a mesh to a file of one of the formats that are read, or to an `.svg`, a picture with the
singularities marked. All markers and names are kept by `.msh`; what another format has no place for is told by
the log. Throws `AlphaMSTError`: IO, UNSUPPORTED (extension).
"""
function Base.write(path::AbstractString, mesh::Mesh)
    demand(amst_mesh_write(mesh, path))
    return nothing
end

"""
    copy(mesh)

A mesh of its own, in the same context, with flags, markers, fields, revision and projection, without savepoints.
"""
Base.copy(mesh::Mesh) =
    Mesh(created(out -> amst_mesh_clone(mesh, out), amst_mesh), mesh.callbacks, mesh.projection)

"""
    copy(mesh, context)

The same in another context, without the projection: for tasks that work at the same time, each on a copy in a
context of its own.
"""
Base.copy(mesh::Mesh, context::Context) =
    Mesh(created(out -> amst_mesh_clone_into(mesh, context, out), amst_mesh), context.callbacks)

# ------------------------------------------------------------------------ numbers

"""
    dim(mesh)

Coordinates of a point, 2 or 3.
"""
dim(mesh::Mesh) = Int(scalar(out -> amst_mesh_get_dim(mesh, out), Int32))

count_of(mesh::Mesh, entity) =
    scalar(out -> amst_mesh_get_count(mesh, number_of(entities, entity), out), Int64)

"""
    nvertices(mesh)

Number of vertices.
"""
nvertices(mesh::Mesh) = count_of(mesh, AMST_VERTEX)

"""
    nedges(mesh)

Number of edges.
"""
nedges(mesh::Mesh) = count_of(mesh, AMST_EDGE)

"""
    nfaces(mesh)

Number of faces.
"""
nfaces(mesh::Mesh) = count_of(mesh, AMST_FACE)

"""
    revision(mesh)

A number that rises with every change of connectivity and never repeats in one mesh, except that
`rollback!` returns to the one it names.
"""
revision(mesh::Mesh) = scalar(out -> amst_mesh_get_revision(mesh, out), Int64)

"""
    checksum(mesh)

64-bit digest of coordinates, connectivity, flags and markers: equal for equal meshes.
"""
checksum(mesh::Mesh) = scalar(out -> amst_mesh_get_checksum(mesh, out), Int64)

"""
    check(mesh)

Throw an `AlphaMSTError` with the first fault of the connectivity and, for dim 2, of the
orientation: a corner turned over or flat.
"""
function check(mesh::Mesh)
    demand(amst_mesh_check(mesh))
    return nothing
end

# ------------------------------------------------------------------------- arrays

"""
    points(mesh)

Coordinates as a `Matrix{Float64}` (dim, nvertices).
"""
points(mesh::Mesh) = points!(Matrix{Float64}(undef, dim(mesh), nvertices(mesh)), mesh)

"""
    points!(array, mesh)

The same as [`points`](@ref), written into an array of the caller, which may be a view.
"""
points!(array::AbstractMatrix, mesh::Mesh) =
    fill_with!(Float64, array, (dim(mesh), nvertices(mesh))) do out, capacity, needed
        amst_mesh_get_points(mesh, out, capacity, needed)
    end

"""
    set_points!(mesh, points)

New positions (dim, nvertices) for all vertices; connectivity and revision stay. Throws
`DimensionMismatch`, and `AlphaMSTError` RANGE for another number of vertices and NOT_FINITE.
"""
function set_points!(mesh::Mesh, points::AbstractMatrix{<:Real})
    size(points, 1) == dim(mesh) ||
        throw(DimensionMismatch("a point of this mesh has $(dim(mesh)) coordinates, not $(size(points, 1))"))
    packed = points isa StridedMatrix{Float64} && is_packed(points) ? points : Matrix{Float64}(points)
    demand(amst_mesh_set_points(mesh, packed, size(packed, 2)))
    return mesh
end

"""
    faces(mesh)

The four vertices of every face, counter-clockwise, as a `Matrix{Int32}` (4, nfaces).
"""
faces(mesh::Mesh) = faces!(Matrix{Int32}(undef, 4, nfaces(mesh)), mesh)

"""
    faces!(array, mesh)

The same as [`faces`](@ref), written into an array of the caller, which may be a view.
"""
faces!(array::AbstractMatrix, mesh::Mesh) =
    fill_with!(Int32, array, (4, nfaces(mesh))) do out, capacity, needed
        amst_mesh_get_faces(mesh, out, capacity, needed)
    end

"""
    edges(mesh)

The two vertices of every edge, the smaller id first, as a `Matrix{Int32}` (2, nedges).
"""
edges(mesh::Mesh) = edges!(Matrix{Int32}(undef, 2, nedges(mesh)), mesh)

"""
    edges!(array, mesh)

The same as [`edges`](@ref), written into an array of the caller, which may be a view.
"""
edges!(array::AbstractMatrix, mesh::Mesh) =
    fill_with!(Int32, array, (2, nedges(mesh))) do out, capacity, needed
        amst_mesh_get_edges(mesh, out, capacity, needed)
    end

"""
    crossed_edges(mesh)

The vertices of sharp edges that pairs of triangles have been made over, as a `Matrix{Int32}` (2, n). Ids
here and in [`split_edges`](@ref) are those when the mesh was created or read, whatever became of it.
"""
crossed_edges(mesh::Mesh) = reshape(vector_of(Int32) do out, capacity, needed
    amst_mesh_get_crossed_edges(mesh, out, capacity, needed)
end, 2, :)

"""
    split_edges(mesh)

Two vertices and the new one at the midpoint of the edge between them, which may be half of another edge, as a
`Matrix{Int32}` (3, n).
"""
split_edges(mesh::Mesh) = reshape(vector_of(Int32) do out, capacity, needed
    amst_mesh_get_split_edges(mesh, out, capacity, needed)
end, 3, :)

"""
    edge_faces(mesh)

The faces left and right of every edge as a `Matrix{Int32}` (2, nedges); on the boundary the one face there is,
then 0.
"""
edge_faces(mesh::Mesh) = edge_faces!(Matrix{Int32}(undef, 2, nedges(mesh)), mesh)

"""
    edge_faces!(array, mesh)

The same as [`edge_faces`](@ref), written into an array of the caller, which may be a view.
"""
edge_faces!(array::AbstractMatrix, mesh::Mesh) =
    fill_with!(Int32, array, (2, nedges(mesh))) do out, capacity, needed
        amst_mesh_get_edge_faces(mesh, out, capacity, needed)
    end

"""
    vertex_faces(mesh)

`(offsets, faces)`, two `Vector{Int32}`: those around vertex `v`, counter-clockwise, on the boundary from edge to
edge, are `faces[offsets[v]:offsets[v + 1] - 1]`.
"""
function vertex_faces(mesh::Mesh)
    offsets = Vector{Int32}(undef, nvertices(mesh) + 1)
    around = vector_of(Int32) do out, capacity, needed
        amst_mesh_get_vertex_faces(mesh, offsets, out, capacity, needed)
    end
    return (offsets = offsets, faces = around)
end

"""
    find_edges(mesh, pairs)

Edge of each pair of vertices, 0 where there is none, as a `Vector{Int32}`; `pairs` is (2, n).
Throws `DimensionMismatch`, and `AlphaMSTError` RANGE for a vertex that is none.
"""
function find_edges(mesh::Mesh, pairs::AbstractMatrix{<:Integer})
    size(pairs, 1) == 2 || throw(DimensionMismatch("a pair has 2 vertices, not $(size(pairs, 1))"))
    n = size(pairs, 2)
    found = Vector{Int32}(undef, n)
    demand(amst_mesh_find_edges(mesh, Matrix{Int32}(pairs), n, found))
    return found
end

"""
    valences(mesh)

Number of edges at each vertex as a `Vector{Int32}`.
"""
valences(mesh::Mesh) = valences!(Vector{Int32}(undef, nvertices(mesh)), mesh)

"""
    valences!(array, mesh)

The same as [`valences`](@ref), written into an array of the caller, which may be a view.
"""
valences!(array::AbstractVector, mesh::Mesh) =
    fill_with!(Int32, array, (nvertices(mesh),)) do out, capacity, needed
        amst_mesh_get_valences(mesh, out, capacity, needed)
    end

"""
    singularities(mesh)

Interior vertices of valence other than 4, ascending, as a `Vector{Int32}`.
"""
singularities(mesh::Mesh) =
    vector_of(Int32) do out, capacity, needed
        amst_mesh_get_singularities(mesh, out, capacity, needed)
    end

# -------------------------------------------------------------------------- flags

"""
    flags(mesh, entity)

Bits of [`FLAGS`](@ref AlphaMST.FLAGS) of every `:vertex`, `:edge` or `:face` as a `Vector{Int32}`.
"""
flags(mesh::Mesh, entity) = flags!(Vector{Int32}(undef, count_of(mesh, entity)), mesh, entity)

"""
    flags!(array, mesh, entity)

The same as [`flags`](@ref), written into an array of the caller, which may be a view.
"""
flags!(array::AbstractVector, mesh::Mesh, entity) =
    fill_with!(Int32, array, (count_of(mesh, entity),)) do out, capacity, needed
        amst_mesh_get_flags(mesh, number_of(entities, entity), out, capacity, needed)
    end

"""
    set_flags!(mesh, entity, ids = :; fixed, feature, corner)
    set_flags!(mesh, entity, ids, mask, value)

Raise (`true`) or lower (`false`) the flags named for the vertices, edges or faces with these ids,
or for all of them with `:`. Flags not named stay, and so does the revision. The second form sets
the bits in `mask` as they are in `value`. Throws `AlphaMSTError`: ARGUMENT (entity), RANGE (id,
bits that are no flag).
"""
function set_flags!(mesh::Mesh, entity, ids = :; named...)
    mask = value = Int32(0)
    for (name, raised) in named
        bit = number_of(FLAGS, name)
        mask |= bit
        value |= raised ? bit : Int32(0)
    end
    return set_flags!(mesh, entity, ids, mask, value)
end

function set_flags!(mesh::Mesh, entity, ::Colon, mask::Integer, value::Integer)
    demand(amst_mesh_set_flags(mesh, number_of(entities, entity), C_NULL, 0, mask, value))
    return mesh
end

function set_flags!(mesh::Mesh, entity, ids, mask::Integer, value::Integer)
    given = Vector{Int32}(ids)
    isempty(given) && return mesh # its address might be NULL, which stands for all
    demand(amst_mesh_set_flags(mesh, number_of(entities, entity), given, length(given), mask, value))
    return mesh
end

"""
    detect_features!(mesh, angle)

Flag the edges whose two faces have normals more than `angle` degrees apart, 0 to 180, as `feature`,
and as `corner` the vertices where curves of feature edges, these and those of before, end, cross or
turn by more than 60 degrees, but not right back. No flag is taken away. Gives the number of edges at more
than `angle`.
Throws `AlphaMSTError`: NOT_FINITE, RANGE.
"""
detect_features!(mesh::Mesh, angle::Real) =
    Int(scalar(out -> amst_mesh_detect_features(mesh, angle, out), Int64))

# ------------------------------------------------------------------------ undoing

"""
    mark!(mesh)

Remember points, connectivity, flags, markers and fields; gives the revision that names the savepoint. Savepoints
nest; of several with one name the latest is meant.
"""
mark!(mesh::Mesh) = scalar(out -> amst_mesh_mark(mesh, out), Int64)

"""
    rollback!(mesh, revision)

Back to a savepoint, which stays; later ones are forgotten. Patch sets of its revision are current
again. Throws `AlphaMSTError` NOT_FOUND.
"""
function rollback!(mesh::Mesh, revision::Integer)
    demand(amst_mesh_rollback(mesh, revision))
    return mesh
end

"""
    forget!(mesh, revision)

Give up one savepoint; the mesh stays as it is. Throws `AlphaMSTError` NOT_FOUND.
"""
function forget!(mesh::Mesh, revision::Integer)
    demand(amst_mesh_forget(mesh, revision))
    return mesh
end
