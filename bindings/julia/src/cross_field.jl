# Which way edges should run, and which way they do.

"""
    compute_cross_field!(mesh; settings...)

Give the faces a new field `"cross"`, three numbers also in the plane: a direction of length 1 that edges
shall have there, or one at right angles to it. Along the boundary, features and borders of markers it is
that of the edges, elsewhere a principal direction, the more the curvatures in them differ; and between
that it is as smooth as can be. New faces inherit it. Of the settings `smooth_steps` counts. Throws
`AlphaMSTError` STATE (in a callback).
"""
function compute_cross_field!(mesh::Mesh; options = nothing, settings...)
    demand(amst_mesh_compute_cross_field(mesh, chosen(options, settings)))
    return mesh
end

"""
    alignment(mesh)

Mean angle in degrees, 0 to 45, between the sides of faces and the nearest of the four directions of the
face field `"cross"`: 0 where edges follow it, 22.5 where they do not know of it. Throws `AlphaMSTError`
NOT_FOUND.
"""
alignment(mesh::Mesh) = scalar(out -> amst_mesh_get_alignment(mesh, out), Float64)
