"""
The raw layer: every constant, type and function of `alphamst.h` under its own name, one line
each. Nothing is checked here; the functions of `AlphaMST` are the ones to call.
"""
module LibAlphaMST

using Libdl: RTLD_LOCAL, RTLD_NOW, dlopen, dlsym

# What the handles point to; never looked into.
abstract type amst_context end
abstract type amst_options end
abstract type amst_mesh end
abstract type amst_patches end
abstract type amst_report end

const amst_progress_fn = Ptr{Cvoid}
const amst_log_fn = Ptr{Cvoid}
const amst_projection_fn = Ptr{Cvoid}

"""
What `quality_summary` tells of one metric: the number of faces measured and of those inside the
metric's acceptable range, and the smallest, largest and mean value and the standard deviation
over all faces, in the unit of the metric.
"""
struct amst_summary
    count::Int64
    acceptable::Int64
    min::Float64
    max::Float64
    mean::Float64
    stddev::Float64
end

const AMST_VERSION_MAJOR = Int32(0)
const AMST_VERSION_MINOR = Int32(1)
const AMST_VERSION_PATCH = Int32(0)

# amst_status_code
const AMST_ERR_INTERNAL = Int32(-99)
const AMST_ERR_STATE = Int32(-16)
const AMST_ERR_NO_MEMORY = Int32(-15)
const AMST_ERR_CANCELLED = Int32(-14)
const AMST_ERR_UNSUPPORTED = Int32(-13)
const AMST_ERR_FORMAT = Int32(-12)
const AMST_ERR_IO = Int32(-11)
const AMST_ERR_NOT_FOUND = Int32(-10)
const AMST_ERR_STALE = Int32(-9)
const AMST_ERR_PATCH = Int32(-8)
const AMST_ERR_NO_FILLING = Int32(-17)
const AMST_ERR_GEOMETRY = Int32(-18)
const AMST_ERR_PROJECTION = Int32(-20)
const AMST_ERR_CHORD = Int32(-19)
const AMST_ERR_NOT_MANIFOLD = Int32(-7)
const AMST_ERR_NOT_QUAD = Int32(-6)
const AMST_ERR_NOT_FINITE = Int32(-5)
const AMST_ERR_BUFFER_TOO_SMALL = Int32(-4)
const AMST_ERR_RANGE = Int32(-3)
const AMST_ERR_ARGUMENT = Int32(-2)
const AMST_ERR_NULL = Int32(-1)
const AMST_OK = Int32(0)
const AMST_PARTIAL = Int32(1)
const AMST_STATUS_MAX = Int32(0x7fffffff)

# amst_entity
const AMST_ENTITY_NONE = Int32(-1)
const AMST_VERTEX = Int32(0)
const AMST_EDGE = Int32(1)
const AMST_FACE = Int32(2)
const AMST_ENTITY_MAX = Int32(0x7fffffff)

# amst_flag
const AMST_FLAG_INVALID = Int32(-1)
const AMST_FLAG_FIXED = Int32(1)
const AMST_FLAG_FEATURE = Int32(2)
const AMST_FLAG_CORNER = Int32(4)
const AMST_FLAG_MAX = Int32(0x7fffffff)

# amst_carry
const AMST_CARRY_INVALID = Int32(-1)
const AMST_CARRY_DROP = Int32(0)
const AMST_CARRY_INHERIT = Int32(1)
const AMST_CARRY_LINEAR = Int32(2)
const AMST_CARRY_CONSERVE = Int32(3)
const AMST_CARRY_AVERAGE = Int32(4)
const AMST_CARRY_MAX = Int32(0x7fffffff)

# amst_defect
const AMST_DEFECT_INVALID = Int32(-1)
const AMST_DEFECT_EMPTY = Int32(1)
const AMST_DEFECT_NOT_CONNECTED = Int32(2)
const AMST_DEFECT_NOT_DISK = Int32(4)
const AMST_DEFECT_PINCHED = Int32(8)
const AMST_DEFECT_OVERLAP = Int32(16)
const AMST_DEFECT_CROSSES_FEATURE = Int32(32)
const AMST_DEFECT_ODD_BOUNDARY = Int32(64)
const AMST_DEFECT_CORNERS = Int32(128)
const AMST_DEFECT_NOT_CONVEX = Int32(256)
const AMST_DEFECT_MAX = Int32(0x7fffffff)

