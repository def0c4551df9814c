@testset "counts, dim and revision tell themselves apart" begin
    mesh = grid(4, 3)
    @test (dim(mesh), nvertices(mesh), nedges(mesh), nfaces(mesh), revision(mesh)) === (2, 20, 31, 12, 0)
    lifted = Mesh(vcat(grid_points(4, 3), fill(2.5, 1, 20)), grid_faces(4, 3))
    @test dim(lifted) == 3
    @test points(lifted)[3, :] == fill(2.5, 20)
    @test points(mesh) isa Matrix{Float64}
    @test points(mesh) == grid_points(4, 3)
    @test faces(mesh) isa Matrix{Int32}
    @test faces(mesh) == grid_faces(4, 3)
end

@testset "ids index arrays" begin
    mesh = grid(4, 3)
    xy, corners = points(mesh), faces(mesh)
    @test extrema(corners) == (1, 20)
    @test xy[:, corners[1, 7]] == [2, 1] # face 7 is (2, 1)
    pairs, sides = edges(mesh), edge_faces(mesh)
    @test size(pairs) == size(sides) == (2, 31)
    @test all(pairs[1, :] .< pairs[2, :])
    @test count(iszero, sides) == 2 * (4 + 3) # none is 0
    @test extrema(sides) == (0, 12)
    for e in 1:31, (side, direction) in ((1, 1:2), (2, 2:-1:1))
        face = sides[side, e]
        face == 0 && continue
        sides[2, e] == 0 && corners[mod1(findfirst(==(pairs[1, e]), corners[:, face]) + 1, 4), face] !=
            pairs[2, e] && continue # on the boundary the one face comes first, though it is at the right
        from, to = pairs[direction, e]
        at = findfirst(==(from), corners[:, face])
        @test corners[mod1(at + 1, 4), face] == to # left along, right back
    end
    @test find_edges(mesh, pairs) == 1:31
    @test find_edges(mesh, [2 1 1; 1 7 20]) == [find_edges(mesh, [1 2]')[1], 0, 0]
    @test find_edges(mesh, zeros(Int, 2, 0)) == Int32[]
    @test refusal(() -> find_edges(mesh, [0 1]')) == "AMST_ERR_RANGE"
    @test_throws DimensionMismatch find_edges(mesh, [1 2 3]')
end

@testset "valences and singularities" begin
    @test reshape(valences(grid(4, 3)), 5, 4) == [4 - (i in (0, 4)) - (j in (0, 3)) for i in 0:4, j in 0:3]
    @test singularities(grid(4, 3)) == Int32[]
    corner(v) = [(v >> c) & 1 for c in 0:2]
    cube = Mesh(reduce(hcat, corner.(0:7)),
                reshape([0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5], 4, 6) .+ 1)
    @test singularities(cube) == 1:8
    @test check(cube) === nothing
end

@testset "checksum, check, copy" begin
    mesh = grid(3)
    same = copy(mesh)
    @test checksum(same) == checksum(mesh) == checksum(grid(3))
    set_flags!(same, :face, [1]; fixed = true)
    @test checksum(same) != checksum(mesh)
    xy = points(mesh)
    xy[:, 6] = [2.5, 2.5] # turns corners over
    set_points!(mesh, xy)
    @test points(mesh) == xy && points(same) == grid_points(3, 3)
    @test thrown(() -> check(mesh)) isa AlphaMSTError
    @test_throws DimensionMismatch set_points!(mesh, zeros(3, 16))
    @test refusal(() -> set_points!(mesh, zeros(2, 15))) == "AMST_ERR_RANGE"
    @test refusal(() -> set_points!(mesh, fill(NaN, 2, 16))) == "AMST_ERR_NOT_FINITE"
    set_points!(mesh, view(grid_points(3, 3), 2:-1:1, :)) # not packed
    @test points(mesh) == grid_points(3, 3)[2:-1:1, :]
end

@testset "triangles" begin
    xy, corners = grid_points(2, 1), grid_faces(2, 1)
    triangles = hcat(corners[1:3, :], corners[[1, 3, 4], :])
    mesh = Mesh(xy, triangles)
    @test nfaces(mesh) == 2 && points(mesh) == xy
    mixed = hcat(corners[:, 1], [corners[1:3, 2]; 0], [corners[[1, 3, 4], 2]; 0])
    @test nfaces(Mesh(xy, mixed)) == 2
    split = Mesh(xy, triangles; quadrangulate = 1)
    @test nfaces(split) == 12 && nvertices(split) == 6 + 9 + 4
end

@testset "refused arrays" begin
    xy, corners = grid_points(2, 2), grid_faces(2, 2)
    @test refusal(() -> Mesh(xy[1:1, :], corners)) == "AMST_ERR_ARGUMENT"
    @test refusal(() -> Mesh(xy, corners[1:2, :])) == "AMST_ERR_ARGUMENT"
    @test refusal(() -> Mesh(xy, corners .- Int32(1))) == "AMST_ERR_RANGE" # 0 is no vertex
    @test refusal(() -> Mesh(xy, corners .+ 2^33)) == "AMST_ERR_RANGE"
    @test refusal(() -> Mesh(xy .* NaN, corners)) == "AMST_ERR_NOT_FINITE"
    @test refusal(() -> Mesh(xy, fill(1, 4, 1))) == "AMST_ERR_NOT_QUAD"
    @test refusal(() -> Mesh(xy, zeros(Int, 4, 0))) == "AMST_ERR_RANGE"
end

@testset "files" begin
    mktempdir() do folder
        mesh = grid(3, 2)
        for extension in ["off", "obj", "ply", "msh", "vtk"]
            path = joinpath(folder, "grid ä.$extension")
            @test write(path, mesh) === nothing
            again = Mesh(path)
            @test dim(again) == 2
            @test points(again) == points(mesh) && faces(again) == faces(mesh)
        end
        write(joinpath(folder, "grid.svg"), mesh)
        @test occursin("<svg", read(joinpath(folder, "grid.svg"), String))
        @test refusal(() -> write(joinpath(folder, "grid.stl"), mesh)) == "AMST_ERR_UNSUPPORTED"
        write(joinpath(folder, "bad.off"), "OFF\n1 1\n")
        @test refusal(() -> Mesh(joinpath(folder, "bad.off"))) == "AMST_ERR_FORMAT"
        @test_throws ArgumentError Mesh("a\0b.off")
    end
end
