# Numbers of boundaries, regions and points, and their names.

"""
    markers(mesh, entity)

The marker of every `:vertex`, `:edge` or `:face` as a `Vector{Int32}`, 0 for none: the number of a point, of
a boundary or line inside, of a region. Operations keep what is marked; vertices with a marker are
[`FLAGS`](@ref AlphaMST.FLAGS)`.corner`.
"""
markers(mesh::Mesh, entity) = markers!(Vector{Int32}(undef, count_of(mesh, entity)), mesh, entity)

"""
    markers!(array, mesh, entity)

The same as [`markers`](@ref), written into an array of the caller, which may be a view.
"""
markers!(array::AbstractVector, mesh::Mesh, entity) =
    fill_with!(Int32, array, (count_of(mesh, entity),)) do out, capacity, needed
        amst_mesh_get_markers(mesh, number_of(entities, entity), out, capacity, needed)
    end

"""
    set_markers!(mesh, entity, ids, value)

Give the vertices, edges or faces with these ids, or all of them with `:`, the marker `value`, 0 for none. The
revision stays. Throws `AlphaMSTError`: ARGUMENT (entity), RANGE (id).
"""
function set_markers!(mesh::Mesh, entity, ::Colon, value::Integer)
    demand(amst_mesh_set_markers(mesh, number_of(entities, entity), C_NULL, 0, value))
    return mesh
end

function set_markers!(mesh::Mesh, entity, ids, value::Integer)
    given = Vector{Int32}(ids)
    isempty(given) && return mesh # its address might be NULL, which stands for all
    demand(amst_mesh_set_markers(mesh, number_of(entities, entity), given, length(given), value))
    return mesh
end

"""
    marker_list(mesh, entity)

The markers that some `:vertex`, `:edge` or `:face` has, ascending, without 0.
"""
marker_list(mesh::Mesh, entity) =
    vector_of(Int32) do out, capacity, needed
        amst_mesh_get_marker_list(mesh, number_of(entities, entity), out, capacity, needed)
    end

"""
    marker_name(mesh, entity, marker)

What the marker is called; "" if it has no name.
"""
function marker_name(mesh::Mesh, entity, marker::Integer)
    text = vector_of(UInt8) do out, capacity, needed
        amst_mesh_get_marker_name(mesh, number_of(entities, entity), marker, out, capacity, needed)
    end
    return String(text[1:end-1]) # without the zero that ends it
end

"""
    set_marker_name!(mesh, entity, marker, name)

Call a marker of vertices, edges or faces by a name; "" takes the name away. Files that can hold names have
them, see [`write`](@ref). Throws `AlphaMSTError`: ARGUMENT (entity, marker 0, a name with double quotes or
control characters).
"""
function set_marker_name!(mesh::Mesh, entity, marker::Integer, name::AbstractString)
    demand(amst_mesh_set_marker_name(mesh, number_of(entities, entity), marker, name))
    return mesh
end
