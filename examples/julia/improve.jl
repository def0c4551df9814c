# Improve a region: fewer singular vertices and better corners with the same number of faces.
#
#   julia --project=bindings/julia examples/julia/improve.jl examples/data/coast_small.msh [after.svg]
using AlphaMST
using Printf

function improve(path, picture = nothing)
    mesh = Mesh(path)
    patches = Patches(mesh)
    add_box!(patches, (3.8, 4.4), (6.2, 6.4))
    report = adapt!(mesh, patches, 1)

    @printf("%-8s %6s %9s %12s\n", "region", "faces", "singular", "smallest SJ")
    @printf("%-8s %6d %9d %12.4f\n", "before", report[1, :faces_before], report[1, :singular_before],
            report[1, :quality_before])
    @printf("%-8s %6d %9d %12.4f\n", "after", report[1, :faces_after], report[1, :singular_after],
            report[1, :quality_after])
    picture === nothing || write(picture, patches)
end

isempty(ARGS) ? error("usage: improve.jl MESH [PICTURE]") : improve(ARGS...)
