# The triangles that a curved mesh keeps to.

"""
    set_surface!(mesh)
    set_surface!(mesh, points, triangles)

The surface that operations project the vertices to that they move or add. `points` is (dim, n),
`triangles` is (3, m) with numbers of these points from 1, at least one triangle. Without them it is
the mesh as it is now; until this is called it is the mesh as it is when the first operation on it
begins. It is part of the mesh as fields are; the revision stays. Throws `DimensionMismatch`, and
`AlphaMSTError`: RANGE (no triangle, a corner that is no point), NOT_FINITE.
"""
function set_surface!(mesh::Mesh)
    demand(amst_mesh_set_surface(mesh, C_NULL, 0, C_NULL, 0))
    return mesh
end

function set_surface!(mesh::Mesh, points::AbstractMatrix{<:Real}, triangles::AbstractMatrix{<:Integer})
    size(points, 1) == dim(mesh) ||
        throw(DimensionMismatch("a point of this mesh has $(dim(mesh)) coordinates, not $(size(points, 1))"))
    size(triangles, 1) == 3 ||
        throw(DimensionMismatch("a triangle has 3 corners, not $(size(triangles, 1))"))
    # The address of an empty array might be NULL, which stands for the mesh.
    given = isempty(points) ? zeros(1) : Matrix{Float64}(points)
    demand(amst_mesh_set_surface(mesh, given, size(points, 2), Matrix{Int32}(triangles), size(triangles, 2)))
    return mesh
end
