@testset "code, sentence and place" begin
    mesh = grid(3)
    failure = thrown(() -> find_edges(mesh, [1 2; 2 99]))
    @test failure isa AlphaMSTError
    @test failure.code == -3
    @test failure.entity === :vertex && failure.id == 99 && failure.patch == 0
    @test sprint(showerror, failure) == "AMST_ERR_RANGE: $(failure.text) (vertex 99)"
    @test occursin("99", failure.text)

    patches = Patches(mesh; repair_patches = 0)
    add_faces!(patches, [4, 5])
    failure = thrown(() -> add_faces!(patches, [6, 5, 7]))
    @test failure.code == -8
    @test failure.entity === :face && failure.id == 5 && failure.patch == 1
    @test endswith(sprint(showerror, failure), "(face 5, patch 1)")

    failure = thrown(() -> Mesh("nowhere.msh"))
    @test failure.code == -11
    @test failure.entity === :none && failure.id == 0 && failure.patch == 0
    failure = thrown(() -> Options(seed = 1)[42])
    @test failure.code == -10 && failure.id == 0 && failure.patch == 0
end

@testset "names and numbers" begin
    @test_throws ArgumentError flags(grid(2), :corner)
    @test flags(grid(2), 2) == flags(grid(2), :face)
    @test refusal(() -> flags(grid(2), 3)) == "AMST_ERR_ARGUMENT"
    @test refusal(() -> quality(grid(2), 20)) == "AMST_ERR_ARGUMENT"
    @test AlphaMST.name_of(AlphaMST.entities, Int32(9), :none) === :none
end
