# Simplify: three faces where there were four, patch by patch over the whole mesh. A patch that
# cannot have its wanted faces is left as it was.
#
#   julia --project=bindings/julia examples/julia/simplify.jl examples/data/coast_small.msh [after.svg]
using AlphaMST
using Printf

function simplify(path, picture = nothing)
    options = Options(patch_faces = 80, seed = 7)
    mesh = Mesh(path; options = options)
    patches = Patches(mesh; options = options)
    n = decompose!(patches, :clusters)
    report = adapt!(mesh, patches, 0.75; options = options)

    left = 0
    @printf("%5s %6s %6s %6s %9s\n", "patch", "before", "wanted", "after", "singular")
    for patch in 1:n
        is_left = report[patch, :status] < 0
        left += is_left
        @printf("%5d %6d %6d %6d %9d%s\n", patch, report[patch, :faces_before], report[patch, :faces_wanted],
                report[patch, :faces_after], report[patch, :singular_after], is_left ? "  left" : "")
    end
    println("$left of $n patches left")
    picture === nothing || write(picture, patches)
end

isempty(ARGS) ? error("usage: simplify.jl MESH [PICTURE]") : simplify(ARGS...)
