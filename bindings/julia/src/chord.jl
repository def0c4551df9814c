# Chords: the rows of faces met when each is left through the edge opposite to the one it was entered by.

const chord_properties = (edge = AMST_CHORD_EDGE, closed = AMST_CHORD_CLOSED, length = AMST_CHORD_LENGTH,
                          faces = AMST_CHORD_FACES, crossings = AMST_CHORD_CROSSINGS,
                          touches = AMST_CHORD_TOUCHES, singularities = AMST_CHORD_SINGULARITIES,
                          refusal = AMST_CHORD_REFUSAL, singular_after = AMST_CHORD_SINGULAR_AFTER)

"""
Bits of why a chord cannot be collapsed, by name: `crossing` (it crosses itself), `closed` (its borders
meet), `boundary` (it would join boundary vertices or, not allowed, change the boundary), `fixed`,
`feature`, `valence` (below 3 or above 6), `double` (two edges would have the same vertices).
"""
const REFUSALS = (crossing = AMST_REFUSAL_CROSSING, closed = AMST_REFUSAL_CLOSED,
                  boundary = AMST_REFUSAL_BOUNDARY, fixed = AMST_REFUSAL_FIXED,
                  feature = AMST_REFUSAL_FEATURE, valence = AMST_REFUSAL_VALENCE,
                  double = AMST_REFUSAL_DOUBLE)

"""
    chord(mesh, edge)

The chord through an edge: `(edges, closed, crossings)`. The edges it crosses are in order, from that
edge round if it is closed, else from its end with the smaller edge; `crossings` counts the faces it
passes twice. Throws `AlphaMSTError` RANGE.
"""
function chord(mesh::Mesh, edge::Integer)
    closed, crossings = Ref(Int32(0)), Ref(Int64(0))
    edges = vector_of(Int32) do out, capacity, needed
        amst_mesh_get_chord(mesh, edge, closed, crossings, out, capacity, needed)
    end
    return (edges = edges, closed = closed[] != 0, crossings = crossings[])
end

"""
    chord_ids(mesh)

The number of the chord of each edge as a `Vector{Int32}`; chords are numbered in the order of their
smallest edges. As an edge field `"chord"` they are drawn in colour by `write`.
"""
chord_ids(mesh::Mesh) =
    vector_of(Int32) do out, capacity, needed
        amst_mesh_get_chord_ids(mesh, C_NULL, out, capacity, needed)
    end

"""
    chords(mesh, property; settings...)

A property of each chord as a `Vector{Int64}`: `:edge` (its smallest one), `:closed` (1 or 0), `:length`
(faces it passes, those passed twice counted twice), `:faces` (counted once), `:crossings`, `:touches`
(vertices at more than one of its edges), `:singularities` (at its edges), `:refusal` (bits of
[`REFUSALS`](@ref AlphaMST.REFUSALS), 0 if it can be collapsed), `:singular_after` (singular vertices of
the mesh once it is). Of the settings `edit_boundary` counts.
"""
function chords(mesh::Mesh, property; options = nothing, settings...)
    given, number = chosen(options, settings), number_of(chord_properties, property)
    return vector_of(Int64) do out, capacity, needed
        amst_mesh_get_chords(mesh, number, given, out, capacity, needed)
    end
end

"""
    collapse_chord!(mesh, edge; settings...)

Remove the chord through an edge: the two ends of each of its edges become one vertex. The faces around it
are smoothed. Gives a [`Report`](@ref). Throws as [`adapt!`](@ref), and CHORD with the reason, GEOMETRY.
"""
function collapse_chord!(mesh::Mesh, edge::Integer; options = nothing, settings...)
    given = chosen(options, settings)
    return operate(out -> amst_collapse_chord(mesh, edge, given, out), mesh)
end

"""
    split_chord!(mesh, edge, n = 1; settings...)

Cut the chord through an edge into n + 1 parallel ones; no vertex becomes singular. One that ends on the
boundary needs `edit_boundary = 1`. Throws as [`collapse_chord!`](@ref).
"""
function split_chord!(mesh::Mesh, edge::Integer, n::Integer = 1; options = nothing, settings...)
    given = chosen(options, settings)
    return operate(out -> amst_split_chord(mesh, edge, n, given, out), mesh)
end

"""
    insert_chords!(mesh, patches, n = 1; settings...)

Lay n rings of faces between the boundary of each patch, which stays, and its faces. A patch needs 3 to 6
corners (boundary vertices with one of its faces), or none, and two of its faces at all other boundary
vertices; others are left, see [`is_partial`](@ref). Throws as [`adapt!`](@ref), and RANGE (n).
"""
function insert_chords!(mesh::Mesh, patches::Patches, n::Integer = 1; options = nothing, settings...)
    given = chosen(options, settings)
    return operate(out -> amst_insert_chords(mesh, patches, n, given, out), mesh)
end
