@testset "queries" begin
    mesh = grid(5, 3)
    ids = chord_ids(mesh)
    @test length(ids) == nedges(mesh) && extrema(ids) == (1, 8)
    @test sum(chords(mesh, :length)) == 2 * nfaces(mesh)
    for edge in chords(mesh, :edge)
        found = chord(mesh, edge)
        @test !found.closed && found.crossings == 0
        @test all(==(ids[edge]), ids[found.edges])
    end
    @test refusal(() -> chord(mesh, 99)) == "AMST_ERR_RANGE"
    @test_throws ArgumentError chords(mesh, :colour)
end

@testset "rings in and out" begin
    mesh, patches = grid_with_square()
    before, first = checksum(mesh), mark!(mesh)
    report = insert_chords!(mesh, patches, 2)
    @test nfaces(mesh) == 100 + 48 && !is_partial(report)
    ring = findfirst(==(1), chords(mesh, :closed))
    @test chords(mesh, :refusal)[ring] == 0
    after = chords(mesh, :singular_after)[ring]
    collapse_chord!(mesh, chords(mesh, :edge)[ring])
    @test (nfaces(mesh), length(singularities(mesh))) == (124, after)
    rollback!(mesh, first)
    @test checksum(mesh) == before
end

@testset "refused" begin
    mesh = grid(4)
    before = checksum(mesh)
    @test refusal(() -> collapse_chord!(mesh, 1)) == "AMST_ERR_CHORD"
    @test refusal(() -> split_chord!(mesh, 1)) == "AMST_ERR_CHORD"
    @test refusal(() -> split_chord!(mesh, 1, 0)) == "AMST_ERR_RANGE"
    @test all(==(AlphaMST.REFUSALS.boundary), chords(mesh, :refusal))
    @test checksum(mesh) == before
    split_chord!(mesh, 1, 2; edit_boundary = 1)
    @test nfaces(mesh) == 24
    adapt!(mesh, 20 / 24; strategy = 1, edit_boundary = 1)
    @test nfaces(mesh) == 20
end
