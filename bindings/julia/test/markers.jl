@testset "markers of $entity" for entity in (:vertex, :edge, :face)
    mesh = grid(3)
    n = Dict(:vertex => 16, :edge => 24, :face => 9)[entity]
    before = checksum(mesh)
    @test markers(mesh, entity) == zeros(n)
    @test marker_list(mesh, entity) == Int32[]
    set_markers!(mesh, entity, [1, 9], 7)
    set_markers!(mesh, entity, 9:9, -2)
    set_markers!(mesh, entity, Int[], 5) # none, not all
    wanted = [i == 1 ? 7 : i == 9 ? -2 : 0 for i in 1:n]
    @test markers(mesh, entity) == wanted
    @test markers!(view(zeros(Int32, n + 2), 2:n+1), mesh, entity) == wanted
    @test marker_list(mesh, entity) == [-2, 7]
    @test (flags(mesh, entity)[1] == FLAGS.corner) == (entity === :vertex)
    @test checksum(mesh) != before && revision(mesh) == 0
    set_markers!(mesh, entity, :, 3)
    @test marker_list(mesh, entity) == [3]
end

@testset "names of markers" begin
    mesh = grid(3)
    set_markers!(mesh, :edge, 1:2, 7)
    @test marker_name(mesh, :edge, 7) == ""
    set_marker_name!(mesh, :edge, 7, "Überlauf 1")
    set_marker_name!(mesh, :face, 7, "sand")
    mktempdir() do folder
        path = joinpath(folder, "named.msh")
        write(path, mesh)
        back = Mesh(path)
        @test checksum(back) == checksum(mesh)
        @test marker_name(back, :edge, 7) == "Überlauf 1"
        @test marker_name(back, :face, 7) == "sand"
    end
    set_marker_name!(mesh, :edge, 7, "")
    @test marker_name(mesh, :edge, 7) == ""
end

@testset "refused" begin
    mesh = grid(3)
    before = checksum(mesh)
    @test refusal(() -> set_markers!(mesh, :vertex, [1, 17], 1)) == "AMST_ERR_RANGE"
    @test refusal(() -> set_marker_name!(mesh, :edge, 0, "none")) == "AMST_ERR_ARGUMENT"
    @test refusal(() -> set_marker_name!(mesh, :edge, 1, "a \"b\"")) == "AMST_ERR_ARGUMENT"
    @test checksum(mesh) == before
end
