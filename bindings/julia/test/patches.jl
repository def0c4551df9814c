@testset "adding" begin
    mesh = grid(10)
    patches = Patches(mesh)
    @test length(patches) == 0
    @test add_rings!(patches, 2 * 11 + 3, 2) === 1 # around (2, 2)
    @test length(faces(patches, 1)) == 16
    @test add_ball!(patches, (8, 8), 1) == 2
    @test length(faces(patches, 2)) == 4
    @test add_box!(patches, [0, 6, -1], (3, 9, 1)) == 3
    @test length(faces(patches, 3)) == 9
    @test add_faces!(patches, [10, 9, 10, 20, 19]) == 4
    @test faces(patches, 4) == [9, 10, 19, 20]
    @test faces(patches, 4) isa Vector{Int32}
    @test length(patches) == 4
    @test refusal(() -> faces(patches, 5)) == "AMST_ERR_RANGE"
    @test refusal(() -> faces(patches, 0)) == "AMST_ERR_RANGE"
    @test refusal(() -> add_faces!(patches, [101])) == "AMST_ERR_RANGE"
    @test refusal(() -> add_faces!(patches, Int[])) == "AMST_ERR_PATCH"
    @test refusal(() -> add_ball!(patches, (1, 1), -1)) == "AMST_ERR_ARGUMENT"
    @test refusal(() -> add_ball!(patches, (5, 5, 500), 1)) == "AMST_ERR_PATCH" # z is passed on
    @test refusal(() -> add_box!(patches, (5, 5), (1, 1))) == "AMST_ERR_ARGUMENT"
    @test refusal(() -> add_rings!(patches, 122, 1)) == "AMST_ERR_RANGE"
    @test_throws DimensionMismatch add_ball!(patches, (1,), 1)
    @test length(patches) == 4
end

@testset "decompositions" begin
    for method in (:clusters, :partition, :voronoi)
        mesh = grid(10)
        patches = Patches(mesh; patch_faces = 12, seed = 3)
        n = decompose!(patches, method)
        @test n == length(patches) && 4 <= n <= 20
        @test allunique(reduce(vcat, [faces(patches, p) for p in 1:n]))
    end
    one = Patches(grid(10); options = Options(patch_faces = 100))
    @test decompose!(one) < 4
    @test refusal(() -> decompose!(one, 7)) == "AMST_ERR_ARGUMENT"
    @test_throws ArgumentError decompose!(one, :circles)
    some = Patches(grid(10); patch_faces = 12)
    @test decompose!(some, :singularities) == 0 # a grid has none
    n = decompose!(some, :medial)
    @test n >= 2 && all(3 <= length(faces(some, p)) <= 12 for p in 1:n)
end

@testset "boundary and corners" begin
    mesh = grid(10)
    patches = Patches(mesh)
    add_faces!(patches, square(10, 2, 5))
    loop, found = boundary(patches, 1), corners(patches, 1)
    @test length(loop) == 12 && length(found) == 4
    @test loop[1] == found[1]
    x, y = eachrow(points(mesh)[:, loop])
    @test sum(x .* circshift(y, -1) .- circshift(x, -1) .* y) / 2 == 9 # counter-clockwise
    given = [5 * 11 + 6, 5 * 11 + 3, 2 * 11 + 4]
    @test set_corners!(patches, 1, given) === patches
    @test corners(patches, 1) == given
    @test boundary(patches, 1)[1] == given[1]
    @test check(patches, 1).defects == 0
    set_corners!(patches, 1, reverse(given))
    @test check(patches, 1).defects == DEFECTS.corners
    set_corners!(patches, 1, Int[])
    @test corners(patches, 1) == found
    @test refusal(() -> set_corners!(patches, 1, given[1:2])) == "AMST_ERR_RANGE"
end

@testset "defects and convexity" begin
    mesh = grid(10)
    patches = Patches(mesh; repair_patches = 0, min_convexity = 0.8)
    add_faces!(patches, [1, 2, 3, 11, 13, 21, 22, 23]) # around face 12
    add_faces!(patches, [56, 58])
    add_faces!(patches, [89, 100])
    add_faces!(patches, [46, 45, 47, 36]) # 4 of a hull of 5
    @test check(patches, 1).defects & DEFECTS.not_disk != 0
    @test check(patches, 1).convexity == 0
    @test check(patches, 2).defects & DEFECTS.not_connected != 0
    @test check(patches, 3).defects & DEFECTS.pinched != 0
    @test check(patches, 4).convexity ≈ 4 / 5
    failure = thrown(() -> boundary(patches, 2))
    @test status_name(failure.code) == "AMST_ERR_PATCH" && failure.patch == 2
    @test refusal(() -> corners(patches, 1)) == "AMST_ERR_PATCH"
    strict = Patches(mesh; min_convexity = 0.81)
    add_faces!(strict, [46, 45, 47, 36])
    @test check(strict, 1) == (defects = DEFECTS.not_convex, convexity = check(patches, 4).convexity)
end

@testset "prediction" begin
    mesh, patches = grid_with_square()
    @test predict(patches, 1, 1) == (faces = 36, singularities = 0)
    foreseen = predict(patches, 1, 2; seed = 3)
    @test foreseen.faces == 72 && foreseen.singularities > 0
    report = adapt!(mesh, patches, 2; seed = 3)
    @test report[1, :faces_after] == 72
    @test length(singularities(mesh)) == report[:singular_after]
    @test refusal(() -> predict(patches, 1, 0)) == "AMST_ERR_ARGUMENT"
    @test refusal(() -> predict(patches, 2, 1)) == "AMST_ERR_RANGE"
end

@testset "alpha of a patch" begin
    function wanted(set)
        mesh = grid(10)
        patches = Patches(mesh)
        add_faces!(patches, square(10, 0, 4))
        add_faces!(patches, square(10, 5, 9))
        @test set(patches) === patches
        report = adapt!(mesh, patches, 1.5)
        return [report[p, :faces_wanted] for p in 1:2]
    end
    @test wanted(identity) == [24, 24]
    @test wanted(patches -> set_alpha!(patches, 2, 3)) == [24, 48]
    @test wanted(patches -> set_alpha!(patches, 2)) == [32, 32]
    patches = grid_with_square()[2]
    @test refusal(() -> set_alpha!(patches, 3, 1)) == "AMST_ERR_RANGE"
    @test refusal(() -> set_alpha!(patches, -1)) == "AMST_ERR_ARGUMENT"
end

@testset "pictures" begin
    mesh, patches = grid_with_square()
    mktempdir() do folder
        path = joinpath(folder, "patches.svg")
        @test write(path, patches) === nothing
        write(joinpath(folder, "mesh.svg"), mesh)
        @test occursin("<svg", read(path, String))
        @test read(path) != read(joinpath(folder, "mesh.svg"))
        @test refusal(() -> write(joinpath(folder, "patches.vtk"), patches)) == "AMST_ERR_UNSUPPORTED"
    end
end