# amst_chord_property
const AMST_CHORD_INVALID = Int32(-1)
const AMST_CHORD_EDGE = Int32(0)
const AMST_CHORD_CLOSED = Int32(1)
const AMST_CHORD_LENGTH = Int32(2)
const AMST_CHORD_FACES = Int32(3)
const AMST_CHORD_CROSSINGS = Int32(4)
const AMST_CHORD_TOUCHES = Int32(5)
const AMST_CHORD_SINGULARITIES = Int32(6)
const AMST_CHORD_REFUSAL = Int32(7)
const AMST_CHORD_SINGULAR_AFTER = Int32(8)
const AMST_CHORD_MAX = Int32(0x7fffffff)

# amst_refusal
const AMST_REFUSAL_INVALID = Int32(-1)
const AMST_REFUSAL_CROSSING = Int32(1)
const AMST_REFUSAL_CLOSED = Int32(2)
const AMST_REFUSAL_BOUNDARY = Int32(4)
const AMST_REFUSAL_FIXED = Int32(8)
const AMST_REFUSAL_FEATURE = Int32(16)
const AMST_REFUSAL_VALENCE = Int32(32)
const AMST_REFUSAL_DOUBLE = Int32(64)
const AMST_REFUSAL_MAX = Int32(0x7fffffff)

# amst_decomposition
const AMST_DECOMPOSE_INVALID = Int32(-1)
const AMST_DECOMPOSE_CLUSTERS = Int32(0)
const AMST_DECOMPOSE_PARTITION = Int32(1)
const AMST_DECOMPOSE_VORONOI = Int32(2)
const AMST_DECOMPOSE_MEDIAL = Int32(3)
const AMST_DECOMPOSE_SINGULARITIES = Int32(4)
const AMST_DECOMPOSE_MAX = Int32(0x7fffffff)

# amst_geometry
const AMST_GEOMETRY_INVALID = Int32(-1)
const AMST_GEOMETRY_CENTROIDS = Int32(0)
const AMST_GEOMETRY_LENGTHS = Int32(1)
const AMST_GEOMETRY_NORMALS = Int32(2)
const AMST_GEOMETRY_MAX = Int32(0x7fffffff)

# amst_metric
const AMST_METRIC_INVALID = Int32(-1)
const AMST_METRIC_AREA = Int32(0)
const AMST_METRIC_ASPECT_RATIO = Int32(1)
const AMST_METRIC_CONDITION = Int32(2)
const AMST_METRIC_DISTORTION = Int32(3)
const AMST_METRIC_EDGE_RATIO = Int32(4)
const AMST_METRIC_JACOBIAN = Int32(5)
const AMST_METRIC_MAX_ANGLE = Int32(6)
const AMST_METRIC_MIN_ANGLE = Int32(7)
const AMST_METRIC_ODDY = Int32(8)
const AMST_METRIC_RADIUS_RATIO = Int32(9)
const AMST_METRIC_RELATIVE_SIZE = Int32(10)
const AMST_METRIC_SCALED_JACOBIAN = Int32(11)
const AMST_METRIC_SHAPE = Int32(12)
const AMST_METRIC_SHAPE_AND_SIZE = Int32(13)
const AMST_METRIC_SHEAR = Int32(14)
const AMST_METRIC_SHEAR_AND_SIZE = Int32(15)
const AMST_METRIC_SKEW = Int32(16)
const AMST_METRIC_STRETCH = Int32(17)
const AMST_METRIC_TAPER = Int32(18)
const AMST_METRIC_WARPAGE = Int32(19)
const AMST_METRIC_MAX = Int32(0x7fffffff)

