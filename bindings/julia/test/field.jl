@testset "fields of $entity" for (entity, n) in (:vertex => 16, :edge => 24, :face => 9)
    mesh = grid(3)
    @test set_field!(mesh, entity, "height", 1:n; carry = :inherit) === mesh
    @test field(mesh, entity, "height") == 1:n
    pairs = [10.0 * i + c for c in 1:2, i in 1:n]
    set_field!(mesh, entity, "velocity", view(vcat(pairs, pairs), 1:2, :); carry = :drop) # not packed
    @test field(mesh, entity, "velocity") == pairs
    for other in (:vertex, :edge, :face)
        other === entity || @test refusal(() -> field(mesh, other, "height")) == "AMST_ERR_NOT_FOUND"
    end
    set_field!(mesh, entity, "height", zeros(n); carry = :drop)
    @test field(mesh, entity, "height") == zeros(n)
    @test remove_field!(mesh, entity, "height") === mesh
    @test refusal(() -> field(mesh, entity, "height")) == "AMST_ERR_NOT_FOUND"
    @test field(copy(mesh), entity, "velocity") == pairs
    @test revision(mesh) == 0
end

@testset "into the caller's array" begin
    mesh = grid(2)
    set_field!(mesh, :face, "one", [1, 2, 3, 4]; carry = :inherit)
    set_field!(mesh, :face, "two", [1 2 3 4; 5 6 7 8]; carry = :inherit)
    one, two = zeros(4), zeros(Float32, 2, 4)
    @test field!(one, mesh, :face, "one") === one && one == 1:4
    @test field!(view(zeros(4, 4), 2, :), mesh, :face, "one") == 1:4
    @test field!(two, mesh, :face, "two") === two && two == [1 2 3 4; 5 6 7 8]
    @test_throws DimensionMismatch field!(zeros(8), mesh, :face, "two")
    @test_throws DimensionMismatch field!(zeros(3), mesh, :face, "one")
end

@testset "carried" begin
    mesh, patches = grid_with_square()
    linear(xy) = 2 .+ xy[1, :] .- 3 .* xy[2, :]
    sums() = sum(field(mesh, :face, "mass") .* quality(mesh, :area))
    set_field!(mesh, :vertex, "linear", linear(points(mesh)); carry = :linear)
    set_field!(mesh, :face, "mass", [sin(f) for f in 1:100]; carry = :conserve)
    set_field!(mesh, :face, "name", 1:100; carry = :inherit)
    set_field!(mesh, :edge, "gone", 1:220; carry = :drop)
    before, start = sums(), mark!(mesh)
    report = adapt!(mesh, patches, 2)
    @test maximum(abs.(field(mesh, :vertex, "linear") .- linear(points(mesh)))) < 1e-12
    @test abs(sums() - before) < 1e-12
    @test all(o == 0 || o == name for (o, name) in zip(origin(report, :face), field(mesh, :face, "name")))
    @test refusal(() -> field(mesh, :edge, "gone")) == "AMST_ERR_NOT_FOUND"
    rollback!(mesh, start)
    @test field(mesh, :edge, "gone") == 1:220
    @test field(mesh, :face, "name") == 1:100
end

@testset "conserved in both orders, on faces and vertices" begin
    mesh, patches = grid_with_square()
    for (entity, n) in (:face => 100, :vertex => 121), carry in (:conserve, :average)
        set_field!(mesh, entity, String(carry), [sin(i) for i in 1:n]; carry = carry)
    end
    old = field(mesh, :face, "conserve")
    adapt!(mesh, patches, 2)
    for entity in (:face, :vertex)
        linear, constant = field(mesh, entity, "conserve"), field(mesh, entity, "average")
        @test linear != constant && length(linear) == length(constant)
        @test all(abs.(linear) .<= 1) && all(abs.(constant) .<= 1)
    end
end

@testset "what meshes share" begin
    mesh, patches = grid_with_square()
    old = copy(mesh)
    adapt!(mesh, patches, 2)
    rows = overlap(old, mesh)
    @test rows.before isa Vector{Int32} && issorted(rows.after)
    sums(faces, n) = [sum(rows.area[faces .== f]) for f in 1:n]
    @test sums(rows.before, nfaces(old)) ≈ quality(old, :area)
    @test sums(rows.after, nfaces(mesh)) ≈ quality(mesh, :area)
    @test length(overlap(mesh, grid(1)).area) == 1 # what lies outside has no rows
    curved = Mesh([0 1 1 0; 0 0 1 1; 0 0 1 1], reshape(1:4, 4, 1))
    @test refusal(() -> overlap(mesh, curved)) == "AMST_ERR_ARGUMENT"
end

@testset "refused" begin
    mesh = grid(3)
    field_of(args...; carry = :inherit) = refusal(() -> set_field!(mesh, args...; carry = carry))
    @test field_of(:face, "a", 1:8) == "AMST_ERR_RANGE"
    @test field_of(:face, "", 1:9) == "AMST_ERR_ARGUMENT"
    @test field_of(:face, "a", fill(Inf, 9)) == "AMST_ERR_NOT_FINITE"
    @test field_of(:face, "a", zeros(0, 9)) == "AMST_ERR_RANGE"
    @test field_of(:face, "a", 1:9; carry = :linear) == "AMST_ERR_ARGUMENT"
    @test field_of(:edge, "a", 1:24; carry = :conserve) == "AMST_ERR_ARGUMENT"
    @test field_of(:edge, "a", 1:24; carry = :average) == "AMST_ERR_ARGUMENT"
    @test field_of(:face, "size", 1:9) == "AMST_ERR_ARGUMENT"
    @test field_of(:vertex, "size", 0:15) == "AMST_ERR_RANGE"
    failure = thrown(() -> set_field!(mesh, :vertex, "size", 8:-1:-7; carry = :linear))
    @test (failure.entity, failure.id) == (:vertex, 9)
    @test_throws ArgumentError set_field!(mesh, :face, "a", 1:9; carry = :copied)
    @test refusal(() -> remove_field!(mesh, :face, "a")) == "AMST_ERR_NOT_FOUND"
    @test all(refusal(() -> field(mesh, e, n)) == "AMST_ERR_NOT_FOUND" for e in (:vertex, :face), n in ("a", "size"))
end
