# What an operation did.

const result_keys = (status = AMST_RESULT_STATUS, faces_before = AMST_RESULT_FACES_BEFORE,
                     faces_after = AMST_RESULT_FACES_AFTER, faces_wanted = AMST_RESULT_FACES_WANTED,
                     singular_before = AMST_RESULT_SINGULAR_BEFORE,
                     singular_after = AMST_RESULT_SINGULAR_AFTER,
                     singular_bound = AMST_RESULT_SINGULAR_BOUND, candidate = AMST_RESULT_CANDIDATE,
                     unused_option = AMST_RESULT_UNUSED_OPTION,
                     alpha = AMST_RESULT_ALPHA, quality_before = AMST_RESULT_QUALITY_BEFORE,
                     quality_after = AMST_RESULT_QUALITY_AFTER, seconds = AMST_RESULT_SECONDS,
                     size_error_before = AMST_RESULT_SIZE_ERROR_BEFORE,
                     size_error_after = AMST_RESULT_SIZE_ERROR_AFTER,
                     least_area_before = AMST_RESULT_LEAST_AREA_BEFORE,
                     least_area_after = AMST_RESULT_LEAST_AREA_AFTER, time_step = AMST_RESULT_TIME_STEP,
                     shortest_edge_before = AMST_RESULT_SHORTEST_EDGE_BEFORE,
                     shortest_edge_after = AMST_RESULT_SHORTEST_EDGE_AFTER,
                     aspect_ratio_before = AMST_RESULT_ASPECT_RATIO_BEFORE,
                     aspect_ratio_after = AMST_RESULT_ASPECT_RATIO_AFTER,
                     area_gained = AMST_RESULT_AREA_GAINED)

"""
    report[key]
    report[patch, key]

What an operation did, in all or to one patch; a `Report` outlives mesh and patches.

| key | |
| --- | --- |
| `:status` | below 0 the patch was left as it was; `status_name` has the name |
| `:faces_before`, `:faces_after`, `:faces_wanted` | the last is alpha * before, rounded, or what `size_band` leaves and asks for |
| `:singular_before`, `:singular_after` | interior vertices of valence other than 4, of a patch with its boundary |
| `:singular_bound` | least number that any filling of the boundary has |
| `:candidate` | 0: filling as predicted; n: geometry forced the n-th later one |
| `:unused_option` | number of the first setting that was given and had no effect on the call, -1 if none |
| `:alpha` | after / before |
| `:quality_before`, `:quality_after` | smallest scaled Jacobian |
| `:seconds` | time spent |
| `:size_error_before`, `:size_error_after` | root mean square of log2(area / wanted area); NaN if no sizes were wanted |
| `:least_area_before`, `:least_area_after` | smallest area / wanted area; NaN likewise |
| `:time_step` | smallest area / perimeter of a face, after over before |
| `:shortest_edge_before`, `:shortest_edge_after` | smallest edge / root of the area wanted there; NaN likewise |
| `:aspect_ratio_before`, `:aspect_ratio_after` | largest aspect ratio of a face |
| `:area_gained` | area after less area before, with `edit_boundary`; else 0 |

The first six rows are `Int64`, the others `Float64`. Over all patches counts are sums, singularities
those of the whole mesh, qualities, areas and edges the smallest, aspect ratios the largest, the size error
is the root mean square over the faces of all patches and the time step that of the whole mesh; an operation
without patches has only that. Sizes are wanted where [`adapt!`](@ref) and [`reduce_singularities!`](@ref)
fill: in patches as they were at the border, and inside as the number of faces asks for; without patches as
they were, as the field `"size"` says or as the curvature asks for, times one factor.
Throws `AlphaMSTError`: RANGE (patch), NOT_FOUND (number of a key that the library does not know).
"""
mutable struct Report <: Handle{amst_report}
    pointer::Ptr{amst_report}

    Report(pointer::Ptr{amst_report}) = finalizer(close, new(pointer))
end

Base.getindex(report::Report, key::Union{Symbol,Integer}) = report[AMST_ALL, key]

function Base.getindex(report::Report, patch::Integer, name::Union{Symbol,Integer})
    key = number_of(result_keys, name)
    is_real(key) && return scalar(out -> amst_report_get_real(report, patch, key, out), Float64)
    return scalar(out -> amst_report_get_int(report, patch, key, out), Int64)
end

"""
    is_partial(report)

Whether some patch was left as it was or has not the wanted number of faces.
"""
is_partial(report::Report) = report[:status] == AMST_PARTIAL

"""
    valence_count(report, valence; after = true)
    valence_count(report, patch, valence; after = true)

Number of interior vertices of one valence after or before the operation, in the whole mesh or in
one patch.
"""
valence_count(report::Report, valence::Integer; after::Bool = true) =
    valence_count(report, AMST_ALL, valence; after = after)

valence_count(report::Report, patch::Integer, valence::Integer; after::Bool = true) =
    Int(scalar(out -> amst_report_get_valence(report, patch, after, valence, out), Int64))

"""
    origin(report, entity)

For each `:vertex`, `:edge` or `:face` of the mesh after the operation the one it was before, 0 if
there is none, as a `Vector{Int32}`. Edges and faces are the same if their vertices are.
"""
origin(report::Report, entity) =
    vector_of(Int32) do out, capacity, needed
        amst_report_get_origin(report, number_of(entities, entity), out, capacity, needed)
    end

"""
    origin!(array, report, entity)

The same as [`origin`](@ref), written into an array of the caller, which may be a view.
"""
function origin!(array::AbstractVector, report::Report, entity)
    code = number_of(entities, entity)
    n = scalar(Int64) do needed
        amst_report_get_origin(report, code, C_NULL, 0, needed)
    end
    return fill_with!(Int32, array, (Int(n),)) do out, capacity, needed
        amst_report_get_origin(report, code, out, capacity, needed)
    end
end
