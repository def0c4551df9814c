# Wave: adapt while you solve. A ring around the middle of a square runs outwards; before each step the field
# "size" asks for small faces near it, and the mesh changes only where its faces are off that. An energy and a
# temperature come along: the sum of the one and the linear values of the other stay.
#
#   julia --project=bindings/julia examples/julia/wave.jl 6 [wave_]
using AlphaMST
using Printf

const side, middle = 32, 16.0
const first_radius = 5

distance(x, y) = sqrt(x * x + y * y) # from the origin

# A square of unit squares with the two fields.
function square()
    vertices = reduce(hcat, [[x, y] for y in 0.0:side for x in 0.0:side])
    corners = [1, 2, side + 3, side + 2]
    mesh = Mesh(vertices, reduce(hcat, [corners .+ (f + f ÷ side) for f in 0:(side * side - 1)]))
    centres = [(x + 0.5 - middle, y + 0.5 - middle) for y in 0:(side - 1) for x in 0:(side - 1)]
    energy = [1 / (1 + (x * x + y * y) / 32) for (x, y) in centres]
    temperature = [x + 2 * y for (x, y) in eachcol(vertices)]
    set_field!(mesh, :face, "energy", energy; carry = :conserve)
    set_field!(mesh, :vertex, "temperature", temperature; carry = :linear)
    return mesh
end

# The field "size" around the ring: half an edge within 1.5 of it, a whole one from 5 on.
function want_sizes!(mesh, radius)
    away = [abs(distance(x - middle, y - middle) - radius) for (x, y) in eachcol(points(mesh))]
    sizes = [min(max(0.5, 0.5 + 0.5 * (a - 1.5) / 3.5), 1.0) for a in away]
    set_field!(mesh, :vertex, "size", sizes; carry = :linear)
end

total_energy(mesh) = sum(field(mesh, :face, "energy") .* quality(mesh, :area))

function temperature_error(mesh)
    temperature = field(mesh, :vertex, "temperature")
    return maximum(abs(t - x - 2 * y) for (t, (x, y)) in zip(temperature, eachcol(points(mesh))))
end

# The power of ten above a value: its digits are those of rounding, and differ between languages.
function bound(value)
    power, limit = -12, 1e-12
    while power < 0 && !(value < limit)
        power, limit = power + 1, 10 * limit
    end
    return "< 1e$power"
end

function print_row(mesh, report, radius, energy)
    @printf("%6d %6d %6d %6d %9d %12.4f %8s %12s\n", radius, report[:faces_before], report[:faces_wanted],
            report[:faces_after], report[:singular_after], report[:quality_after],
            bound(abs(total_energy(mesh) / energy - 1)), bound(temperature_error(mesh)))
end

function wave(steps, prefix = nothing)
    last_radius = first_radius + steps - 1
    mesh = square()
    energy = total_energy(mesh)
    options = Options(size_band = 0.7)

    @printf("%6s %6s %6s %6s %9s %12s %8s %12s\n", "radius", "before", "wanted", "after", "singular",
            "smallest SJ", "energy", "temperature")
    for radius in first_radius:last_radius
        want_sizes!(mesh, radius)
        report = adapt!(mesh, 1; options)
        print_row(mesh, report, radius, energy)
        prefix === nothing || write("$prefix$radius.svg", mesh)
    end
    want_sizes!(mesh, last_radius) # the last call again
    before = checksum(mesh)
    adapt!(mesh, 1; options)
    println("again: ", checksum(mesh) == before ? "nothing changed" : "the mesh changed")
end

isempty(ARGS) ? error("usage: wave.jl STEPS [PICTURE_PREFIX]") : wave(parse(Int, ARGS[1]), ARGS[2:end]...)
