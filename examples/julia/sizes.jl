# Sizes: what the report tells of the faces of two patches and of both together, for several alphas.
#
#   julia --project=bindings/julia examples/julia/sizes.jl examples/data/coast_small.msh [after_]
using AlphaMST
using Printf

function print_row(alpha, name, report, place...)
    at(key) = report[place..., key]
    @printf("%5.1f %5s %6d %9d %7.2f %7.2f %7.2f %7.2f %7.2f %7.2f\n", alpha, name, at(:faces_after),
            at(:singular_after), at(:size_error_before), at(:size_error_after), at(:least_area_after),
            at(:shortest_edge_after), at(:aspect_ratio_after), at(:time_step))
end

function sizes(path, prefix = nothing)
    mesh = Mesh(path)
    begun = mark!(mesh)

    @printf("%5s %5s %6s %9s %7s %7s %7s %7s %7s %7s\n", "alpha", "patch", "faces", "singular", "before",
            "after", "area", "edge", "aspect", "step")
    for (i, alpha) in enumerate((0.5, 1, 2, 4))
        rollback!(mesh, begun)
        patches = Patches(mesh)
        add_ball!(patches, (4.2, 5.2), 0.7)
        add_ball!(patches, (6.0, 5.0), 0.7)
        report = adapt!(mesh, patches, alpha)
        print_row(alpha, "1", report, 1)
        print_row(alpha, "2", report, 2)
        print_row(alpha, "both", report)
        prefix === nothing || write("$prefix$(i - 1).svg", patches)
    end
end

isempty(ARGS) ? error("usage: sizes.jl MESH [PICTURE_PREFIX]") : sizes(ARGS...)
