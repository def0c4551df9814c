# What the binding costs over the library: nanoseconds of a question with one number for an
# answer over the raw call, and the time of filling arrays with 10^6 vertices over that of copying
# as many bytes.
#
#   julia --project=bindings/julia bindings/julia/benchmark/overhead.jl
using AlphaMST
using AlphaMST: LibAlphaMST
using Printf

const n = 999 # 10^6 vertices

function large_mesh()
    xy = reduce(hcat, [[Float64(i), Float64(j)] for j in 0:n for i in 0:n])
    first_corner = [j * (n + 1) + i + 1 for j in 0:n-1 for i in 0:n-1]
    return Mesh(xy, permutedims(hcat(first_corner, first_corner .+ 1, first_corner .+ (n + 2), first_corner .+ (n + 1))))
end

# The least seconds of several rounds: what is above is the machine's other work.
function least(f, rounds)
    f()
    return minimum(@elapsed(f()) for _ in 1:rounds)
end

const calls = 10^6

function ask_raw(mesh)
    out, sum = Ref{Int64}(0), 0
    for _ in 1:calls
        LibAlphaMST.amst_mesh_get_revision(mesh, out)
        sum += out[]
    end
    return sum
end

ask(mesh) = sum(revision(mesh) for _ in 1:calls)

function compare(name, array, get!)
    target, source = similar(array), get!(array)
    copying = least(() -> copyto!(target, source), 30)
    getting = least(() -> get!(array), 30)
    @printf("%-12s %8.3f ms   copy %8.3f ms   ratio %5.2f\n", name, 1e3 * getting, 1e3 * copying, getting / copying)
end

function main()
    mesh = large_mesh()
    raw, idiomatic = least(() -> ask_raw(mesh), 10), least(() -> ask(mesh), 10)
    @printf("%-12s %8.1f ns   raw  %8.1f ns   over  %5.1f ns\n", "revision", 1e9 * idiomatic / calls,
            1e9 * raw / calls, 1e9 * (idiomatic - raw) / calls)
    compare("points!", zeros(2, nvertices(mesh)), array -> points!(array, mesh))
    compare("faces!", zeros(Int32, 4, nfaces(mesh)), array -> faces!(array, mesh))
    xy = points(mesh)
    raw_points() = LibAlphaMST.amst_mesh_get_points(mesh, xy, length(xy), Ref{Int64}(0))
    bound, raw_bound = least(() -> points!(xy, mesh), 30), least(raw_points, 30)
    @printf("%-12s %8.3f ms   raw  %8.3f ms   ratio %5.2f\n", "points!", 1e3 * bound, 1e3 * raw_bound, bound / raw_bound)
end

main()
