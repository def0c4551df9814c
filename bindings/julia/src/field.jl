# Named numbers on vertices, edges and faces.

const carries = (drop = AMST_CARRY_DROP, inherit = AMST_CARRY_INHERIT, linear = AMST_CARRY_LINEAR,
                 conserve = AMST_CARRY_CONSERVE, average = AMST_CARRY_AVERAGE)

"""
    set_field!(mesh, entity, name, values; carry)

Give every `:vertex`, `:edge` or `:face` numbers under a name: `values[i]`, or the column
`values[:, i]`, belongs to entity i. A field of that name there is replaced. The revision stays.

An operation keeps the values of what it keeps. New entities get theirs by `carry`:

* `:drop`: the field goes with an operation that changes connectivity
* `:inherit`: from the nearest entity that was there
* `:linear`, for vertices, also where they have moved: interpolated
* `:conserve`, for faces and vertices: the mean over the face, or over the quarters of faces at the vertex;
  the sum of value times area stays. The field before is taken as linear on each of them
* `:average`: as `:conserve`, but the field before is taken as constant there

The library reads `"size"`, one number above 0 at each vertex: the wanted edge length; and `"cross"`, three
at each face, see [`compute_cross_field!`](@ref). [`adapt!`](@ref) and [`reduce_singularities!`](@ref) write
to `"size error"`, one number at each face, if it is there, log2(area / wanted area) where they want sizes;
pictures show it in colour. Throws `AlphaMSTError`: ARGUMENT (entity, name, carry not
for this entity), RANGE (number of values, a size not above 0), NOT_FINITE.
"""
set_field!(mesh::Mesh, entity, name::AbstractString, values::AbstractVector{<:Real}; carry) =
    set_field!(mesh, entity, name, reshape(values, 1, :); carry = carry)

function set_field!(mesh::Mesh, entity, name::AbstractString, values::AbstractMatrix{<:Real}; carry)
    packed = is_packed(values) && eltype(values) === Float64 ? values : Matrix{Float64}(values)
    demand(amst_mesh_set_field(mesh, number_of(entities, entity), name, size(packed, 1),
                               number_of(carries, carry), packed, size(packed, 2)))
    return mesh
end

"""
    field(mesh, entity, name)

The numbers of [`set_field!`](@ref) as they are now: a `Vector{Float64}` if each entity has one, else
a `Matrix{Float64}` with a column for each. Throws `AlphaMSTError`: ARGUMENT (entity, name),
NOT_FOUND.
"""
function field(mesh::Mesh, entity, name::AbstractString)
    values = vector_of(Float64) do out, capacity, needed
        amst_mesh_get_field(mesh, number_of(entities, entity), name, out, capacity, needed)
    end
    n = count_of(mesh, entity)
    return length(values) == n ? values : reshape(values, :, n)
end

"""
    field!(array, mesh, entity, name)

The same as [`field`](@ref), written into a vector or matrix of the caller, which may be a view.
"""
function field!(array::AbstractVecOrMat, mesh::Mesh, entity, name::AbstractString)
    get(out, capacity, needed) =
        amst_mesh_get_field(mesh, number_of(entities, entity), name, out, capacity, needed)
    n = count_of(mesh, entity)
    components = div(scalar(needed -> get(C_NULL, 0, needed), Int64), n)
    shape = array isa AbstractVector && components == 1 ? (n,) : (Int(components), n)
    return fill_with!(get, Float64, array, shape)
end

"""
    remove_field!(mesh, entity, name)

Throws `AlphaMSTError`: ARGUMENT (entity, name), NOT_FOUND.
"""
function remove_field!(mesh::Mesh, entity, name::AbstractString)
    demand(amst_mesh_remove_field(mesh, number_of(entities, entity), name))
    return mesh
end

"""
    overlap(before, after)

What the faces of two meshes of one domain share, as a `copy` of a mesh and that mesh after an operation:
`(before, after, area)`, three vectors with one element for each pair of faces that overlap, ascending by
`after`, then `before`. In a plane the areas of a face sum up to its own where the other mesh covers it. Throws
`AlphaMSTError`: ARGUMENT (one mesh has dim 2, the other 3).
"""
function overlap(before::Mesh, after::Mesh)
    # Mostly enough, so that the work is done once: a face meets about four, on either side.
    capacity = 4 * (nfaces(before) + nfaces(after))
    while true
        ids, others, areas = Vector{Int32}(undef, capacity), Vector{Int32}(undef, capacity), zeros(capacity)
        needed = Ref{Int64}(0)
        status = amst_mesh_get_overlap(before, after, ids, others, areas, capacity, needed)
        if status != AMST_ERR_BUFFER_TOO_SMALL
            demand(status)
            return (before = resize!(ids, needed[]), after = resize!(others, needed[]),
                    area = resize!(areas, needed[]))
        end
        capacity = needed[]
    end
end
