# Numeric settings.

const option_keys = (seed = AMST_OPT_SEED, smooth_steps = AMST_OPT_SMOOTH_STEPS,
                     repair_patches = AMST_OPT_REPAIR_PATCHES, candidates = AMST_OPT_CANDIDATES,
                     node_limit = AMST_OPT_NODE_LIMIT, quadrangulate = AMST_OPT_QUADRANGULATE,
                     edit_boundary = AMST_OPT_EDIT_BOUNDARY,
                     strategy = AMST_OPT_STRATEGY, align = AMST_OPT_ALIGN, chart = AMST_OPT_CHART,
                     keep_boundary = AMST_OPT_KEEP_BOUNDARY, starts = AMST_OPT_STARTS,
                     min_quality = AMST_OPT_MIN_QUALITY, min_convexity = AMST_OPT_MIN_CONVEXITY, patch_faces = AMST_OPT_PATCH_FACES,
                     tolerance = AMST_OPT_TOLERANCE, effort = AMST_OPT_EFFORT,
                     size_weight = AMST_OPT_SIZE_WEIGHT, transition = AMST_OPT_TRANSITION,
                     least_size = AMST_OPT_LEAST_SIZE, sharp_angle = AMST_OPT_SHARP_ANGLE,
                     size_band = AMST_OPT_SIZE_BAND, buffer_layers = AMST_OPT_BUFFER_LAYERS,
                     min_edge = AMST_OPT_MIN_EDGE, max_edge = AMST_OPT_MAX_EDGE,
                     gradation = AMST_OPT_GRADATION, error_order = AMST_OPT_ERROR_ORDER)

# The header's rule for the keys of options and of reports.
is_real(key::Int32) = key >= 1000

"""
    Options(; settings...)

Settings of operations, each with a default. Wherever a function takes `settings...`, these
keywords may be given instead, or `options = ` an `Options`, to use it again.

| setting | default | |
| --- | --- | --- |
| `seed` | 0 | of every random choice |
| `smooth_steps` | 20 | sweeps of shape optimisation, 0 to 1000 |
| `repair_patches` | 1 | 0 or 1: fill small holes and cut pinches of new patches |
| `candidates` | 16 | fillings to try in a patch before it is left, 1 to 1000 |
| `node_limit` | 1000 | effort of one exact search, in quads laid, 0 to 10^9 |
| `quadrangulate` | 0 | 0: triangles of a new mesh are paired, 1: every face is split |
| `edit_boundary` | 0 | 0: the boundary of a plane mesh stays vertex for vertex, 1: vertices come and go on it, see below |
| `strategy` | 0 | 0: a whole mesh is adapted by windows, 1: by chords alone |
| `align` | 0 | 0 or 1: edges of curved meshes follow their cross field |
| `chart` | 0 | map of what is curved, 0: a plane or a circle, 1: mean value, 2: conformal, 3: low stretch |
| `keep_boundary` | 0 | 0 or 1: new meshes get no vertex on the boundary, or fail |
| `starts` | 1 | searches of a whole mesh with different luck on the threads of the context, of which the best is kept, 1 to 1000 |
| `min_quality` | 0.0 | no filling with a scaled Jacobian at or below, 0 to 1 |
| `min_convexity` | 0.6 | a patch below has the defect `not_convex`, 0 to 1 |
| `patch_faces` | 100.0 | aim of automatic decomposition, at least 1 |
| `tolerance` | 0.5 | farthest from surface or boundary, in wanted edges, 0.01 to 100 |
| `effort` | 1.0 | times as much is spent on better fillings, 0.01 to 100 |
| `size_weight` | 0.7 | of wanted sizes against shapes, 0 to 1 |
| `transition` | 0.5 | of a patch's depth, over which sizes change, 0.05 to 1 |
| `size_band` | 0.0 | log2 of area; in whole plane meshes with a field `"size"` faces that are off by less stay, 0 to 8 |
| `least_size` | 0.125 | area over wanted area; no smaller face is made, 0 to 1 |
| `sharp_angle` | 40.0 | triangles of a new mesh are not paired over sharper edges, 0 to 180 degrees |
| `buffer_layers` | 2 | layers of faces around each that get the size it asks for by its indicator, 0 to 1000 |
| `min_edge` | 0.0 | least size of an indicator, a length |
| `max_edge` | 0.0 | largest one; 0: the extent of the mesh |
| `gradation` | 0.2 | growth of sizes of an indicator over the length that they grow in, 0.01 to 100 |
| `error_order` | 1.0 | power of the edge length that an indicator is like, 0.1 to 16 |
| `edges` | none | `Matrix(2, n)` of vertices: edges of a new mesh that no pair of triangles crosses |

With `edit_boundary = 1` vertices come and go on the boundary of a plane mesh where edges would be far
from the wanted length, and where that saves singular vertices. Flagged ones, corners and ends of markers
stay; new ones lie on the boundary as it was, or see [`set_projection!`](@ref). On a curved mesh and with
`strategy = 1` it lets chords take vertices from features and boundary where these turn by less than 30
degrees.

`options[:seed]` reads and `options[:seed] = 7` sets one. A mesh is not made if one of the `edges` is no
side of its faces (`AMST_ERR_NOT_FOUND`). Throws `AlphaMSTError` for a value out
of range or not finite, and for a number in place of a name that the library does not know.
"""
mutable struct Options <: Handle{amst_options}
    pointer::Ptr{amst_options}

    function Options(; settings...)
        options = finalizer(close, new(created(amst_options_create, amst_options)))
        for (key, value) in settings
            options[key] = value
        end
        return options
    end
end

function Base.getindex(options::Options, name::Union{Symbol,Integer})
    name === :edges && return reshape(vector_of(Int32) do out, capacity, needed
        amst_options_get_edges(options, out, capacity, needed)
    end, 2, :)
    key = number_of(option_keys, name)
    is_real(key) && return scalar(out -> amst_options_get_real(options, key, out), Float64)
    return scalar(out -> amst_options_get_int(options, key, out), Int64)
end

function Base.setindex!(options::Options, value::Real, name::Union{Symbol,Integer})
    key = number_of(option_keys, name)
    demand(is_real(key) ? amst_options_set_real(options, key, value) :
           amst_options_set_int(options, key, value))
    return options
end

function Base.setindex!(options::Options, edges::AbstractMatrix{<:Integer}, name::Symbol)
    name === :edges || throw(ArgumentError("$name is a number"))
    size(edges, 1) == 2 || throw(DimensionMismatch("an edge has 2 vertices"))
    demand(amst_options_set_edges(options, Matrix{Int32}(edges), size(edges, 2)))
    return options
end

# What a function with the keywords `options = nothing, settings...` hands to the library.
function chosen(options::Union{Options,Nothing}, settings)
    isempty(settings) && return options
    options === nothing || throw(ArgumentError("give options or single settings, not both"))
    return Options(; settings...)
end