# amst_option
const AMST_OPTION_INVALID = Int32(-1)
const AMST_OPT_SEED = Int32(0)
const AMST_OPT_SMOOTH_STEPS = Int32(1)
const AMST_OPT_REPAIR_PATCHES = Int32(2)
const AMST_OPT_CANDIDATES = Int32(3)
const AMST_OPT_NODE_LIMIT = Int32(4)
const AMST_OPT_QUADRANGULATE = Int32(5)
const AMST_OPT_EDIT_BOUNDARY = Int32(6)
const AMST_OPT_STRATEGY = Int32(7)
const AMST_OPT_ALIGN = Int32(8)
const AMST_OPT_CHART = Int32(9)
const AMST_OPT_KEEP_BOUNDARY = Int32(10)
const AMST_OPT_STARTS = Int32(11)
const AMST_OPT_BUFFER_LAYERS = Int32(12)
const AMST_OPT_MIN_QUALITY = Int32(1000)
const AMST_OPT_MIN_CONVEXITY = Int32(1001)
const AMST_OPT_PATCH_FACES = Int32(1002)
const AMST_OPT_TOLERANCE = Int32(1003)
const AMST_OPT_EFFORT = Int32(1004)
const AMST_OPT_SIZE_WEIGHT = Int32(1005)
const AMST_OPT_TRANSITION = Int32(1006)
const AMST_OPT_LEAST_SIZE = Int32(1007)
const AMST_OPT_SHARP_ANGLE = Int32(1008)
const AMST_OPT_SIZE_BAND = Int32(1009)
const AMST_OPT_MIN_EDGE = Int32(1010)
const AMST_OPT_MAX_EDGE = Int32(1011)
const AMST_OPT_GRADATION = Int32(1012)
const AMST_OPT_ERROR_ORDER = Int32(1013)
const AMST_OPTION_MAX = Int32(0x7fffffff)

# amst_result
const AMST_RESULT_INVALID = Int32(-1)
const AMST_RESULT_STATUS = Int32(0)
const AMST_RESULT_FACES_BEFORE = Int32(1)
const AMST_RESULT_FACES_AFTER = Int32(2)
const AMST_RESULT_FACES_WANTED = Int32(3)
const AMST_RESULT_SINGULAR_BEFORE = Int32(4)
const AMST_RESULT_SINGULAR_AFTER = Int32(5)
const AMST_RESULT_SINGULAR_BOUND = Int32(6)
const AMST_RESULT_CANDIDATE = Int32(7)
const AMST_RESULT_UNUSED_OPTION = Int32(8)
const AMST_RESULT_ALPHA = Int32(1000)
const AMST_RESULT_QUALITY_BEFORE = Int32(1001)
const AMST_RESULT_QUALITY_AFTER = Int32(1002)
const AMST_RESULT_SECONDS = Int32(1003)
const AMST_RESULT_SIZE_ERROR_BEFORE = Int32(1004)
const AMST_RESULT_SIZE_ERROR_AFTER = Int32(1005)
const AMST_RESULT_LEAST_AREA_BEFORE = Int32(1006)
const AMST_RESULT_LEAST_AREA_AFTER = Int32(1007)
const AMST_RESULT_TIME_STEP = Int32(1008)
const AMST_RESULT_SHORTEST_EDGE_BEFORE = Int32(1009)
const AMST_RESULT_SHORTEST_EDGE_AFTER = Int32(1010)
const AMST_RESULT_ASPECT_RATIO_BEFORE = Int32(1011)
const AMST_RESULT_ASPECT_RATIO_AFTER = Int32(1012)
const AMST_RESULT_AREA_GAINED = Int32(1013)
const AMST_RESULT_MAX = Int32(0x7fffffff)

# amst_log_level
const AMST_LOG_OFF = Int32(-1)
const AMST_LOG_ERROR = Int32(0)
const AMST_LOG_WARNING = Int32(1)
const AMST_LOG_INFO = Int32(2)
const AMST_LOG_DEBUG = Int32(3)
const AMST_LOG_MAX = Int32(0x7fffffff)

# amst_scope
const AMST_ALL = Int32(-2)
const AMST_SCOPE_MAX = Int32(0x7fffffff)

# The library is found when the package is loaded, not when it is compiled, so a call goes
# through an address that `load` looks up. Julia before 1.6 has no other way to leave the library
# open, and a missing function is noticed at once, not in the middle of work.
const addresses = Pair{Symbol,Base.RefValue{Ptr{Cvoid}}}[]

