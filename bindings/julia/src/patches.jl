# Disjoint patches of a mesh.

const decompositions = (clusters = AMST_DECOMPOSE_CLUSTERS, partition = AMST_DECOMPOSE_PARTITION,
    voronoi = AMST_DECOMPOSE_VORONOI, medial = AMST_DECOMPOSE_MEDIAL,
    singularities = AMST_DECOMPOSE_SINGULARITIES)

"""
Bits of what is wrong with a patch, by name: `empty`, `not_connected`, `not_disk`, `pinched` (the
boundary touches itself), `overlap`, `crosses_feature` (a flagged entity or border of regions
inside), `odd_boundary`, `corners` (given ones not on the boundary or not in its order), and
`not_convex`, which is only a remark.
"""
const DEFECTS = (empty = AMST_DEFECT_EMPTY, not_connected = AMST_DEFECT_NOT_CONNECTED,
                 not_disk = AMST_DEFECT_NOT_DISK, pinched = AMST_DEFECT_PINCHED,
                 overlap = AMST_DEFECT_OVERLAP, crosses_feature = AMST_DEFECT_CROSSES_FEATURE,
                 odd_boundary = AMST_DEFECT_ODD_BOUNDARY, corners = AMST_DEFECT_CORNERS,
                 not_convex = AMST_DEFECT_NOT_CONVEX)

"""
    Patches(mesh; settings...)

An empty set of patches of the mesh's revision now. Operations that are given the set move it
along; other changes make it stale, and its use an `AlphaMSTError` STALE. The settings that count
are `repair_patches`, `patch_faces`, `min_convexity` and `seed` of [`Options`](@ref).
"""
mutable struct Patches <: Handle{amst_patches}
    pointer::Ptr{amst_patches}
    callbacks::Callbacks

    function Patches(mesh::Mesh; options = nothing, settings...)
        given = chosen(options, settings)
        pointer = created(out -> amst_patches_create(mesh, given, out), amst_patches)
        return finalizer(close, new(pointer, mesh.callbacks))
    end
end

"""
    length(patches)

Number of patches in the set.
"""
Base.length(patches::Patches) =
    Int(scalar(out -> amst_patches_get_count(patches, out), Int64))

# ------------------------------------------------------------------------- adding

"""
    add_faces!(patches, faces)

A new patch of these faces, in any order; gives its id. Faces that an earlier patch has, or that
are fixed, are left out, and the patch is made a disk if it can; with the setting
`repair_patches = 0` such a face is an error. Throws `AlphaMSTError`: RANGE (face), PATCH (none left).
"""
function add_faces!(patches::Patches, faces::AbstractVector{<:Integer})
    given = Vector{Int32}(faces)
    return Int(scalar(out -> amst_patches_add_faces(patches, given, length(given), out), Int32))
end

"""
    add_rings!(patches, vertex, rings)

A new patch of the faces within so many layers of a vertex, 1 for those at it; gives its id.
Throws `AlphaMSTError`: RANGE, PATCH (no face left).
"""
add_rings!(patches::Patches, vertex::Integer, rings::Integer) =
    Int(scalar(out -> amst_patches_add_rings(patches, vertex, rings, out), Int32))

"""
    add_ball!(patches, center, radius)

A new patch of the connected faces around the one nearest to `center` (2 or 3 coordinates) that
have their centroid within `radius`; gives its id. A mesh of dim 2 lies in the plane z = 0.
Throws `AlphaMSTError`: ARGUMENT (radius < 0), NOT_FINITE, PATCH (no face left).
"""
function add_ball!(patches::Patches, center, radius::Real)
    middle = three_coordinates(center)
    return Int(scalar(out -> amst_patches_add_ball(patches, middle, radius, out), Int32))
end

"""
    add_box!(patches, low, high)

A new patch of the faces with their centroid in the box between two points of 2 or 3 coordinates,
of them the largest connected part; gives its id. Throws `AlphaMSTError`: ARGUMENT (low above
high), NOT_FINITE, PATCH (no face left).
"""
function add_box!(patches::Patches, low, high)
    from, to = three_coordinates(low), three_coordinates(high)
    return Int(scalar(out -> amst_patches_add_box(patches, from, to, out), Int32))
end

