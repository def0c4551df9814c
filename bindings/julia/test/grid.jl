# Meshes and questions that the tests share.

# Vertex (i, j), counted from 0, has column j * (nx + 1) + i + 1 and lies at (i, j).
grid_points(nx, ny) = reduce(hcat, [[Float64(i), Float64(j)] for j in 0:ny for i in 0:nx])

# Face (i, j), counted from 0, has column j * nx + i + 1.
function grid_faces(nx, ny; type = Int32)
    corners(i, j) = (v = j * (nx + 1) + i + 1; type[v, v + 1, v + nx + 2, v + nx + 1])
    return reduce(hcat, [corners(i, j) for j in 0:ny-1 for i in 0:nx-1])
end

grid(nx, ny = nx; keywords...) = Mesh(grid_points(nx, ny), grid_faces(nx, ny); keywords...)

# The faces (i, j) with low <= i, j < high of a grid of nx columns.
square(nx, low, high) = [j * nx + i + 1 for j in low:high-1 for i in low:high-1]

# A mesh of 10 x 10 faces with one patch in the middle.
function grid_with_square(; keywords...)
    mesh = grid(10; keywords...)
    patches = Patches(mesh)
    add_faces!(patches, square(10, 2, 8))
    return mesh, patches
end

# What `f` throws, or nothing.
function thrown(f)
    try
        f()
        return nothing
    catch failure
        return failure
    end
end

# The name of the status that `f` fails with.
function refusal(f)
    failure = thrown(f)
    return failure isa AlphaMSTError ? status_name(failure.code) : failure
end
