@testset "version and features" begin
    @test library_version() == v"0.1.0"
    @test LibAlphaMST.amst_version() == 100
    @test AlphaMST.is_compatible(100) && AlphaMST.is_compatible(199)
    @test !AlphaMST.is_compatible(200) && !AlphaMST.is_compatible(10100)
    @test library_has("threads")
    @test !library_has("teleport")
    @test status_name(-9) == "AMST_ERR_STALE"
    @test status_name(-10) == "AMST_ERR_NOT_FOUND"
end

@testset "every function of the header has an address" begin
    @test length(LibAlphaMST.addresses) == 98
    @test all(address[] != C_NULL for (_, address) in LibAlphaMST.addresses)
    @test length(unique(address[] for (_, address) in LibAlphaMST.addresses)) == 98
end

@testset "every exported name has a docstring" begin
    documented = keys(Base.Docs.meta(AlphaMST))
    exported = filter(name -> name !== :AlphaMST, names(AlphaMST))
    @test filter(name -> Base.Docs.Binding(AlphaMST, name) ∉ documented, exported) == []
end

# What a fresh process says that loads the package in a folder's project.
function loading(folder; environment...)
    write(joinpath(folder, "Project.toml"), "[deps]\nAlphaMST = \"$(Base.PkgId(AlphaMST).uuid)\"\n")
    package = pkgdir(AlphaMST)
    program = "push!(LOAD_PATH, $(repr(package))); using AlphaMST; print(library_version())"
    command = `$(Base.julia_cmd()) --startup-file=no --project=$folder -e $program`
    output = IOBuffer()
    run(pipeline(ignorestatus(in_environment(command, environment)), stdout = output, stderr = output))
    return String(take!(output))
end

in_environment(command, environment) =
    setenv(command, merge(Dict{String,String}(ENV), Dict(string(k) => v for (k, v) in environment)))

@testset "where the library is looked for" begin
    library = AlphaMST.library_path()
    mktempdir() do folder
        write(joinpath(folder, "AMST_LIBRARY"), library, "\n")
        @test occursin("0.1.0", loading(folder; AMST_LIBRARY = ""))
        write(joinpath(folder, "AMST_LIBRARY"), "nowhere/libalphamst.so\n")
        @test occursin(joinpath(folder, "nowhere"), loading(folder; AMST_LIBRARY = ""))
        @test occursin("0.1.0", loading(folder; AMST_LIBRARY = library)) # goes first
    end
    mktempdir() do folder
        @test occursin("libm", loading(folder; AMST_LIBRARY = "libm.so.6")) # has no such functions
    end
end
