using AlphaMST
using AlphaMST: DEFECTS, FLAGS, LibAlphaMST
using Test

include("grid.jl")

@testset "AlphaMST" begin
    @testset "$noun" for noun in ["library", "error", "options", "mesh", "array", "flags",
                                  "markers", "field", "cross_field", "geometry", "indicator",
                                  "surface", "boundary", "savepoint", "quality", "patches",
                                  "operations", "chord", "report", "context", "handle"]
        include("$noun.jl")
    end
end
