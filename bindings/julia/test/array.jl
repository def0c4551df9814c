# What goes in and out without a copy, and what is copied.

@testset "matrices of any layout go in" begin
    wanted = checksum(grid(4, 3))
    xy, corners = grid_points(4, 3), grid_faces(4, 3)
    padded = fill(NaN, 5, 2 * 20)
    padded[[2, 4], 1:2:end] = xy
    strided = view(padded, 2:2:4, 1:2:40)
    wide = zeros(Int32, 6, 12)
    wide[2:5, :] = corners
    for given in [xy, strided, PermutedDimsArray(permutedims(xy), (2, 1)), permutedims(xy)', Float32.(xy),
                  view(xy[:, end:-1:1], :, 20:-1:1), Rational{Int}.(xy)]
        @test checksum(Mesh(given, corners)) == wanted
    end
    for given in [corners, Int64.(corners), view(wide, 2:5, :), PermutedDimsArray(permutedims(corners), (2, 1)),
                  PermutedDimsArray(permutedims(Int64.(corners)), (2, 1)), UInt8.(corners), Int16.(corners),
                  permutedims(corners)', view(Int64.(wide), 2:5, :), view(corners[:, end:-1:1], :, 12:-1:1)]
        @test checksum(Mesh(xy, given)) == wanted
    end
end

@testset "what lies in strides is read where it lies" begin
    view_of(matrix) = view(matrix, 1:2:size(matrix, 1), :)
    @test AlphaMST.by_strides(view_of(zeros(4, 3)), Float64) isa SubArray
    @test AlphaMST.by_strides(PermutedDimsArray(zeros(3, 2), (2, 1)), Float64) isa PermutedDimsArray
    @test AlphaMST.by_strides(view(zeros(4, 3), 4:-1:1, :), Float64) isa Matrix{Float64}
    @test AlphaMST.by_strides(zeros(Int16, 4, 3), Int64) isa Matrix{Int64}
end

@testset "arrays of the caller are filled" begin
    mesh = grid(4, 3)
    storage = fill(NaN, 2, 30)
    @test points!(view(storage, :, 6:25), mesh) === view(storage, :, 6:25)
    @test storage[:, 6:25] == points(mesh) && all(isnan, storage[:, [1:5; 26:30]])
    strided = view(fill(NaN, 4, 20), 1:2:4, :)
    @test points!(strided, mesh) == points(mesh)
    @test all(isnan, parent(strided)[2:2:4, :])
    @test points!(zeros(Float32, 2, 20), mesh) == points(mesh)
    @test points!(zeros(20, 2)', mesh) == points(mesh)
    @test faces!(zeros(Int32, 4, 12), mesh) == faces(mesh)
    @test faces!(zeros(Int64, 4, 12), mesh) == faces(mesh)
    @test edges!(zeros(Int32, 2, 31), mesh) == edges(mesh)
    @test edge_faces!(zeros(Int32, 2, 31), mesh) == edge_faces(mesh)
    @test edges(mesh) != edge_faces(mesh)
    @test valences!(zeros(Int32, 20), mesh) == valences(mesh)
    @test flags!(ones(Int32, 31), mesh, :edge) == zeros(31)
    @test quality!(zeros(12), mesh, :max_angle) == fill(90, 12)
    for call in [() -> points!(zeros(2, 19), mesh), () -> points!(zeros(3, 20), mesh),
                 () -> faces!(zeros(Int32, 4, 13), mesh), () -> edges!(zeros(Int32, 31, 2), mesh),
                 () -> valences!(zeros(Int32, 21), mesh), () -> quality!(zeros(11), mesh, :area)]
        @test thrown(call) isa DimensionMismatch
    end
end
