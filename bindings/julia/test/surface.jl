@testset "set" begin
    mesh = grid(3)
    before = checksum(mesh)
    corners = [0 3 3 0; 0 0 3 3]
    @test set_surface!(mesh) === mesh
    @test set_surface!(mesh, corners, [1 1; 2 3; 3 4]) === mesh
    @test set_surface!(mesh, view([corners; corners], 1:2, :), Int8[1 1; 2 3; 3 4]) === mesh # not packed
    @test checksum(copy(mesh)) == checksum(mesh) == before
    @test revision(mesh) == 0
end

@testset "refused" begin
    mesh = grid(3)
    corners = [0.0 3 3 0; 0 0 3 3]
    first = reshape([1, 2, 3], 3, 1)
    failure = thrown(() -> set_surface!(mesh, corners, [1 1; 2 3; 3 5]))
    @test failure isa AlphaMSTError && occursin("triangle 2 of the surface has corner 5", failure.text)
    refused(points, triangles) = refusal(() -> set_surface!(mesh, points, triangles))
    @test refused(corners, [1 0; 2 1; 3 2]) == "AMST_ERR_RANGE"
    @test refused(corners, zeros(Int32, 3, 0)) == "AMST_ERR_RANGE"
    @test refused(zeros(2, 0), first) == "AMST_ERR_RANGE" # none, not the mesh
    @test refused([0 1 NaN; 0 0 1], first) == "AMST_ERR_NOT_FINITE"
    @test_throws DimensionMismatch set_surface!(mesh, zeros(3, 4), first)
    @test_throws DimensionMismatch set_surface!(mesh, corners, ones(Int, 4, 1))
end
