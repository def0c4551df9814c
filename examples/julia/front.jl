# Refine around a moving front: at every step the mesh is fine where the front is and as it was
# everywhere else.
#
#   julia --project=bindings/julia examples/julia/front.jl examples/data/coast_small.msh [front_]
using AlphaMST
using Printf

function front(path, prefix = nothing)
    mesh = Mesh(path)
    coarse = mark!(mesh)

    @printf("%4s %6s %6s %9s %12s\n", "step", "near", "faces", "singular", "smallest SJ")
    for step in 0:4
        rollback!(mesh, coarse) # the front has moved on
        patches = Patches(mesh)
        add_ball!(patches, (4.2 + 0.3 * step, 5.2 + 0.05 * step), 0.8)
        report = adapt!(mesh, patches, 2)
        @printf("%4d %6d %6d %9d %12.4f\n", step, report[:faces_after], nfaces(mesh),
                report[:singular_after], report[:quality_after])
        prefix === nothing || write("$prefix$step.svg", patches)
    end
end

isempty(ARGS) ? error("usage: front.jl MESH [PICTURE_PREFIX]") : front(ARGS...)