"""
    @gc_safe(name(arguments::Types)::Result, address)

Call the function at `address` while the garbage collector may run: a thread inside the library holds no other
up. Arguments are converted before, as `ccall` does it, and kept alive; between `jl_gc_safe_enter` and `_leave`
nothing of Julia's is touched. Callbacks come back by `gc_unsafe`.
"""
macro gc_safe(signature, address)
    call, result = signature.args
    arguments = call.args[2:end]
    roots = [gensym(:root) for _ in arguments]
    values = [gensym(:value) for _ in arguments]
    convert = [:($root = Base.cconvert($(a.args[2]), $(a.args[1]))) for (root, a) in zip(roots, arguments)]
    point = [:($value = Base.unsafe_convert($(a.args[2]), $root)) for (value, root, a) in zip(values, roots, arguments)]
    # What has been converted is a number or an address, so that it is converted no more.
    types = Expr(:tuple, (a.args[2] for a in arguments)...)
    body = quote
        $(point...)
        state = ccall(:jl_gc_safe_enter, Int8, ())
        answer = ccall($address, $result, $types, $(values...))
        ccall(:jl_gc_safe_leave, Cvoid, (Int8,), state)
        answer
    end
    kept = isempty(roots) ? body : Expr(:macrocall, GlobalRef(GC, Symbol("@preserve")), __source__, roots..., body)
    return esc(quote
        $(convert...)
        $kept
    end)
end

"""
    gc_unsafe(f, arguments...)

What a callback does, which may allocate: the collector waits for it. `f` is not to be inlined, since whatever
it keeps for the collector must be noted after the change.
"""
@inline function gc_unsafe(f, arguments...)
    state = ccall(:jl_gc_unsafe_enter, Int8, ())
    answer = f(arguments...)
    ccall(:jl_gc_unsafe_leave, Cvoid, (Int8,), state)
    return answer
end

"""
Make of every line `name(arguments) = @ccall name(arguments::Types)::Result` in the block a function
that calls what `addresses` has for that name.
"""
macro entries(block)
    definitions = map(filter(line -> line isa Expr, block.args)) do line
        head = line.args[1]
        name = head.args[1]
        signature = last(last(last(line.args).args).args) # name(arguments::Types)::Result
        signature.args[1].args[1] === name || error("$name calls $(signature.args[1].args[1])")
        address = Symbol(:address_of_, name)
        quote
            const $address = Ref(C_NULL)
            push!(addresses, $(QuoteNode(name)) => $address)
            $head = @gc_safe($signature, $address[])
        end
    end
    return esc(Expr(:block, definitions...))
end

