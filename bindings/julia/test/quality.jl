@testset "each metric by its own value" begin
    mesh = Mesh([0 4 2 0; 0 0 3 1.0], reshape(1:4, 4, 1))
    values = Dict(metric => quality(mesh, metric)[1] for metric in keys(AlphaMST.metrics))
    numbers = Dict(number => quality(mesh, number)[1] for number in 0:19)
    @test length(values) == 20
    @test values[:area] ≈ 7
    @test values[:max_angle] ≈ 135
    @test values[:min_angle] ≈ atand(3 / 2)
    @test values[:edge_ratio] ≈ 4
    @test values[:warpage] ≈ 1
    @test values[:jacobian] ≈ quality_summary(mesh, :jacobian).min
    for (place, metric) in enumerate(keys(AlphaMST.metrics))
        @test values[metric] == numbers[place-1]
        summary = quality_summary(mesh, metric)
        @test summary.count == 1
        @test summary.min == summary.max == summary.mean == values[metric]
        @test summary.stddev == 0
    end
end

@testset "unit squares are ideal" begin
    mesh = grid(3, 2)
    for metric in keys(AlphaMST.metrics)
        ideal = metric in (:max_angle, :min_angle) ? 90 : metric in (:oddy, :skew, :taper) ? 0 : 1
        @test quality(mesh, metric) ≈ fill(ideal, 6) atol = 1e-12
    end
end

@testset "summary is that of the values" begin
    xy = grid_points(4, 1)
    xy[1, :] .^= 2 # columns of width 1, 3, 5, 7
    mesh = Mesh(xy, grid_faces(4, 1))
    @test quality(mesh, :area) ≈ [1, 3, 5, 7]
    summary = quality_summary(mesh, :area)
    @test (summary.count, summary.min, summary.max, summary.mean) == (4, 1, 7, 4)
    @test summary.stddev ≈ sqrt(5)
    @test 0 < quality_summary(mesh, :aspect_ratio).acceptable < 4
    @test sizeof(LibAlphaMST.amst_summary) == 48
    @test refusal(() -> quality_summary(mesh, 20)) == "AMST_ERR_ARGUMENT"
    @test_throws ArgumentError quality(mesh, :beauty)
end
