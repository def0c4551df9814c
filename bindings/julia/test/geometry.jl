@testset "geometry of a grid" begin
    mesh = grid(4)
    @test geometry(mesh, :centroids)[:, 6] == [1.5, 1.5]
    @test geometry(mesh, :lengths) == ones(nedges(mesh))
    normals, sides, pairs, places = geometry(mesh, :normals), edge_faces(mesh), edges(mesh), points(mesh)
    outwards(e) = sum(normals[:, e] .* (sum(places[:, pairs[:, e]]; dims = 2)[:] / 2 .-
                                        geometry(mesh, :centroids)[:, sides[1, e]]))
    @test all(outwards(e) == 0.5 for e in axes(sides, 2))
    @test refusal(() -> geometry(mesh, 99)) == "AMST_ERR_ARGUMENT"
end

@testset "faces around vertices" begin
    mesh = grid(4)
    offsets, around = vertex_faces(mesh)
    @test diff(offsets)[[1, 2, 7]] == [1, 2, 4] && offsets[end] == 1 + 4 * 16 == 1 + length(around)
    @test all(v in faces(mesh)[:, f] for v in 1:25 for f in around[offsets[v]:offsets[v+1]-1])
end
