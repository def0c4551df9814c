@testset "adapt!" begin
    mesh, patches = grid_with_square()
    report = adapt!(mesh, patches, 2; seed = 7, smooth_steps = 40)
    @test report isa Report
    @test report[:faces_after] == nfaces(mesh) - 64 == 72
    @test !is_partial(report) && report[:status] == 0
    @test revision(mesh) > 0
    @test length(faces(patches, 1)) == 72 # moved along
    @test check(mesh) === nothing
    @test refusal(() -> adapt!(mesh, patches, 0)) == "AMST_ERR_ARGUMENT"
    @test refusal(() -> adapt!(mesh, Patches(grid(2)), 1)) == "AMST_ERR_ARGUMENT"
    @test_throws ArgumentError adapt!(mesh, patches, 1; sead = 7)
end

@testset "a patch with defects is left" begin
    mesh = grid(10)
    patches = Patches(mesh; repair_patches = 0)
    add_faces!(patches, [56, 58])
    before = checksum(mesh)
    report = adapt!(mesh, patches, 2)
    @test is_partial(report)
    @test status_name(report[1, :status]) == "AMST_ERR_PATCH"
    @test checksum(mesh) == before
end

@testset "reduce_singularities!" begin
    mesh = grid(10)
    patches = Patches(mesh)
    add_faces!(patches, square(10, 2, 7))
    adapt!(mesh, patches, 2)
    before = length(singularities(mesh))
    @test before >= 4
    report = reduce_singularities!(mesh, patches)
    @test report[:singular_before] == before
    @test (report[:faces_before], report[:faces_after], report[:singular_after]) == (50, 25, 0)
    @test singularities(mesh) == Int32[]
    @test nfaces(mesh) == 100
end

@testset "smooth!" begin
    function pushed()
        mesh = grid(8)
        xy = points(mesh)
        for j in 1:7, i in 1:7
            iseven(i + j) && (xy[:, 9j+i+1] += [0.35, -0.3])
        end
        return set_points!(mesh, xy)
    end
    mesh = pushed()
    before = points(mesh)
    corners = faces(mesh)
    report = smooth!(mesh)
    @test report[:quality_after] > report[:quality_before]
    @test report[:quality_after] ≈ quality_summary(mesh, :scaled_jacobian).min
    @test revision(mesh) == 0 && faces(mesh) == corners
    @test refusal(() -> report[1, :status]) == "AMST_ERR_RANGE" # no patches

    mesh = pushed()
    patches = Patches(mesh)
    add_faces!(patches, square(8, 2, 6))
    report = smooth!(mesh, patches; smooth_steps = 30)
    moved = [v for v in 1:81 if points(mesh)[:, v] != before[:, v]]
    @test !isempty(moved)
    @test all(v -> (v - 1) % 9 in 3:5 && (v - 1) ÷ 9 in 3:5, moved)
    @test report[1, :faces_before] == 16

    mesh = pushed()
    smooth!(mesh; options = Options(smooth_steps = 0)) # settings arrive
    @test points(mesh) == before
end

@testset "clean!" begin
    xy, corners = grid_points(7, 7), grid_faces(7, 7)
    a, b, c, d = corners[:, 25]
    corners = hcat(corners, [a, 65, c, d])
    corners[4, 25] = 65 # a vertex of valence 2 inside the middle face
    mesh = Mesh(hcat(xy, [3.5, 3.5]), corners)
    @test valences(mesh)[65] == 2
    report = clean!(mesh)
    @test check(mesh) === nothing
    @test report[:faces_before] == 50 && report[:faces_after] == nfaces(mesh)
    @test valence_count(report, 2; after = false) == 1 && valence_count(report, 2) == 0
    @test revision(mesh) > 0
    tidy = grid(4)
    clean!(tidy; seed = 1)
    @test revision(tidy) == 0
end

@testset "equal input and seed, equal output" begin
    function digest(threads, seed)
        mesh = grid(20; context = Context(threads = threads))
        patches = Patches(mesh; patch_faces = 30)
        decompose!(patches)
        adapt!(mesh, patches, 1.5; seed = seed)
        return checksum(mesh)
    end
    @test digest(1, 7) == digest(2, 7) == digest(0, 7)
end

@testset "whole meshes" begin
    mesh, patches = grid_with_square()
    adapt!(mesh, patches, 2)
    faces = nfaces(mesh)
    report = adapt!(mesh, 1.2; seed = 3)
    @test report[:faces_before] == faces
    @test nfaces(mesh) == report[:faces_wanted] == round(Int, 1.2faces)
    before = length(singularities(mesh))
    report = reduce_singularities!(mesh)
    @test report[:singular_before] == before
    @test report[:singular_after] == length(singularities(mesh)) <= before
    @test refusal(() -> adapt!(mesh, 0)) == "AMST_ERR_ARGUMENT"
end
