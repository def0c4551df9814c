"""
Adapts meshes of quadrilaterals patch by patch: the Julia binding of the library AlphaMST.

    using AlphaMST
    mesh = Mesh("coast.msh")
    patches = Patches(mesh)
    add_ball!(patches, (5.8, 4.8), 0.6)
    report = adapt!(mesh, patches, 2.0; seed = 7)     # twice the faces
    report[:faces_after]
    write("finer.vtk", mesh)

Rules that hold for every function:

* Vertices, edges, faces and patches are numbered from 1 and index Julia arrays directly; 0 is
  "none". Ids are valid for one revision of the mesh.
* Arrays have one column for each point, face or edge: `points` is (dim, n), `faces` is (4, n),
  corners counter-clockwise. Lengths are in the unit of the given coordinates, angles in degrees.
* A failure throws an [`AlphaMSTError`](@ref) and leaves everything as it was.
* Contexts, options, meshes, patch sets and reports end with `close`, or when they are collected,
  in any order. Using one after `close` throws an `InvalidStateException`.
* Functions without `!` may run on one mesh from several threads at the same time. A function with
  `!` needs its mesh, patch set, options or context to itself; one context serves one thread at a
  time, different contexts share nothing.
* Names are symbols, e.g. `:vertex` or `:scaled_jacobian`. Where a symbol is taken, so is the
  number it has in `alphamst.h`, for what a later library knows and this package does not.
"""
module AlphaMST

include("LibAlphaMST.jl")
using .LibAlphaMST
using .LibAlphaMST: gc_unsafe, load
using Libdl: find_library

include("library.jl")
include("error.jl")
include("handle.jl")
include("array.jl")
include("options.jl")
include("context.jl")
include("mesh.jl")
include("markers.jl")
include("field.jl")
include("cross_field.jl")
include("surface.jl")
include("boundary.jl")
include("geometry.jl")
include("indicator.jl")
include("quality.jl")
include("patches.jl")
include("report.jl")
include("operations.jl")
include("chord.jl")

export AlphaMSTError, Context, Mesh, Options, Patches, Report
export library_version, library_has, status_name
export progress, set_cancel!, set_log!, set_progress!, set_threads!
export check, checksum, crossed_edges, detect_features!, dim, edge_faces, edge_faces!, edges, edges!, faces, faces!, find_edges, flags,
    flags!, nedges, nfaces, nvertices, points, points!, revision, set_flags!, set_points!,
    singularities, split_edges, valences, valences!, vertex_faces
export marker_list, marker_name, markers, markers!, set_marker_name!, set_markers!
export geometry, size_from_indicator!
export field, field!, overlap, remove_field!, set_field!
export alignment, compute_cross_field!
export set_projection!
export set_surface!
export forget!, mark!, rollback!
export quality, quality!, quality_summary
export add_ball!, add_box!, add_faces!, add_rings!, boundary, corners, decompose!, predict, set_alpha!,
    set_corners!
export is_partial, origin, origin!, valence_count
export adapt!, clean!, reduce_singularities!, smooth!
export chord, chord_ids, chords, collapse_chord!, insert_chords!, split_chord!

end
