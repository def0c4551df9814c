@testset "flags of $entity" for entity in (:vertex, :edge, :face)
    mesh = grid(3)
    n = Dict(:vertex => 16, :edge => 24, :face => 9)[entity]
    set_flags!(mesh, entity, [1, 9]; fixed = true, corner = true)
    wanted = [i in (1, 9) ? FLAGS.fixed | FLAGS.corner : 0 for i in 1:n]
    @test flags(mesh, entity) == wanted
    for other in (:vertex, :edge, :face)
        other === entity || @test all(iszero, flags(mesh, other))
    end
    set_flags!(mesh, entity; feature = true)
    set_flags!(mesh, entity, 1:1; fixed = false)
    wanted .|= FLAGS.feature
    wanted[1] &= ~FLAGS.fixed
    @test flags(mesh, entity) == wanted
    set_flags!(mesh, entity, :, FLAGS.feature | FLAGS.corner, FLAGS.feature | FLAGS.fixed)
    @test flags(mesh, entity) == [i == 9 ? 3 : 2 for i in 1:n]
    @test revision(mesh) == 0
end

@testset "refused" begin
    mesh = grid(3)
    before = checksum(mesh)
    set_flags!(mesh, :face, Int[]; fixed = true) # none, not all
    @test_throws ArgumentError set_flags!(mesh, :face; sharp = true)
    @test refusal(() -> set_flags!(mesh, :vertex, [1, 17]; fixed = true)) == "AMST_ERR_RANGE"
    @test refusal(() -> set_flags!(mesh, :face, [0]; fixed = true)) == "AMST_ERR_RANGE"
    @test refusal(() -> set_flags!(mesh, :face, :, 8, 8)) == "AMST_ERR_RANGE"
    @test checksum(mesh) == before
end

@testset "features" begin
    flat = grid_points(4, 3)
    fold = [flat; max.(flat[1:1, :] .- 2, 0)] # upwards by 45 degrees from the third column on
    mesh = Mesh(fold, grid_faces(4, 3))
    @test detect_features!(mesh, 46) == 0
    @test all(iszero, flags(mesh, :edge))
    @test detect_features!(mesh, 44) == 3
    at_fold = [all(==(2), flat[1, pair]) for pair in eachcol(edges(mesh))]
    @test flags(mesh, :edge) == FLAGS.feature .* at_fold
    @test findall(!iszero, flags(mesh, :vertex)) == [3, 18]
    @test all(==(FLAGS.corner), flags(mesh, :vertex)[[3, 18]])
    @test refusal(() -> detect_features!(mesh, 181)) == "AMST_ERR_RANGE"
    @test refusal(() -> detect_features!(mesh, NaN)) == "AMST_ERR_NOT_FINITE"
end
