# Undo: two changes, each taken back, and the mesh is bit for bit what it was.
#
#   julia --project=bindings/julia examples/julia/undo.jl examples/data/coast_small.msh
using AlphaMST
using Printf

function undo(path)
    mesh = Mesh(path)
    digest = checksum(mesh)
    row(what) = @printf("%-16s %6d %9d   %s\n", what, nfaces(mesh), length(singularities(mesh)),
                        checksum(mesh) == digest ? "as at the start" : "changed")
    @printf("%-16s %6s %9s\n", "mesh", "faces", "singular")
    row("read")

    first = mark!(mesh)
    patches = Patches(mesh)
    add_ball!(patches, (4.9, 5.3), 0.8)
    adapt!(mesh, patches, 3)
    row("refined")
    second = mark!(mesh)
    smooth!(mesh)
    row("smoothed")
    rollback!(mesh, second)
    row("not smoothed")
    rollback!(mesh, first)
    row("not refined")
    forget!(mesh, first)
end

isempty(ARGS) ? error("usage: undo.jl MESH") : undo(ARGS...)
