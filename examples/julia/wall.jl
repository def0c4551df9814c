# Wall: a shock runs around a bend between two circles. Under its foot on the outer wall the mesh is
# refined, wall and all, and behind it made coarser again; all vertices of the wall stay on the circle.
#
#   julia --project=bindings/julia examples/julia/wall.jl 4 [wall_]
using AlphaMST
using Printf

const along, across = 64, 16
const inner, outer = 1.0, 2.0

distance(x, y) = sqrt(x * x + y * y) # from the origin

# Of the bend in parts, by turning from each to the next: sine and cosine are not the same to the last digit
# in every language.
function divided()
    cosine, sine = 0.9987954562051724, 0.04906767432741801
    circle = [(1.0, 0.0)]
    for _ in 1:along
        x, y = last(circle)
        push!(circle, (cosine * x - sine * y, sine * x + cosine * y))
    end
    circle[end] = (circle[end][1], 0.0)
    return circle
end

function bend(circle)
    radii = [inner + (outer - inner) * j / across for j in 0:across]
    vertices = reduce(hcat, [[radius * at[1], radius * at[2]] for at in circle for radius in radii])
    corners = [1, 2, across + 3, across + 2]
    quads = reduce(hcat, [corners .+ (f + f ÷ across) for f in 0:(along * across - 1)])
    return Mesh(vertices, quads)
end

# The two ends of the bend are on y = 0, the rest of its boundary on the two circles.
function projected(markers, points)
    result = copy(points)
    for point in eachcol(result)
        point[2] <= 0 && continue
        radius = distance(point...)
        point .*= (radius < (inner + outer) / 2 ? inner : outer) / radius
    end
    return result
end

# The field "size" around the foot of the shock; how many faces that asks for.
function want_sizes!(mesh, foot)
    sizes = [min(0.02 + 0.2 * distance(x - foot[1], y - foot[2]), 0.08) for (x, y) in eachcol(points(mesh))]
    wanted = 0.0
    for (face, area) in zip(eachcol(faces(mesh)), quality(mesh, :area))
        length = (sizes[face[1]] + sizes[face[2]] + sizes[face[3]] + sizes[face[4]]) / 4
        wanted += area / (length * length)
    end
    set_field!(mesh, :vertex, "size", sizes; carry = :linear)
    return wanted
end

function print_row(mesh, step)
    vertices, sides = points(mesh), edge_faces(mesh)
    on_wall, farthest = 0, 0.0
    for (e, (v, w)) in enumerate(eachcol(edges(mesh)))
        radius = distance(vertices[:, v]...)
        (all(sides[:, e] .!= 0) || vertices[2, v] + vertices[2, w] <= 0) && continue
        radius < (inner + outer) / 2 && continue
        on_wall += 1
        farthest = max(farthest, abs(radius - outer), abs(distance(vertices[:, w]...) - outer))
    end
    @printf("%4d %6d %6d %15.12f %12.4f\n", step, nfaces(mesh), on_wall, farthest,
            quality_summary(mesh, :scaled_jacobian).min)
end

function wall(steps, prefix = nothing)
    circle = divided()
    mesh = bend(circle)
    set_projection!(projected, mesh)

    @printf("%4s %6s %6s %15s %12s\n", "step", "faces", "edges", "from the wall", "smallest SJ")
    for step in 0:steps
        if step > 0 # 0: as it was made
            foot = outer .* circle[step * along ÷ (steps + 1) + 1]
            adapt!(mesh, want_sizes!(mesh, foot) / nfaces(mesh); edit_boundary = 1)
        end
        print_row(mesh, step)
        prefix === nothing || write("$prefix$step.svg", mesh)
    end
end

isempty(ARGS) ? error("usage: wall.jl STEPS [PICTURE_PREFIX]") : wall(parse(Int, ARGS[1]), ARGS[2:end]...)
