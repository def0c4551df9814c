# Surface: a torus of triangles that lie at random becomes quads, and a fraction alpha of these, with few
# singular vertices; all vertices stay on the surface.
#
#   julia --project=bindings/julia examples/julia/surface.jl 0.5 [after.svg]
using AlphaMST
using Printf

const around, across = 64, 24
const radius, tube = 1.0, 0.4 # from the axis to the middle of the tube; its radius

# A number of -0.5 to 0.5 at random, the same in every language.
function noise(state)
    state[] = (1103515245 * state[] + 12345) % 2147483648
    return state[] / 2147483648 - 0.5
end

function distance(p)
    off = sqrt(p[1] * p[1] + p[2] * p[2]) - radius
    return abs(sqrt(off * off + p[3] * p[3]) - tube)
end

# The point of the torus that is nearest to p.
function projected(p)
    away = sqrt(p[1] * p[1] + p[2] * p[2])
    off = away - radius
    height = sqrt(off * off + p[3] * p[3])
    wide = (radius + off / height * tube) / away
    return [p[1] * wide, p[2] * wide, p[3] / height * tube]
end

# Of a circle in n parts, by turning from each to the next: sine and cosine are not the same to the last
# digit in every language.
function divided(n, cosine, sine)
    circle = [(1.0, 0.0)]
    for _ in 2:n
        x, y = last(circle)
        push!(circle, (cosine * x - sine * y, sine * x + cosine * y))
    end
    return circle
end

function torus()
    long_way = divided(around, 0.9951847266721969, 0.0980171403295606)
    short_way = divided(2 * across, 0.9914448613738104, 0.13052619222005157)
    points, triangles = Vector{Float64}[], Vector{Int32}[]
    state = Ref(1)
    number(i, j) = i % around * across + j % across + 1
    for i in 0:(around - 1), j in 0:(across - 1)
        at = short_way[2 * j + i % 2 + 1] # every other row by half a cell
        wide = radius + tube * at[1]
        thrown = [0.04 * noise(state) for _ in 1:3]
        push!(points, projected([wide * long_way[i + 1][1], wide * long_way[i + 1][2], tube * at[2]] + thrown))
        a, b, c, d = number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)
        # In even rows the short diagonals are those from b to d.
        append!(triangles, iseven(i) ? [[a, b, d], [b, c, d]] : [[a, b, c], [a, c, d]])
    end
    return reduce(hcat, points), reduce(hcat, triangles)
end

function adapt_torus(alpha, picture = nothing)
    vertices, triangles = torus()
    mesh = Mesh(vertices, triangles)
    n_sharp = detect_features!(mesh, 60)
    set_surface!(mesh, vertices, triangles)
    report = adapt!(mesh, parse(Float64, alpha))

    @printf("%d triangles, %d sharp edges\n", size(triangles, 2), n_sharp)
    @printf("%-24s %6s %6s\n", "", "before", "after")
    @printf("%-24s %6d %6d\n", "faces", report[:faces_before], report[:faces_after])
    @printf("%-24s %6d %6d\n", "singular vertices", report[:singular_before], report[:singular_after])
    @printf("%-24s %6.3f %6.3f\n", "smallest scaled Jacobian", report[:quality_before], report[:quality_after])
    @printf("%.4f from the torus at most\n", maximum(distance, eachcol(points(mesh))))
    picture === nothing || write(picture, mesh)
end

isempty(ARGS) ? error("usage: surface.jl ALPHA [PICTURE]") : adapt_torus(ARGS...)
