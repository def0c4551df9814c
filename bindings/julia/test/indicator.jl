@testset "sizes from an indicator" begin
    mesh = grid(4)
    @test size_from_indicator!(mesh, ones(16); faces = 64) ≈ 64 rtol = 1e-3
    @test field(mesh, :vertex, "size") ≈ fill(0.5, 25) rtol = 1e-3
    @test size_from_indicator!(mesh, ones(16); tolerance = 0.25, error_order = 2) ≈ 64
    @test size_from_indicator!(mesh, ones(16); tolerance = 0.25, error_order = 2, min_edge = 1) ≈ 16
    @test size_from_indicator!(mesh, ones(16); tolerance = 0.25, faces = 32) ≈ 32 rtol = 1e-3
    @test refusal(() -> size_from_indicator!(mesh, ones(16))) == "AMST_ERR_RANGE"
end
