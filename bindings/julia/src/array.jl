# Arrays that the library fills. `get(out, capacity, needed)` is a getter of the header with its
# other arguments bound.

is_packed(array::AbstractArray) = false
is_packed(array::StridedArray) =
    stride(array, 1) == 1 && (ndims(array) == 1 || stride(array, 2) == size(array, 1))

# Fill the caller's array of elements T, in place if it lies packed in memory.
function fill_with!(get, ::Type{T}, out::AbstractArray, shape::Dims) where {T}
    size(out) == shape || throw(DimensionMismatch("the array is $(size(out)), but there are $shape numbers"))
    if eltype(out) === T && is_packed(out)
        demand(get(out, length(out), Ref{Int64}(0)))
    else
        copyto!(out, fill_with!(get, T, Array{T}(undef, shape), shape))
    end
    return out
end

# A vector as long as the answer.
function vector_of(get, ::Type{T}) where {T}
    needed = Ref{Int64}(0)
    demand(get(C_NULL, 0, needed))
    out = Vector{T}(undef, needed[])
    demand(get(out, length(out), needed))
    return out
end

# What `ask` writes through its argument.
function scalar(ask, ::Type{T}) where {T}
    out = Ref{T}(zero(T))
    demand(ask(out))
    return out[]
end

# Matrices that go in by pointer and strides.
const StridedColumns{T} = Union{StridedMatrix{T},
                                PermutedDimsArray{T,2,<:Any,<:Any,<:StridedMatrix{T}}}

# The library wants strides above 0; a view that runs backwards, or any other matrix, is copied.
by_strides(matrix::StridedColumns{T}, ::Type{T}) where {T} =
    all(>(0), strides(matrix)) ? matrix : Matrix{T}(matrix)
by_strides(matrix::AbstractMatrix, ::Type{T}) where {T} = Matrix{T}(matrix)

# Three coordinates, z = 0 if there are two.
function three_coordinates(point)
    length(point) in (2, 3) || throw(DimensionMismatch("a point has 2 or 3 coordinates"))
    return Float64[point[1], point[2], length(point) == 3 ? point[3] : 0]
end
