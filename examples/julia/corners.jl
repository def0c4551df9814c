# Choose the faces of a patch by hand and ask what would come with corners set by hand and with
# those of the library; then take the latter.
#
#   julia --project=bindings/julia examples/julia/corners.jl examples/data/coast_small.msh [after.svg]
using AlphaMST
using Printf

# Faces whose centroid is in the ellipse around (4.9, 5.3).
function choose(mesh)
    xy, quads = points(mesh), faces(mesh)
    inside(x, y) = (x - 4.9)^2 / 1.2 + (y - 5.3)^2 / 0.7 < 1
    return [f for f in axes(quads, 2) if inside(sum(xy[:, v] ./ 4 for v in quads[:, f])...)]
end

# Four boundary vertices, a quarter of the boundary from one to the next.
function quarters(patches, patch)
    loop = boundary(patches, patch)
    return [loop[k*length(loop)÷4+1] for k in 0:3]
end

function compare(path, picture = nothing)
    mesh = Mesh(path)
    chosen = choose(mesh)
    patches = Patches(mesh)
    patch = add_faces!(patches, chosen)
    defects, convexity = check(patches, patch)
    @printf("%d faces chosen, defects %d, convexity %.3f\n", length(chosen), defects, convexity)

    @printf("%5s %6s %18s %18s\n", "alpha", "faces", "singular, by hand", "by the library")
    for alpha in (0.75, 1, 1.5, 2)
        set_corners!(patches, patch, quarters(patches, patch))
        by_hand = predict(patches, patch, alpha)
        set_corners!(patches, patch, Int[])
        foreseen = predict(patches, patch, alpha)
        @printf("%5.2f %6d %18d %18d\n", alpha, foreseen.faces, by_hand.singularities, foreseen.singularities)
    end
    report = adapt!(mesh, patches, 1.5)
    @printf("%5s %6d %18s %18d\n", "done", report[patch, :faces_after], "", report[patch, :singular_after])
    picture === nothing || write(picture, patches)
end

isempty(ARGS) ? error("usage: corners.jl MESH [PICTURE]") : compare(ARGS...)
