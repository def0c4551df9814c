# Ends of objects, in every order and by every way; what is left still works.

function orders(items)
    length(items) <= 1 && return [items]
    return [[item; rest] for item in items for rest in orders(filter(!=(item), items))]
end

function new_world()
    context = Context()
    mesh, patches = grid_with_square(; context = context)
    report = smooth!(mesh, patches)
    return Any[context, mesh, patches, report]
end

use(context::Context) = @test set_threads!(context, 1) === context
use(mesh::Mesh) = @test smooth!(mesh)[:faces_after] == 100
use(patches::Patches) = @test length(boundary(patches, 1)) == 24
use(report::Report) = @test report[1, :faces_after] == 36

@testset "$finish in any order" for finish in (close, finalize)
    @test length(orders(1:4)) == 24
    for order in orders(1:4)
        world = new_world()
        for (k, which) in enumerate(order)
            finish(world[which])
            @test !isopen(world[which])
            foreach(rest -> use(world[rest]), order[k+1:end])
            finish(world[which]) # again does nothing
        end
        close(world[order[1]])
    end
end

@testset "collected in any order" begin
    for order in orders(1:4)
        world = new_world()
        for (k, which) in enumerate(order)
            world[which] = nothing
            GC.gc()
            foreach(rest -> use(world[rest]), order[k+1:end])
        end
    end
end

@testset "collected while others work" begin
    for round in 1:20
        world = new_world()
        foreach(_ -> Options(seed = 1), 1:50)
        set_progress!((fraction, stage) -> (GC.gc(false); nothing), world[1])
        adapt!(world[2], world[3], 1.5)
    end
    GC.gc()
    @test true # reached
end

# With one thread of Julia (JULIA_NUM_THREADS) this is a loop.
@testset "threads read one mesh, and end what they made" begin
    mesh, _ = grid_with_square()
    digest = checksum(mesh)
    same = zeros(Bool, 64)
    Threads.@threads for i in 1:64
        own = copy(mesh)
        patches = Patches(mesh)
        add_rings!(patches, 61, 2)
        failure = thrown(() -> faces(patches, i + 1)) # errors stay on their thread
        same[i] = checksum(own) == digest && points(own) == points(mesh) && length(faces(patches, 1)) == 16 &&
                  failure.patch == i + 1
        iseven(i) && close(own)
    end
    @test all(same)
    GC.gc()
    @test checksum(mesh) == digest
end

@testset "threads adapt copies in contexts of their own" begin
    mesh, _ = grid_with_square()
    copies = [copy(mesh, Context()) for _ in 1:4]
    Threads.@threads for i in 1:4
        adapt!(copies[i], 2)
    end
    @test nfaces(copies[1]) == 2 * nfaces(mesh)
    @test all(own -> checksum(own) == checksum(copies[1]), copies)
end

# In a process of its own, since this one may have one thread only.
@testset "the garbage collector runs while a thread is in the library" begin
    program = """
        push!(LOAD_PATH, $(repr(pkgdir(AlphaMST)))); using AlphaMST; include($(repr(joinpath(@__DIR__, "grid.jl"))))
        context = Context()
        mesh, done, collections = grid(40; context = context), Threads.Atomic{Bool}(false), Ref(0)
        set_progress!((fraction, stage) -> length(map(string, 1:100)) == 0, context) # allocates
        Threads.@threads for thread in 1:2
            if thread == 1
                adapt!(mesh, 1.3)
                done[] = true
            else
                while !done[]
                    Libc.systemsleep(0.02)
                    before = progress(context)
                    GC.gc()
                    0 < before && progress(context) < 1 && (collections[] += 1)
                end
            end
        end
        print(nfaces(mesh), ' ', min(collections[], 2))
        """
    command = `$(Base.julia_cmd()) --startup-file=no -e $program`
    @test read(in_environment(command, pairs((JULIA_NUM_THREADS = "2",))), String) == "2080 2"
end

@testset "use after close" begin
    mesh, patches = grid_with_square()
    context, options, report = Context(), Options(), smooth!(mesh, patches)
    foreach(close, (context, options, report, patches))
    closed(f) = (failure = thrown(f); failure isa InvalidStateException && failure.state === :closed)
    @test closed(() -> set_threads!(context, 1))
    @test closed(() -> set_progress!((fraction, stage) -> nothing, context))
    @test closed(() -> progress(context))
    @test closed(() -> Mesh(grid_points(1, 1), grid_faces(1, 1); context = context))
    @test closed(() -> options[:seed])
    @test closed(() -> options[:seed] = 1)
    @test closed(() -> clean!(mesh; options = options)) # not: all defaults
    @test closed(() -> smooth!(mesh, patches))          # not: the whole mesh
    @test closed(() -> add_rings!(patches, 1, 1))
    @test closed(() -> report[:status])
    @test closed(() -> origin(report, :face))
    close(mesh)
    for ask in (points, faces, nfaces, singularities, copy, check, mark!, clean!, Patches)
        @test closed(() -> ask(mesh))
    end
    @test sprint(show, mesh) == "Mesh (closed)"
    @test sprint(show, Context()) == "Context"
end

@testset "no second owner" begin
    mesh = grid(2)
    @test_throws ArgumentError deepcopy(mesh)
    @test_throws ArgumentError deepcopy([Options()])
    same = mesh
    close(same)
    @test !isopen(mesh)
end
