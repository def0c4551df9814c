# Quality of faces.

const metrics = (area = AMST_METRIC_AREA, aspect_ratio = AMST_METRIC_ASPECT_RATIO,
                 condition = AMST_METRIC_CONDITION, distortion = AMST_METRIC_DISTORTION,
                 edge_ratio = AMST_METRIC_EDGE_RATIO, jacobian = AMST_METRIC_JACOBIAN,
                 max_angle = AMST_METRIC_MAX_ANGLE, min_angle = AMST_METRIC_MIN_ANGLE,
                 oddy = AMST_METRIC_ODDY, radius_ratio = AMST_METRIC_RADIUS_RATIO,
                 relative_size = AMST_METRIC_RELATIVE_SIZE,
                 scaled_jacobian = AMST_METRIC_SCALED_JACOBIAN, shape = AMST_METRIC_SHAPE,
                 shape_and_size = AMST_METRIC_SHAPE_AND_SIZE, shear = AMST_METRIC_SHEAR,
                 shear_and_size = AMST_METRIC_SHEAR_AND_SIZE, skew = AMST_METRIC_SKEW,
                 stretch = AMST_METRIC_STRETCH, taper = AMST_METRIC_TAPER,
                 warpage = AMST_METRIC_WARPAGE)

"""
    quality(mesh, metric)

A Verdict metric of each face as a `Vector{Float64}`: `:area`, `:aspect_ratio`, `:condition`,
`:distortion`, `:edge_ratio`, `:jacobian`, `:max_angle`, `:min_angle`, `:oddy`, `:radius_ratio`,
`:relative_size`, `:scaled_jacobian`, `:shape`, `:shape_and_size`, `:shear`, `:shear_and_size`,
`:skew`, `:stretch`, `:taper` or `:warpage`. Areas and Jacobians are in squared units of the
coordinates, angles in degrees, the others have no unit.
"""
quality(mesh::Mesh, metric) = quality!(Vector{Float64}(undef, nfaces(mesh)), mesh, metric)

"""
    quality!(array, mesh, metric)

The same as [`quality`](@ref), written into an array of the caller, which may be a view.
"""
quality!(array::AbstractVector, mesh::Mesh, metric) =
    fill_with!(Float64, array, (nfaces(mesh),)) do out, capacity, needed
        amst_mesh_get_quality(mesh, number_of(metrics, metric), out, capacity, needed)
    end

"""
    quality_summary(mesh, metric)

`count`, `acceptable`, `min`, `max`, `mean` and `stddev` of a metric of [`quality`](@ref) over all
faces; `acceptable` is the number of faces inside the metric's acceptable range.
"""
function quality_summary(mesh::Mesh, metric)
    out = Ref(amst_summary(0, 0, 0, 0, 0, 0))
    demand(amst_mesh_get_summary(mesh, number_of(metrics, metric), out))
    return out[]
end
