@testset "defaults" begin
    options = Options()
    @test options[:seed] === Int64(0)
    @test options[:smooth_steps] == 20
    @test options[:repair_patches] == 1
    @test options[:candidates] == 16
    @test options[:node_limit] == 1000
    @test options[:quadrangulate] == 0
    @test options[:min_quality] === 0.0
    @test options[:min_convexity] === 0.6
    @test options[:patch_faces] === 100.0
    @test options[:align] == 0
    @test options[:chart] == 0
    @test options[:keep_boundary] == 0
    @test options[:starts] == 1
    @test options[:tolerance] === 0.5
    @test options[:effort] === 1.0
    @test options[:size_weight] === 0.7
    @test options[:transition] === 0.5
    @test options[:least_size] === 0.125
    @test options[:sharp_angle] === 40.0
    @test options[:size_band] === 0.0
    @test options[:buffer_layers] == 2
    @test options[:min_edge] === options[:max_edge] === 0.0
    @test options[:gradation] === 0.2
    @test options[:error_order] === 1.0
end

@testset "settings come back" begin
    options = Options(seed = 2^40 + 7, smooth_steps = 3, repair_patches = false, candidates = 5,
                      node_limit = 10^9, quadrangulate = 1, min_quality = 0.25, min_convexity = 0.5, patch_faces = 12,
                      align = 1, chart = 3, tolerance = 0.25, effort = 4, size_weight = 0.3, transition = 0.75,
                      least_size = 0.0625, keep_boundary = true, sharp_angle = 25, size_band = 0.75, starts = 3,
                      buffer_layers = 5, min_edge = 0.5, max_edge = 7, gradation = 0.3, error_order = 2)
    @test options[:seed] == 2^40 + 7
    @test options[:smooth_steps] == 3
    @test options[:repair_patches] == 0
    @test options[:candidates] == 5
    @test options[:node_limit] == 10^9
    @test options[:quadrangulate] == 1
    @test options[:min_quality] == 0.25
    @test options[:min_convexity] == 0.5
    @test options[:patch_faces] === 12.0
    @test options[:align] == 1
    @test options[:chart] == 3
    @test options[:tolerance] === 0.25
    @test options[:effort] === 4.0
    @test options[:size_weight] === 0.3
    @test options[:transition] === 0.75
    @test options[:least_size] === 0.0625
    @test options[:keep_boundary] == 1
    @test options[:starts] == 3
    @test options[:sharp_angle] === 25.0
    @test options[:size_band] === 0.75
    @test options[:buffer_layers] == 5
    @test options[:min_edge] === 0.5
    @test options[:max_edge] === 7.0
    @test options[:gradation] === 0.3
    @test options[:error_order] === 2.0
    options[:seed] = 9
    options[1002] = 31.5
    @test options[0] == 9 && options[:patch_faces] == 31.5
end

@testset "refused" begin
    options = Options()
    @test_throws ArgumentError Options(sead = 7)
    @test_throws InexactError (options[:seed] = 1.5)
    @test refusal(() -> options[:candidates] = 0) == "AMST_ERR_RANGE"
    @test refusal(() -> options[:transition] = 0.01) == "AMST_ERR_RANGE"
    @test refusal(() -> options[:min_quality] = NaN) == "AMST_ERR_NOT_FINITE"
    @test refusal(() -> options[99] = 1) == "AMST_ERR_NOT_FOUND"
    @test refusal(() -> options[1099]) == "AMST_ERR_NOT_FOUND"
    @test_throws ArgumentError clean!(grid(2); options = options, seed = 7)
end

@testset "edges that no pair crosses" begin
    points, triangles = [0.0 1 1 0; 0 0 1 1], Int32[1 3; 2 4; 3 1]
    make(options) = Mesh(points, triangles; options = options)
    options = Options(edges = [3 0; 1 0][:, 1:1])
    @test options[:edges] == reshape([3, 1], 2, 1)
    @test length(faces(make(options))) > 4
    options[:edges] = zeros(Int, 2, 0)
    @test size(options[:edges]) == (2, 0)
    @test size(faces(make(options))) == (4, 1)
    @test size(crossed_edges(make(options))) == (2, 0)
    @test size(split_edges(make(options))) == (3, 0)
    @test sort(split_edges(make(Options(quadrangulate = 1)))[3, :]) == 5:9
    options[:edges] = reshape([4, 2], 2, 1)
    @test refusal(() -> make(options)) == "AMST_ERR_NOT_FOUND"
    @test_throws DimensionMismatch (options[:edges] = [1 2 3])
    @test_throws ArgumentError (options[:seed] = [1 2; 3 4])
end
