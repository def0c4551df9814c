# Chords: those of a plate with a hole in colour; two rings more around the hole, and one less.
#
#   julia --project=bindings/julia examples/julia/chords.jl examples/data/plate.off [chords_]
using AlphaMST
using Printf

# The shortest closed chords first.
rings(mesh) = sort(findall(==(1), chords(mesh, :closed)); by = i -> chords(mesh, :length)[i])
ring(mesh) = chords(mesh, :edge)[first(rings(mesh))]

function show_chords(what, mesh, prefix, name)
    ids = chord_ids(mesh)
    @printf("%-16s %6d %9d %7d %7d\n", what, nfaces(mesh), length(singularities(mesh)), maximum(ids),
            length(rings(mesh)))
    prefix === nothing && return
    set_field!(mesh, :edge, "chord", Float64.(ids); carry = :drop)
    write(prefix * name * ".svg", mesh)
end

function draw(path, prefix = nothing)
    mesh = Mesh(path)
    @printf("%-16s %6s %9s %7s %7s\n", "mesh", "faces", "singular", "chords", "closed")
    show_chords("read", mesh, prefix, "read")
    split_chord!(mesh, ring(mesh), 2)
    show_chords("two rings in", mesh, prefix, "in")
    collapse_chord!(mesh, ring(mesh))
    show_chords("one ring out", mesh, prefix, "out")
end

isempty(ARGS) ? error("usage: chords.jl MESH [PREFIX]") : draw(ARGS...)
