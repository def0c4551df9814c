# A square of 8 x 8 faces, bent to the disk of radius 1: 32 edges on its rim, and no corner.
function disk(; keywords...)
    points = grid_points(8, 8) ./ 4 .- 1
    for column in eachcol(points)
        most, radius = maximum(abs, column), max(hypot(column...), 1e-300)
        column .*= most * most / radius + (1 - most) * 0.7
    end
    return Mesh(points, grid_faces(8, 8); keywords...)
end

function radii(mesh)
    all, sides = edges(mesh), edge_faces(mesh)
    rim = all[1, vec(any(sides .== 0, dims = 1))]
    return [hypot(point...) for point in eachcol(points(mesh)[:, rim])]
end

to_circle(markers, points) = points ./ sqrt.(sum(abs2, points; dims = 1))
refine(mesh) = adapt!(mesh, 4; edit_boundary = 1)

@testset "new vertices lie on the circle" begin
    mesh = disk()
    seen = Tuple{Vector{Int32},Matrix{Float64}}[]
    @test set_projection!(mesh) do markers, points
        push!(seen, (markers, points))
        to_circle(markers, points)
    end === mesh
    @test 0.01 < refine(mesh)[:area_gained] < 0.1 # what the chords had cut off the disk
    check(mesh)
    found = radii(mesh)
    @test nfaces(mesh) == 256 && length(found) > 48
    @test all(abs.(found .- 1) .<= 1e-12)
    @test length(seen) == 2
    @test all(((markers, points),) -> all(iszero, markers) && size(points) == (2, length(markers)), seen)
    @test all(isfinite, seen[1][2]) # they are the caller's
end

@testset "without the option, or any more, nobody asks" begin
    mesh = disk()
    set_projection!((markers, points) -> error("asked"), mesh)
    adapt!(mesh, 4)
    @test length(radii(mesh)) == 32
    set_projection!(nothing, mesh)
    refine(mesh)
    @test length(radii(mesh)) > 32
end

@testset "copies keep the projection" begin
    function made(calls)
        mesh = disk()
        set_projection!(mesh) do markers, points
            calls[] += 1
            to_circle(markers, points)
        end
        return copy(mesh)
    end
    calls = Ref(0)
    mesh = made(calls)
    foreach(_ -> GC.gc(), 1:3)
    refine(mesh)
    @test all(abs.(radii(mesh) .- 1) .<= 1e-12)
    @test calls[] == 2
end

@testset "a failing projection changes nothing" begin
    mesh = disk()
    before = checksum(mesh)
    for fails in ((markers, points) -> nothing, (markers, points) -> 3 .* points,
                  (markers, points) -> points .* NaN)
        set_projection!(fails, mesh)
        failure = thrown(() -> refine(mesh))
        @test failure isa AlphaMSTError && status_name(failure.code) == "AMST_ERR_PROJECTION"
        @test checksum(mesh) == before && revision(mesh) == 0
    end
    set_projection!((markers, points) -> points[:, 2:end], mesh)
    @test thrown(() -> refine(mesh)) isa DimensionMismatch
    set_projection!(points -> points, mesh)
    @test thrown(() -> refine(mesh)) isa MethodError
    for last in 1:2
        calls = 0
        set_projection!(mesh) do markers, points
            (calls += 1) == last && throw(KeyError(last))
            to_circle(markers, points)
        end
        @test thrown(() -> refine(mesh)) == KeyError(last)
        @test checksum(mesh) == before && revision(mesh) == 0
    end
    set_projection!(to_circle, mesh)
    @test refine(mesh) isa Report
end

@testset "it may ask but not change" begin
    mesh = disk()
    refused = []
    set_projection!(mesh) do markers, points
        @test nfaces(mesh) == nfaces(copy(mesh)) == 64
        push!(refused, refusal(() -> set_projection!(nothing, mesh)), refusal(() -> clean!(mesh)))
        GC.gc()
        to_circle(markers, points)
    end
    refine(mesh)
    @test unique(refused) == ["AMST_ERR_STATE"]
end
