# From error to mesh.

"""
    size_from_indicator!(mesh, indicator; tolerance = 0, faces = 0, settings...)

Writes the vertex field `"size"` that [`adapt!`](@ref) goes by, and returns how many faces it asks for. The
indicator of a face is what it contributes to the error, at least 0, like `h^error_order` for edges of length h;
where fronts are sharp the jump across the face will do. Given a `tolerance`, each face asks for edges at which
its indicator is that, and `faces` is a limit of their number, 0: none; without one there will be as many
`faces`, with equal error everywhere. Of the settings `error_order`, `min_edge`, `max_edge`, `gradation` and
`buffer_layers` count. Throws `AlphaMSTError` RANGE, ARGUMENT (`max_edge` below `min_edge`), NOT_FINITE.
"""
function size_from_indicator!(mesh::Mesh, indicator::AbstractVector{<:Real}; tolerance = 0, faces = 0,
                              options = nothing, settings...)
    values, asked = Vector{Float64}(indicator), Ref{Float64}(0)
    demand(amst_mesh_size_from_indicator(mesh, values, length(values), tolerance, faces,
                                         chosen(options, settings), asked))
    return asked[]
end
