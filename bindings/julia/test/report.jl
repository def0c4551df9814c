@testset "keys tell themselves apart" begin
    mesh, patches = grid_with_square()
    report = adapt!(mesh, patches, 1.26)
    after = length(faces(patches, 1))
    for place in ((), (1,))
        at(key) = report[place..., key]
        @test at(:status) === Int64(0)
        @test at(:faces_before) === Int64(36)
        @test at(:faces_after) == at(:faces_wanted) == 45 == after
        @test at(:singular_before) == 0
        @test at(:singular_after) == length(singularities(mesh)) > 0
        @test at(:singular_bound) == 0
        @test 0 <= at(:candidate) <= 1000
        @test at(:unused_option) == -1
        @test at(:alpha) === 45 / 36
        @test at(:quality_before) ≈ 1
        @test 0 < at(:quality_after) < 1
        @test at(:seconds) isa Float64 && 0 <= at(:seconds) < 60
        @test 0.2 < at(:size_error_before) < 0.6 # the old faces are 1.26 times too large
        @test 0 < at(:size_error_after) < 1
        @test 0.125 < at(:least_area_after) < at(:least_area_before)
        @test 0.1 < at(:time_step) < 1
        @test 0.2 < at(:shortest_edge_after) < at(:shortest_edge_before)
        @test 1 ≈ at(:aspect_ratio_before) < at(:aspect_ratio_after) < 10
        @test at(:area_gained) === 0.0
        numbers = [at(number) for number in [0:8; 1000:1002; 1004:1013]]
        @test numbers == [at(key) for key in keys(AlphaMST.result_keys) if key !== :seconds]
    end
    @test report[:quality_after] ≈ quality_summary(mesh, :scaled_jacobian).min
    whole = adapt!(mesh, 1)
    @test 0 < whole[:least_area_after] <= 1.5 && 0 <= whole[:size_error_after] < 2
    @test isnan(smooth!(mesh)[:size_error_after]) # which wants no sizes
    @test_throws ArgumentError report[:faces]
    @test refusal(() -> report[999]) == "AMST_ERR_NOT_FOUND"
    @test refusal(() -> report[1999]) == "AMST_ERR_NOT_FOUND"
    @test refusal(() -> report[2, :status]) == "AMST_ERR_RANGE"
    @test refusal(() -> report[0, :status]) == "AMST_ERR_RANGE"

    @test valence_count(report, 4; after = false) == 81
    @test valence_count(report, 3) + valence_count(report, 5) == report[:singular_after]
    @test valence_count(report, 1, 4; after = false) != 81
    @test valence_count(report, 1, 3; after = false) == 0
end

@testset "origins" begin
    mesh, patches = grid_with_square()
    old = copy(mesh)
    report = adapt!(mesh, patches, 2)
    sizes = (nvertices(mesh), nedges(mesh), nfaces(mesh))
    close(mesh), close(patches) # a report outlives both
    vertex, edge, face = origin(report, :vertex), origin(report, :edge), origin(report, :face)
    @test vertex isa Vector{Int32}
    @test count(iszero, face) == 72 && sort(filter(!iszero, face)) == setdiff(1:100, square(10, 2, 8))
    @test count(!iszero, edge) == 220 - 60 # all but those inside the square
    @test (length(vertex), length(edge), length(face)) == sizes
    @test extrema(filter(!iszero, edge)) == (1, nedges(old))
    @test origin!(zeros(Int32, length(edge)), report, :edge) == edge
    @test_throws DimensionMismatch origin!(zeros(Int32, 3), report, :edge)
    @test refusal(() -> origin(report, 3)) == "AMST_ERR_ARGUMENT"
end
