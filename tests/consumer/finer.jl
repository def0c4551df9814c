# An outside script in Julia.
using AlphaMST

n = 8
points = [k == 1 ? Float64(i) : Float64(j) for k in 1:2, (i, j) in vec([(i, j) for i in 0:n, j in 0:n])]
faces = [(j * (n + 1) + i + 1) .+ (0, 1, n + 2, n + 1)[k] for k in 1:4, (i, j) in vec([(i, j) for i in 0:n-1, j in 0:n-1])]
mesh = Mesh(points, faces)
patches = Patches(mesh)
add_ball!(patches, [4.0, 4.0, 0.0], 2.5)
adapt!(mesh, patches, 2)
check(mesh)
println(nfaces(mesh), " faces")
nfaces(mesh) > n^2 || error("the mesh is no finer")