@entries begin
    amst_version() = @ccall amst_version()::Int32
    amst_version_string() = @ccall amst_version_string()::Cstring
    amst_has(feature) = @ccall amst_has(feature::Cstring)::Int32
    amst_status_name(status) = @ccall amst_status_name(status::Int32)::Cstring
    amst_last_error() = @ccall amst_last_error()::Cstring
    amst_last_error_where(entity, id, patch) = @ccall amst_last_error_where(entity::Ptr{Int32}, id::Ptr{Int32}, patch::Ptr{Int32})::Int32
    amst_context_create(index_base, out) = @ccall amst_context_create(index_base::Int32, out::Ptr{Ptr{amst_context}})::Int32
    amst_context_destroy(ctx) = @ccall amst_context_destroy(ctx::Ptr{amst_context})::Cvoid
    amst_context_set_threads(ctx, n) = @ccall amst_context_set_threads(ctx::Ptr{amst_context}, n::Int32)::Int32
    amst_context_set_log(ctx, level, fn, user) = @ccall amst_context_set_log(ctx::Ptr{amst_context}, level::Int32, fn::amst_log_fn, user::Ptr{Cvoid})::Int32
    amst_context_set_progress(ctx, fn, user) = @ccall amst_context_set_progress(ctx::Ptr{amst_context}, fn::amst_progress_fn, user::Ptr{Cvoid})::Int32
    amst_context_set_cancel(ctx, flag) = @ccall amst_context_set_cancel(ctx::Ptr{amst_context}, flag::Int32)::Int32
    amst_context_get_progress(ctx, fraction) = @ccall amst_context_get_progress(ctx::Ptr{amst_context}, fraction::Ptr{Float64})::Int32
    amst_options_create(out) = @ccall amst_options_create(out::Ptr{Ptr{amst_options}})::Int32
    amst_options_destroy(options) = @ccall amst_options_destroy(options::Ptr{amst_options})::Cvoid
    amst_options_set_int(options, key, value) = @ccall amst_options_set_int(options::Ptr{amst_options}, key::Int32, value::Int64)::Int32
    amst_options_set_real(options, key, value) = @ccall amst_options_set_real(options::Ptr{amst_options}, key::Int32, value::Float64)::Int32
    amst_options_get_int(options, key, value) = @ccall amst_options_get_int(options::Ptr{amst_options}, key::Int32, value::Ptr{Int64})::Int32
    amst_options_get_real(options, key, value) = @ccall amst_options_get_real(options::Ptr{amst_options}, key::Int32, value::Ptr{Float64})::Int32
    amst_options_set_edges(options, vertices, n_edges) = @ccall amst_options_set_edges(options::Ptr{amst_options}, vertices::Ptr{Int32}, n_edges::Int64)::Int32
    amst_options_get_edges(options, out, capacity, needed) = @ccall amst_options_get_edges(options::Ptr{amst_options}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_create(ctx, dim, coords, n_vertices, vertex_stride, component_stride, faces, n_faces, face_stride, corner_stride, corners_per_face, options, out) = @ccall amst_mesh_create(ctx::Ptr{amst_context}, dim::Int32, coords::Ptr{Float64}, n_vertices::Int64, vertex_stride::Int64, component_stride::Int64, faces::Ptr{Int32}, n_faces::Int64, face_stride::Int64, corner_stride::Int64, corners_per_face::Int32, options::Ptr{amst_options}, out::Ptr{Ptr{amst_mesh}})::Int32
    amst_mesh_create_i64(ctx, dim, coords, n_vertices, vertex_stride, component_stride, faces, n_faces, face_stride, corner_stride, corners_per_face, options, out) = @ccall amst_mesh_create_i64(ctx::Ptr{amst_context}, dim::Int32, coords::Ptr{Float64}, n_vertices::Int64, vertex_stride::Int64, component_stride::Int64, faces::Ptr{Int64}, n_faces::Int64, face_stride::Int64, corner_stride::Int64, corners_per_face::Int32, options::Ptr{amst_options}, out::Ptr{Ptr{amst_mesh}})::Int32
    amst_mesh_read(ctx, path, options, out) = @ccall amst_mesh_read(ctx::Ptr{amst_context}, path::Cstring, options::Ptr{amst_options}, out::Ptr{Ptr{amst_mesh}})::Int32
    amst_mesh_write(mesh, path) = @ccall amst_mesh_write(mesh::Ptr{amst_mesh}, path::Cstring)::Int32
    amst_mesh_clone_into(mesh, ctx, out) = @ccall amst_mesh_clone_into(mesh::Ptr{amst_mesh}, ctx::Ptr{amst_context}, out::Ptr{Ptr{amst_mesh}})::Int32
    amst_mesh_clone(mesh, out) = @ccall amst_mesh_clone(mesh::Ptr{amst_mesh}, out::Ptr{Ptr{amst_mesh}})::Int32
    amst_mesh_destroy(mesh) = @ccall amst_mesh_destroy(mesh::Ptr{amst_mesh})::Cvoid
    amst_mesh_get_dim(mesh, dim) = @ccall amst_mesh_get_dim(mesh::Ptr{amst_mesh}, dim::Ptr{Int32})::Int32
    amst_mesh_get_count(mesh, entity, count) = @ccall amst_mesh_get_count(mesh::Ptr{amst_mesh}, entity::Int32, count::Ptr{Int64})::Int32
    amst_mesh_get_revision(mesh, revision) = @ccall amst_mesh_get_revision(mesh::Ptr{amst_mesh}, revision::Ptr{Int64})::Int32
    amst_mesh_get_points(mesh, out, capacity, needed) = @ccall amst_mesh_get_points(mesh::Ptr{amst_mesh}, out::Ptr{Float64}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_set_points(mesh, points, n) = @ccall amst_mesh_set_points(mesh::Ptr{amst_mesh}, points::Ptr{Float64}, n::Int64)::Int32
    amst_mesh_get_faces(mesh, out, capacity, needed) = @ccall amst_mesh_get_faces(mesh::Ptr{amst_mesh}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_edges(mesh, out, capacity, needed) = @ccall amst_mesh_get_edges(mesh::Ptr{amst_mesh}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_crossed_edges(mesh, out, capacity, needed) = @ccall amst_mesh_get_crossed_edges(mesh::Ptr{amst_mesh}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_split_edges(mesh, out, capacity, needed) = @ccall amst_mesh_get_split_edges(mesh::Ptr{amst_mesh}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_edge_faces(mesh, out, capacity, needed) = @ccall amst_mesh_get_edge_faces(mesh::Ptr{amst_mesh}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_vertex_faces(mesh, offsets, out, capacity, needed) = @ccall amst_mesh_get_vertex_faces(mesh::Ptr{amst_mesh}, offsets::Ptr{Int32}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_geometry(mesh, key, out, capacity, needed) = @ccall amst_mesh_get_geometry(mesh::Ptr{amst_mesh}, key::Int32, out::Ptr{Float64}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_find_edges(mesh, pairs, n, edges) = @ccall amst_mesh_find_edges(mesh::Ptr{amst_mesh}, pairs::Ptr{Int32}, n::Int64, edges::Ptr{Int32})::Int32
    amst_mesh_get_valences(mesh, out, capacity, needed) = @ccall amst_mesh_get_valences(mesh::Ptr{amst_mesh}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_singularities(mesh, out, capacity, needed) = @ccall amst_mesh_get_singularities(mesh::Ptr{amst_mesh}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_check(mesh) = @ccall amst_mesh_check(mesh::Ptr{amst_mesh})::Int32
    amst_mesh_get_checksum(mesh, digest) = @ccall amst_mesh_get_checksum(mesh::Ptr{amst_mesh}, digest::Ptr{Int64})::Int32
    amst_mesh_set_flags(mesh, entity, ids, n, mask, value) = @ccall amst_mesh_set_flags(mesh::Ptr{amst_mesh}, entity::Int32, ids::Ptr{Int32}, n::Int64, mask::Int32, value::Int32)::Int32
    amst_mesh_get_flags(mesh, entity, out, capacity, needed) = @ccall amst_mesh_get_flags(mesh::Ptr{amst_mesh}, entity::Int32, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_detect_features(mesh, angle, found) = @ccall amst_mesh_detect_features(mesh::Ptr{amst_mesh}, angle::Float64, found::Ptr{Int64})::Int32
    amst_mesh_set_markers(mesh, entity, ids, n, value) = @ccall amst_mesh_set_markers(mesh::Ptr{amst_mesh}, entity::Int32, ids::Ptr{Int32}, n::Int64, value::Int32)::Int32
    amst_mesh_get_markers(mesh, entity, out, capacity, needed) = @ccall amst_mesh_get_markers(mesh::Ptr{amst_mesh}, entity::Int32, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_marker_list(mesh, entity, out, capacity, needed) = @ccall amst_mesh_get_marker_list(mesh::Ptr{amst_mesh}, entity::Int32, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_set_marker_name(mesh, entity, marker, name) = @ccall amst_mesh_set_marker_name(mesh::Ptr{amst_mesh}, entity::Int32, marker::Int32, name::Cstring)::Int32
    amst_mesh_get_marker_name(mesh, entity, marker, out, capacity, needed) = @ccall amst_mesh_get_marker_name(mesh::Ptr{amst_mesh}, entity::Int32, marker::Int32, out::Ptr{Cchar}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_set_field(mesh, entity, name, components, carry, values, n) = @ccall amst_mesh_set_field(mesh::Ptr{amst_mesh}, entity::Int32, name::Cstring, components::Int32, carry::Int32, values::Ptr{Float64}, n::Int64)::Int32
    amst_mesh_get_field(mesh, entity, name, out, capacity, needed) = @ccall amst_mesh_get_field(mesh::Ptr{amst_mesh}, entity::Int32, name::Cstring, out::Ptr{Float64}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_remove_field(mesh, entity, name) = @ccall amst_mesh_remove_field(mesh::Ptr{amst_mesh}, entity::Int32, name::Cstring)::Int32
    amst_mesh_size_from_indicator(mesh, indicator, n, tolerance, faces, options, asked_faces) = @ccall amst_mesh_size_from_indicator(mesh::Ptr{amst_mesh}, indicator::Ptr{Float64}, n::Int64, tolerance::Float64, faces::Int64, options::Ptr{amst_options}, asked_faces::Ptr{Float64})::Int32
    amst_mesh_get_overlap(before, after, before_faces, after_faces, areas, capacity, needed) = @ccall amst_mesh_get_overlap(before::Ptr{amst_mesh}, after::Ptr{amst_mesh}, before_faces::Ptr{Int32}, after_faces::Ptr{Int32}, areas::Ptr{Float64}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_compute_cross_field(mesh, options) = @ccall amst_mesh_compute_cross_field(mesh::Ptr{amst_mesh}, options::Ptr{amst_options})::Int32
    amst_mesh_get_alignment(mesh, mean_degrees) = @ccall amst_mesh_get_alignment(mesh::Ptr{amst_mesh}, mean_degrees::Ptr{Float64})::Int32
    amst_mesh_set_surface(mesh, points, n_points, triangles, n_triangles) = @ccall amst_mesh_set_surface(mesh::Ptr{amst_mesh}, points::Ptr{Float64}, n_points::Int64, triangles::Ptr{Int32}, n_triangles::Int64)::Int32
    amst_mesh_set_projection(mesh, fn, user) = @ccall amst_mesh_set_projection(mesh::Ptr{amst_mesh}, fn::amst_projection_fn, user::Ptr{Cvoid})::Int32
    amst_mesh_mark(mesh, revision) = @ccall amst_mesh_mark(mesh::Ptr{amst_mesh}, revision::Ptr{Int64})::Int32
    amst_mesh_rollback(mesh, revision) = @ccall amst_mesh_rollback(mesh::Ptr{amst_mesh}, revision::Int64)::Int32
    amst_mesh_forget(mesh, revision) = @ccall amst_mesh_forget(mesh::Ptr{amst_mesh}, revision::Int64)::Int32
    amst_patches_create(mesh, options, out) = @ccall amst_patches_create(mesh::Ptr{amst_mesh}, options::Ptr{amst_options}, out::Ptr{Ptr{amst_patches}})::Int32
    amst_patches_destroy(patches) = @ccall amst_patches_destroy(patches::Ptr{amst_patches})::Cvoid
    amst_patches_add_faces(patches, faces, n, patch) = @ccall amst_patches_add_faces(patches::Ptr{amst_patches}, faces::Ptr{Int32}, n::Int64, patch::Ptr{Int32})::Int32
    amst_patches_add_rings(patches, vertex, rings, patch) = @ccall amst_patches_add_rings(patches::Ptr{amst_patches}, vertex::Int32, rings::Int32, patch::Ptr{Int32})::Int32
    amst_patches_add_ball(patches, center, radius, patch) = @ccall amst_patches_add_ball(patches::Ptr{amst_patches}, center::Ptr{Float64}, radius::Float64, patch::Ptr{Int32})::Int32
    amst_patches_add_box(patches, low, high, patch) = @ccall amst_patches_add_box(patches::Ptr{amst_patches}, low::Ptr{Float64}, high::Ptr{Float64}, patch::Ptr{Int32})::Int32
    amst_patches_decompose(patches, method, added) = @ccall amst_patches_decompose(patches::Ptr{amst_patches}, method::Int32, added::Ptr{Int64})::Int32
    amst_patches_set_corners(patches, patch, vertices, n) = @ccall amst_patches_set_corners(patches::Ptr{amst_patches}, patch::Int32, vertices::Ptr{Int32}, n::Int64)::Int32
    amst_patches_set_alpha(patches, patch, alpha) = @ccall amst_patches_set_alpha(patches::Ptr{amst_patches}, patch::Int32, alpha::Float64)::Int32
    amst_patches_get_count(patches, count) = @ccall amst_patches_get_count(patches::Ptr{amst_patches}, count::Ptr{Int64})::Int32
    amst_patches_get_faces(patches, patch, out, capacity, needed) = @ccall amst_patches_get_faces(patches::Ptr{amst_patches}, patch::Int32, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_patches_get_boundary(patches, patch, out, capacity, needed) = @ccall amst_patches_get_boundary(patches::Ptr{amst_patches}, patch::Int32, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_patches_get_corners(patches, patch, out, capacity, needed) = @ccall amst_patches_get_corners(patches::Ptr{amst_patches}, patch::Int32, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_patches_check(patches, patch, defects, convexity) = @ccall amst_patches_check(patches::Ptr{amst_patches}, patch::Int32, defects::Ptr{Int32}, convexity::Ptr{Float64})::Int32
    amst_patches_write(patches, path) = @ccall amst_patches_write(patches::Ptr{amst_patches}, path::Cstring)::Int32
    amst_patches_predict(patches, patch, alpha, options, faces, singularities) = @ccall amst_patches_predict(patches::Ptr{amst_patches}, patch::Int32, alpha::Float64, options::Ptr{amst_options}, faces::Ptr{Int64}, singularities::Ptr{Int64})::Int32
    amst_adapt(mesh, patches, alpha, options, report) = @ccall amst_adapt(mesh::Ptr{amst_mesh}, patches::Ptr{amst_patches}, alpha::Float64, options::Ptr{amst_options}, report::Ptr{Ptr{amst_report}})::Int32
    amst_reduce_singularities(mesh, patches, options, report) = @ccall amst_reduce_singularities(mesh::Ptr{amst_mesh}, patches::Ptr{amst_patches}, options::Ptr{amst_options}, report::Ptr{Ptr{amst_report}})::Int32
    amst_smooth(mesh, patches, options, report) = @ccall amst_smooth(mesh::Ptr{amst_mesh}, patches::Ptr{amst_patches}, options::Ptr{amst_options}, report::Ptr{Ptr{amst_report}})::Int32
    amst_clean(mesh, options, report) = @ccall amst_clean(mesh::Ptr{amst_mesh}, options::Ptr{amst_options}, report::Ptr{Ptr{amst_report}})::Int32
    amst_mesh_get_chord(mesh, edge, closed, crossings, out, capacity, needed) = @ccall amst_mesh_get_chord(mesh::Ptr{amst_mesh}, edge::Int32, closed::Ptr{Int32}, crossings::Ptr{Int64}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_chord_ids(mesh, n_chords, out, capacity, needed) = @ccall amst_mesh_get_chord_ids(mesh::Ptr{amst_mesh}, n_chords::Ptr{Int64}, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_chords(mesh, property, options, out, capacity, needed) = @ccall amst_mesh_get_chords(mesh::Ptr{amst_mesh}, property::Int32, options::Ptr{amst_options}, out::Ptr{Int64}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_collapse_chord(mesh, edge, options, report) = @ccall amst_collapse_chord(mesh::Ptr{amst_mesh}, edge::Int32, options::Ptr{amst_options}, report::Ptr{Ptr{amst_report}})::Int32
    amst_split_chord(mesh, edge, n, options, report) = @ccall amst_split_chord(mesh::Ptr{amst_mesh}, edge::Int32, n::Int32, options::Ptr{amst_options}, report::Ptr{Ptr{amst_report}})::Int32
    amst_insert_chords(mesh, patches, n, options, report) = @ccall amst_insert_chords(mesh::Ptr{amst_mesh}, patches::Ptr{amst_patches}, n::Int32, options::Ptr{amst_options}, report::Ptr{Ptr{amst_report}})::Int32
    amst_mesh_get_quality(mesh, metric, out, capacity, needed) = @ccall amst_mesh_get_quality(mesh::Ptr{amst_mesh}, metric::Int32, out::Ptr{Float64}, capacity::Int64, needed::Ptr{Int64})::Int32
    amst_mesh_get_summary(mesh, metric, out) = @ccall amst_mesh_get_summary(mesh::Ptr{amst_mesh}, metric::Int32, out::Ptr{amst_summary})::Int32
    amst_report_destroy(report) = @ccall amst_report_destroy(report::Ptr{amst_report})::Cvoid
    amst_report_get_int(report, patch, key, value) = @ccall amst_report_get_int(report::Ptr{amst_report}, patch::Int32, key::Int32, value::Ptr{Int64})::Int32
    amst_report_get_real(report, patch, key, value) = @ccall amst_report_get_real(report::Ptr{amst_report}, patch::Int32, key::Int32, value::Ptr{Float64})::Int32
    amst_report_get_valence(report, patch, after, valence, count) = @ccall amst_report_get_valence(report::Ptr{amst_report}, patch::Int32, after::Int32, valence::Int32, count::Ptr{Int64})::Int32
    amst_report_get_origin(report, entity, out, capacity, needed) = @ccall amst_report_get_origin(report::Ptr{amst_report}, entity::Int32, out::Ptr{Int32}, capacity::Int64, needed::Ptr{Int64})::Int32
end

"Open the library at `path` and look up every function. Errors as those of `Libdl.dlopen`."
function load(path::AbstractString)
    # Not with Julia's default RTLD_DEEPBIND: where Julia shares its unwinder with C++, as Debian's
    # does, the library would raise its exceptions with one and catch them with another.
    library = dlopen(path, RTLD_NOW | RTLD_LOCAL)
    for (name, address) in addresses
        address[] = dlsym(library, name)
    end
    return nothing
end

for name in names(@__MODULE__; all = true)
    startswith(lowercase(string(name)), "amst_") && @eval export $name
end

end
