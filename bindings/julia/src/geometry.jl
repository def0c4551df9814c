# What a code needs of faces and edges that solves on the mesh.

const geometries = (centroids = AMST_GEOMETRY_CENTROIDS, lengths = AMST_GEOMETRY_LENGTHS,
                    normals = AMST_GEOMETRY_NORMALS)

"""
    geometry(mesh, key)

`:centroids` of faces, `Matrix(dim, nfaces)`; `:lengths` of edges, a `Vector`; or their `:normals`,
`Matrix(dim, nedges)`, of length 1 and out of the first face of [`edge_faces`](@ref), so on the boundary outwards;
on curved meshes at right angles to the mean normal of the faces. Areas are [`quality`](@ref)`(mesh, :area)`.
"""
function geometry(mesh::Mesh, key)
    number = number_of(geometries, key)
    values = vector_of(Float64) do out, capacity, needed
        amst_mesh_get_geometry(mesh, number, out, capacity, needed)
    end
    return number == AMST_GEOMETRY_LENGTHS ? values : reshape(values, dim(mesh), :)
end
