@testset "rollback, forget" begin
    mesh, patches = grid_with_square()
    before = checksum(mesh)
    first = mark!(mesh)
    @test first == revision(mesh)
    adapt!(mesh, patches, 2)
    changed = checksum(mesh)
    second = mark!(mesh)
    @test second > first
    adapt!(mesh, patches, 0.5)
    @test rollback!(mesh, second) === mesh
    @test checksum(mesh) == changed && revision(mesh) == second
    rollback!(mesh, first)
    @test checksum(mesh) == before && revision(mesh) == first
    @test refusal(() -> rollback!(mesh, second)) == "AMST_ERR_NOT_FOUND"
    @test forget!(mesh, first) === mesh
    @test checksum(mesh) == before
    @test refusal(() -> forget!(mesh, first)) == "AMST_ERR_NOT_FOUND"
end

@testset "patches are stale until their revision returns" begin
    mesh, patches = grid_with_square()
    others = Patches(mesh)
    add_rings!(others, 1, 1)
    start = mark!(mesh)
    adapt!(mesh, patches, 2)
    @test refusal(() -> faces(others, 1)) == "AMST_ERR_STALE"
    @test refusal(() -> adapt!(mesh, others, 2)) == "AMST_ERR_STALE"
    rollback!(mesh, start)
    @test faces(others, 1) == [1]
end