"""
    decompose!(patches, method = :clusters)

Patches of about `patch_faces` faces over the faces not yet taken, by `:clusters` (compact ones),
`:partition` (balanced graph partition), `:voronoi` (geodesic cells of faces far from one another),
`:medial` (discs: faces within the largest inscribed circles; not every face is in one) or
`:singularities` (faces around singular vertices that lie together; no others); gives the number of
new patches.
"""
decompose!(patches::Patches, method = :clusters) =
    Int(scalar(out -> amst_patches_decompose(patches, number_of(decompositions, method), out), Int64))

# ------------------------------------------------------------------------ setting

"""
    set_corners!(patches, patch, vertices)

Corners of a patch: 3 to 6 vertices of its boundary in counter-clockwise order. With none the
library chooses. Whether they are that is told by `check`. Throws `AlphaMSTError` RANGE.
"""
function set_corners!(patches::Patches, patch::Integer, vertices::AbstractVector{<:Integer})
    demand(amst_patches_set_corners(patches, patch, Vector{Int32}(vertices), length(vertices)))
    return patches
end

"""
    set_alpha!(patches, patch, alpha)
    set_alpha!(patches, alpha)

Wanted ratio of face counts of one patch, or of all that are in the set now; 0 means that of the
operation. Throws `AlphaMSTError`: ARGUMENT (alpha < 0), NOT_FINITE, RANGE.
"""
function set_alpha!(patches::Patches, patch::Integer, alpha::Real)
    demand(amst_patches_set_alpha(patches, patch, alpha))
    return patches
end
set_alpha!(patches::Patches, alpha::Real) = set_alpha!(patches, AMST_ALL, alpha)

# ------------------------------------------------------------------------- asking

"""
    faces(patches, patch)

Faces of a patch, ascending, as a `Vector{Int32}`.
"""
faces(patches::Patches, patch::Integer) =
    vector_of(Int32) do out, capacity, needed
        amst_patches_get_faces(patches, patch, out, capacity, needed)
    end

"""
    boundary(patches, patch)

Vertices of a patch's boundary, counter-clockwise from the first corner, as a `Vector{Int32}`.
Throws `AlphaMSTError` PATCH if the patch is no disk.
"""
boundary(patches::Patches, patch::Integer) =
    vector_of(Int32) do out, capacity, needed
        amst_patches_get_boundary(patches, patch, out, capacity, needed)
    end

"""
    corners(patches, patch)

The corners that were set, otherwise the boundary vertices where one face fits, as a
`Vector{Int32}`. Throws `AlphaMSTError` PATCH if the patch is no disk.
"""
corners(patches::Patches, patch::Integer) =
    vector_of(Int32) do out, capacity, needed
        amst_patches_get_corners(patches, patch, out, capacity, needed)
    end

"""
    check(patches, patch)

`(defects, convexity)` of a patch: bits of [`DEFECTS`](@ref AlphaMST.DEFECTS), 0 if it is usable,
and its area over that of its convex hull, 1 if convex, 0 if it is no disk.
"""
function check(patches::Patches, patch::Integer)
    defects, convexity = Ref(Int32(0)), Ref(0.0)
    demand(amst_patches_check(patches, patch, defects, convexity))
    return (defects = defects[], convexity = convexity[])
end

"""
    predict(patches, patch, alpha; settings...)

`(faces, singularities)` that `adapt!` would deliver for that patch and alpha: exact numbers, the
singularities interior ones. Throws `AlphaMSTError`: ARGUMENT (alpha <= 0), NOT_FINITE, PATCH,
NO_FILLING.
"""
function predict(patches::Patches, patch::Integer, alpha::Real; options = nothing, settings...)
    faces, singularities = Ref{Int64}(0), Ref{Int64}(0)
    given = chosen(options, settings)
    demand(amst_patches_predict(patches, patch, alpha, given, faces, singularities))
    return (faces = Int(faces[]), singularities = Int(singularities[]))
end

"""
    write(path, patches)

Picture (`.svg`) of the mesh with the patch outlines and the singularities.
Throws `AlphaMSTError`: IO, UNSUPPORTED (extension).
"""
function Base.write(path::AbstractString, patches::Patches)
    demand(amst_patches_write(patches, path))
    return nothing
end
