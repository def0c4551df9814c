two_patches(context) = (mesh = grid(10; context = context);
                        patches = Patches(mesh);
                        add_faces!(patches, square(10, 1, 5));
                        add_faces!(patches, square(10, 5, 9));
                        (mesh, patches))

@testset "threads" begin
    @test set_threads!(Context(), 2) isa Context
    @test refusal(() -> Context(threads = -1)) == "AMST_ERR_RANGE"
end

@testset "progress" begin
    context = Context()
    mesh, patches = two_patches(context)
    seen = Tuple{Float64,String,Float64}[]
    set_progress!(context) do fraction, stage
        push!(seen, (fraction, stage, progress(context)))
    end
    adapt!(mesh, patches, 2)
    @test length(seen) >= 2
    @test issorted(first.(seen)) && last(seen)[1] == 1
    @test "adapt" in getindex.(seen, 2)
    @test first.(seen) == last.(seen) # asking gives the same fraction
    @test progress(context) == 1
    n = length(seen)
    set_progress!(nothing, context)
    smooth!(mesh)
    @test length(seen) == n
end

struct Stop <: Exception
    call::Int
end

# The callback misbehaves at its n-th call; nothing has changed, and the next call works.
@testset "an exception or true at any call changes nothing" begin
    for misbehave in (n -> throw(Stop(n)), n -> true), operation in (
            (mesh, patches) -> adapt!(mesh, patches, 2), (mesh, patches) -> reduce_singularities!(mesh, patches),
            (mesh, patches) -> smooth!(mesh, patches), (mesh, patches) -> clean!(mesh))
        n = 0
        while true
            n += 1
            context = Context()
            mesh, patches = two_patches(context)
            before, calls = checksum(mesh), 0
            set_progress!(context) do fraction, stage
                calls += 1
                return calls == n ? misbehave(n) : nothing
            end
            failure = thrown(() -> operation(mesh, patches))
            failure === nothing && break
            @test failure isa AlphaMSTError ? status_name(failure.code) == "AMST_ERR_CANCELLED" :
                  failure === Stop(n)
            @test calls == n # not called again
            @test checksum(mesh) == before && revision(mesh) == 0
            set_progress!(nothing, context)
            @test operation(mesh, patches) isa Report
        end
        @test n > 2
    end
end

@testset "a callback that is not fit is an exception too" begin
    context = Context()
    mesh, patches = two_patches(context)
    before = checksum(mesh)
    set_progress!(() -> true, context)
    @test thrown(() -> adapt!(mesh, patches, 2)) isa MethodError
    set_progress!((fraction, stage) -> throw(nothing), context)
    @test_throws Nothing adapt!(mesh, patches, 2)
    set_progress!((fraction, stage) -> throw(InterruptException()), context)
    @test thrown(() -> adapt!(mesh, patches, 2)) isa InterruptException
    @test checksum(mesh) == before
end

@testset "callbacks may ask and close, but not change" begin
    context = Context()
    mesh, patches = two_patches(context)
    before, refused = checksum(mesh), String[]
    set_progress!(context) do fraction, stage
        @test checksum(mesh) == before && nfaces(copy(mesh)) == 100
        for change in (() -> smooth!(mesh), () -> set_threads!(context, 1), () -> set_progress!(nothing, context),
                       () -> mark!(mesh), () -> add_rings!(patches, 1, 1))
            push!(refused, refusal(change))
        end
    end
    adapt!(mesh, patches, 2)
    @test unique(refused) == ["AMST_ERR_STATE"]
    set_progress!(context) do fraction, stage
        foreach(close, (context, mesh, patches))
        GC.gc()
    end
    @test adapt!(mesh, patches, 1)[:faces_before] == 64
    @test !isopen(mesh)
end

# Only the mesh is left of its context when the operation runs.
@testset "callbacks live as long as meshes" begin
    function made(seen)
        context = Context()
        set_progress!((fraction, stage) -> push!(seen, fraction), context)
        return two_patches(context)
    end
    seen = Float64[]
    mesh, patches = made(seen)
    foreach(_ -> GC.gc(), 1:3)
    smooth!(mesh, patches)
    @test last(seen) == 1
end

@testset "log" begin
    context = Context()
    mesh, patches = two_patches(context)
    seen = Tuple{Symbol,String}[]
    note(level, message) = push!(seen, (level, message))
    set_log!(note, context)
    smooth!(mesh, patches)
    @test any(((level, message),) -> level === :info && startswith(message, "smooth"), seen)
    empty!(seen)
    set_log!(note, context; level = :warning)
    smooth!(mesh, patches)
    @test isempty(seen)
    set_log!(note, context; level = :debug)
    set_log!(nothing, context)
    smooth!(mesh, patches)
    @test isempty(seen)
    @test refusal(() -> set_log!(note, context; level = 4)) == "AMST_ERR_ARGUMENT"

    calls = 0
    set_log!(context) do level, message
        throw(Stop(calls += 1))
    end
    @test thrown(() -> smooth!(mesh, patches)) === Stop(1)
    set_log!(nothing, context)
    @test smooth!(mesh, patches) isa Report
end

@testset "cancel" begin
    context = Context()
    mesh, patches = two_patches(context)
    before = checksum(mesh)
    set_cancel!(context)
    for operation in (() -> adapt!(mesh, patches, 2), () -> smooth!(mesh), () -> clean!(mesh))
        @test refusal(operation) == "AMST_ERR_CANCELLED"
    end
    @test checksum(mesh) == before
    set_cancel!(context, false)
    set_progress!((fraction, stage) -> (set_cancel!(context); nothing), context)
    @test refusal(() -> adapt!(mesh, patches, 2)) == "AMST_ERR_CANCELLED"
    @test checksum(mesh) == before
    set_progress!(nothing, context)
    set_cancel!(context, false)
    @test adapt!(mesh, patches, 2)[:faces_after] == 64
end
