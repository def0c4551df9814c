@testset "computed" begin
    mesh = grid(4, 3)
    @test refusal(() -> alignment(mesh)) == "AMST_ERR_NOT_FOUND"
    @test compute_cross_field!(mesh) === mesh
    @test alignment(mesh) < 1e-9
    cross = field(mesh, :face, "cross")
    @test size(cross) == (3, 12)
    @test all(abs.(maximum(abs.(cross); dims = 1) .- 1) .< 1e-12) # along x or y
    @test revision(mesh) == 0
    compute_cross_field!(mesh; smooth_steps = 0)
    @test alignment(mesh) < 1e-9
    @test refusal(() -> compute_cross_field!(mesh; smooth_steps = -1)) == "AMST_ERR_RANGE"
end

@testset "given" begin
    mesh = grid(2)
    set_field!(mesh, :face, "cross", repeat([cosd(30), sind(30), 0], 1, 4); carry = :inherit)
    @test alignment(mesh) ≈ 30
    @test refusal(() -> set_field!(mesh, :face, "cross", 1:4; carry = :inherit)) == "AMST_ERR_RANGE"
    @test refusal(() -> set_field!(mesh, :edge, "cross", zeros(3, 12); carry = :drop)) == "AMST_ERR_ARGUMENT"
    @test alignment(mesh) ≈ 30
end
