# Operations. Each changes the mesh or, on failure and on cancel, not at all; the patch set given
# to it moves along. All take the settings of `Options` as keywords and give a `Report`.

# `change(out)` is an operation of the header with its other arguments bound.
function operate(change, mesh::Mesh)
    out = Ref{Ptr{amst_report}}(C_NULL)
    status = change(out)
    report = Report(out[]) # before an exception can lose it
    demand(status, mesh.callbacks)
    return report
end

"""
    adapt!(mesh, patches, alpha; settings...)
    adapt!(mesh, alpha; settings...)

Fill each patch anew with round(alpha * faces) faces and few singularities; gives a
[`Report`](@ref). `alpha` is the wanted ratio of face counts for the patches that have none of
their own: below 1 coarser, above 1 finer, 1 only better. Patches with defects are left, see
[`is_partial`](@ref). Settings are those of [`Options`](@ref).

Without patches the whole mesh, plane or curved, with windows that the library chooses:
round(alpha * faces) faces, as few singular vertices as it can, boundary and features kept. A vertex
field `"size"` says where the faces go. A curved mesh keeps to its surface; features of one lose and get
vertices only where they are straight. With `edit_boundary = 1` the boundary may change, see [`Options`](@ref).

Throws `AlphaMSTError`: ARGUMENT (alpha <= 0, patches of another mesh), NOT_FINITE, STALE, STATE (in a
callback), CANCELLED.
"""
function adapt!(mesh::Mesh, patches::Patches, alpha::Real; options = nothing, settings...)
    given = chosen(options, settings)
    return operate(out -> amst_adapt(mesh, patches, alpha, given, out), mesh)
end

function adapt!(mesh::Mesh, alpha::Real; options = nothing, settings...)
    given = chosen(options, settings)
    return operate(out -> amst_adapt(mesh, nothing, alpha, given, out), mesh)
end

"""
    reduce_singularities!(mesh, patches = nothing; settings...)

Fill each patch anew with the fewest singularities that its boundary allows; gives a
[`Report`](@ref). Without patches the whole mesh; its number of faces stays within a few percent. Throws as [`adapt!`](@ref).
"""
function reduce_singularities!(mesh::Mesh, patches::Union{Patches,Nothing} = nothing; options = nothing,
                               settings...)
    given = chosen(options, settings)
    return operate(out -> amst_reduce_singularities(mesh, patches, given, out), mesh)
end

"""
    smooth!(mesh, patches = nothing; settings...)

Move the interior vertices of the patches, or of the whole mesh; flagged ones stay, but for
those on straight features of a curved mesh, which slide along them; the revision stays, too. Gives a [`Report`](@ref). Throws as [`adapt!`](@ref).
"""
function smooth!(mesh::Mesh, patches::Union{Patches,Nothing} = nothing; options = nothing, settings...)
    given = chosen(options, settings)
    return operate(out -> amst_smooth(mesh, patches, given, out), mesh)
end

"""
    clean!(mesh; settings...)

Remove doublets and split valences above 5; gives a [`Report`](@ref). The revision rises if there
were any. Throws as [`adapt!`](@ref).
"""
function clean!(mesh::Mesh; options = nothing, settings...)
    given = chosen(options, settings)
    return operate(out -> amst_clean(mesh, given, out), mesh)
end
