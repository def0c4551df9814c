# Failures of the library as exceptions.

"""
    AlphaMSTError

What a function throws when the library refuses or fails; everything is as it was before the call.

* `code`: the status, below 0; `status_name(code)` has its name
* `text`: the library's sentence
* `entity`: what it is about, `:vertex`, `:edge`, `:face` or `:none`
* `id`: number of that vertex, edge or face, 0 if none
* `patch`: number of the patch it is about, 0 if none
"""
struct AlphaMSTError <: Exception
    code::Int32
    text::String
    entity::Symbol
    id::Int32
    patch::Int32
end

# The library keeps its last error by thread, so this runs at once after the call.
function last_error(status::Int32)
    entity, id, patch = Ref(AMST_ENTITY_NONE), Ref(Int32(0)), Ref(Int32(0))
    amst_last_error_where(entity, id, patch)
    # Calls without a context number from 0, where "none" is -1.
    return AlphaMSTError(status, unsafe_string(amst_last_error()), name_of(entities, entity[], :none),
                         max(id[], 0), max(patch[], 0))
end

function Base.showerror(io::IO, failure::AlphaMSTError)
    print(io, status_name(failure.code), ": ", failure.text)
    place = String[]
    failure.entity === :none || push!(place, "$(failure.entity) $(failure.id)")
    failure.patch == 0 || push!(place, "patch $(failure.patch)")
    isempty(place) || print(io, " (", join(place, ", "), ")")
end

# Throws for a failure; otherwise gives the status back.
demand(status::Int32) = status < 0 ? throw(last_error(status)) : status

# ------------------------------------------------------------------- names of numbers

const entities = (vertex = AMST_VERTEX, edge = AMST_EDGE, face = AMST_FACE)

# The number of a name. Numbers pass, so that a table need not be complete.
number_of(table::NamedTuple, number::Integer) = Int32(number)
function number_of(table::NamedTuple, name::Symbol)
    haskey(table, name) || throw(ArgumentError("there is no :$name; there are $(join(keys(table), ", "))"))
    return table[name]
end

function name_of(table::NamedTuple, number::Int32, other::Symbol)
    place = findfirst(==(number), values(table))
    return place === nothing ? other : keys(table)[place]
end
