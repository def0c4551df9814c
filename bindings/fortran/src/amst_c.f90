!> The C interface of AlphaMST, function by function. Nothing is added: alphamst.h has the meaning
!> of every call, and its rules for errors, ownership, arrays, ids and threads hold here.
!>
!> Handles are type(c_ptr); c_null_ptr stands for NULL. An argument that may be NULL in C and is no
!> handle is optional: leave it out for NULL. Outputs are intent(inout), since a call that fails
!> leaves them as they were. Strings end with c_null_char.
module amst_c
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_funptr, c_int32_t, c_int64_t, c_ptr
    implicit none
    private :: c_char, c_double, c_funptr, c_int32_t, c_int64_t, c_ptr

    integer(c_int32_t), parameter :: AMST_VERSION_MAJOR = 0
    integer(c_int32_t), parameter :: AMST_VERSION_MINOR = 1
    integer(c_int32_t), parameter :: AMST_VERSION_PATCH = 0

    ! amst_status_code
    integer(c_int32_t), parameter :: AMST_ERR_INTERNAL = -99
    integer(c_int32_t), parameter :: AMST_ERR_STATE = -16
    integer(c_int32_t), parameter :: AMST_ERR_NO_MEMORY = -15
    integer(c_int32_t), parameter :: AMST_ERR_CANCELLED = -14
    integer(c_int32_t), parameter :: AMST_ERR_UNSUPPORTED = -13
    integer(c_int32_t), parameter :: AMST_ERR_FORMAT = -12
    integer(c_int32_t), parameter :: AMST_ERR_IO = -11
    integer(c_int32_t), parameter :: AMST_ERR_NOT_FOUND = -10
    integer(c_int32_t), parameter :: AMST_ERR_STALE = -9
    integer(c_int32_t), parameter :: AMST_ERR_PATCH = -8
    integer(c_int32_t), parameter :: AMST_ERR_NO_FILLING = -17
    integer(c_int32_t), parameter :: AMST_ERR_GEOMETRY = -18
    integer(c_int32_t), parameter :: AMST_ERR_CHORD = -19
    integer(c_int32_t), parameter :: AMST_ERR_NOT_MANIFOLD = -7
    integer(c_int32_t), parameter :: AMST_ERR_NOT_QUAD = -6
    integer(c_int32_t), parameter :: AMST_ERR_NOT_FINITE = -5
    integer(c_int32_t), parameter :: AMST_ERR_BUFFER_TOO_SMALL = -4
    integer(c_int32_t), parameter :: AMST_ERR_RANGE = -3
    integer(c_int32_t), parameter :: AMST_ERR_ARGUMENT = -2
    integer(c_int32_t), parameter :: AMST_ERR_NULL = -1
    integer(c_int32_t), parameter :: AMST_OK = 0
    integer(c_int32_t), parameter :: AMST_PARTIAL = 1
    integer(c_int32_t), parameter :: AMST_STATUS_MAX = 2147483647

    ! amst_entity
    integer(c_int32_t), parameter :: AMST_ENTITY_NONE = -1
    integer(c_int32_t), parameter :: AMST_VERTEX = 0
    integer(c_int32_t), parameter :: AMST_EDGE = 1
    integer(c_int32_t), parameter :: AMST_FACE = 2
    integer(c_int32_t), parameter :: AMST_ENTITY_MAX = 2147483647

    ! amst_flag
    integer(c_int32_t), parameter :: AMST_FLAG_INVALID = -1
    integer(c_int32_t), parameter :: AMST_FLAG_FIXED = 1
    integer(c_int32_t), parameter :: AMST_FLAG_FEATURE = 2
    integer(c_int32_t), parameter :: AMST_FLAG_CORNER = 4
    integer(c_int32_t), parameter :: AMST_FLAG_MAX = 2147483647

    ! amst_carry
    integer(c_int32_t), parameter :: AMST_CARRY_INVALID = -1
    integer(c_int32_t), parameter :: AMST_CARRY_DROP = 0
    integer(c_int32_t), parameter :: AMST_CARRY_INHERIT = 1
    integer(c_int32_t), parameter :: AMST_CARRY_LINEAR = 2
    integer(c_int32_t), parameter :: AMST_CARRY_CONSERVE = 3
    integer(c_int32_t), parameter :: AMST_CARRY_MAX = 2147483647

    ! amst_defect
    integer(c_int32_t), parameter :: AMST_DEFECT_INVALID = -1
    integer(c_int32_t), parameter :: AMST_DEFECT_EMPTY = 1
    integer(c_int32_t), parameter :: AMST_DEFECT_NOT_CONNECTED = 2
    integer(c_int32_t), parameter :: AMST_DEFECT_NOT_DISK = 4
    integer(c_int32_t), parameter :: AMST_DEFECT_PINCHED = 8
    integer(c_int32_t), parameter :: AMST_DEFECT_OVERLAP = 16
    integer(c_int32_t), parameter :: AMST_DEFECT_CROSSES_FEATURE = 32
    integer(c_int32_t), parameter :: AMST_DEFECT_ODD_BOUNDARY = 64
    integer(c_int32_t), parameter :: AMST_DEFECT_CORNERS = 128
    integer(c_int32_t), parameter :: AMST_DEFECT_NOT_CONVEX = 256
    integer(c_int32_t), parameter :: AMST_DEFECT_MAX = 2147483647

    ! amst_chord_property
    integer(c_int32_t), parameter :: AMST_CHORD_INVALID = -1
    integer(c_int32_t), parameter :: AMST_CHORD_EDGE = 0
    integer(c_int32_t), parameter :: AMST_CHORD_CLOSED = 1
    integer(c_int32_t), parameter :: AMST_CHORD_LENGTH = 2
    integer(c_int32_t), parameter :: AMST_CHORD_FACES = 3
    integer(c_int32_t), parameter :: AMST_CHORD_CROSSINGS = 4
    integer(c_int32_t), parameter :: AMST_CHORD_TOUCHES = 5
    integer(c_int32_t), parameter :: AMST_CHORD_SINGULARITIES = 6
    integer(c_int32_t), parameter :: AMST_CHORD_REFUSAL = 7
    integer(c_int32_t), parameter :: AMST_CHORD_SINGULAR_AFTER = 8
    integer(c_int32_t), parameter :: AMST_CHORD_MAX = 2147483647

    ! amst_refusal
    integer(c_int32_t), parameter :: AMST_REFUSAL_INVALID = -1
    integer(c_int32_t), parameter :: AMST_REFUSAL_CROSSING = 1
    integer(c_int32_t), parameter :: AMST_REFUSAL_CLOSED = 2
    integer(c_int32_t), parameter :: AMST_REFUSAL_BOUNDARY = 4
    integer(c_int32_t), parameter :: AMST_REFUSAL_FIXED = 8
    integer(c_int32_t), parameter :: AMST_REFUSAL_FEATURE = 16
    integer(c_int32_t), parameter :: AMST_REFUSAL_VALENCE = 32
    integer(c_int32_t), parameter :: AMST_REFUSAL_DOUBLE = 64
    integer(c_int32_t), parameter :: AMST_REFUSAL_MAX = 2147483647

    ! amst_decomposition
    integer(c_int32_t), parameter :: AMST_DECOMPOSE_INVALID = -1
    integer(c_int32_t), parameter :: AMST_DECOMPOSE_CLUSTERS = 0
    integer(c_int32_t), parameter :: AMST_DECOMPOSE_PARTITION = 1
    integer(c_int32_t), parameter :: AMST_DECOMPOSE_VORONOI = 2
    integer(c_int32_t), parameter :: AMST_DECOMPOSE_MEDIAL = 3
    integer(c_int32_t), parameter :: AMST_DECOMPOSE_SINGULARITIES = 4
    integer(c_int32_t), parameter :: AMST_DECOMPOSE_MAX = 2147483647

    ! amst_metric
    integer(c_int32_t), parameter :: AMST_METRIC_INVALID = -1
    integer(c_int32_t), parameter :: AMST_METRIC_AREA = 0
    integer(c_int32_t), parameter :: AMST_METRIC_ASPECT_RATIO = 1
    integer(c_int32_t), parameter :: AMST_METRIC_CONDITION = 2
    integer(c_int32_t), parameter :: AMST_METRIC_DISTORTION = 3
    integer(c_int32_t), parameter :: AMST_METRIC_EDGE_RATIO = 4
    integer(c_int32_t), parameter :: AMST_METRIC_JACOBIAN = 5
    integer(c_int32_t), parameter :: AMST_METRIC_MAX_ANGLE = 6
    integer(c_int32_t), parameter :: AMST_METRIC_MIN_ANGLE = 7
    integer(c_int32_t), parameter :: AMST_METRIC_ODDY = 8
    integer(c_int32_t), parameter :: AMST_METRIC_RADIUS_RATIO = 9
    integer(c_int32_t), parameter :: AMST_METRIC_RELATIVE_SIZE = 10
    integer(c_int32_t), parameter :: AMST_METRIC_SCALED_JACOBIAN = 11
    integer(c_int32_t), parameter :: AMST_METRIC_SHAPE = 12
    integer(c_int32_t), parameter :: AMST_METRIC_SHAPE_AND_SIZE = 13
    integer(c_int32_t), parameter :: AMST_METRIC_SHEAR = 14
    integer(c_int32_t), parameter :: AMST_METRIC_SHEAR_AND_SIZE = 15
    integer(c_int32_t), parameter :: AMST_METRIC_SKEW = 16
    integer(c_int32_t), parameter :: AMST_METRIC_STRETCH = 17
    integer(c_int32_t), parameter :: AMST_METRIC_TAPER = 18
    integer(c_int32_t), parameter :: AMST_METRIC_WARPAGE = 19
    integer(c_int32_t), parameter :: AMST_METRIC_MAX = 2147483647

    ! amst_option
    integer(c_int32_t), parameter :: AMST_OPTION_INVALID = -1
    integer(c_int32_t), parameter :: AMST_OPT_SEED = 0
    integer(c_int32_t), parameter :: AMST_OPT_SMOOTH_STEPS = 1
    integer(c_int32_t), parameter :: AMST_OPT_REPAIR_PATCHES = 2
    integer(c_int32_t), parameter :: AMST_OPT_CANDIDATES = 3
    integer(c_int32_t), parameter :: AMST_OPT_NODE_LIMIT = 4
    integer(c_int32_t), parameter :: AMST_OPT_QUADRANGULATE = 5
    integer(c_int32_t), parameter :: AMST_OPT_EDIT_BOUNDARY = 6
    integer(c_int32_t), parameter :: AMST_OPT_STRATEGY = 7
    integer(c_int32_t), parameter :: AMST_OPT_MIN_QUALITY = 1000
    integer(c_int32_t), parameter :: AMST_OPT_MIN_CONVEXITY = 1001
    integer(c_int32_t), parameter :: AMST_OPT_PATCH_FACES = 1002
    integer(c_int32_t), parameter :: AMST_OPTION_MAX = 2147483647

    ! amst_result
    integer(c_int32_t), parameter :: AMST_RESULT_INVALID = -1
    integer(c_int32_t), parameter :: AMST_RESULT_STATUS = 0
    integer(c_int32_t), parameter :: AMST_RESULT_FACES_BEFORE = 1
    integer(c_int32_t), parameter :: AMST_RESULT_FACES_AFTER = 2
    integer(c_int32_t), parameter :: AMST_RESULT_FACES_WANTED = 3
    integer(c_int32_t), parameter :: AMST_RESULT_SINGULAR_BEFORE = 4
    integer(c_int32_t), parameter :: AMST_RESULT_SINGULAR_AFTER = 5
    integer(c_int32_t), parameter :: AMST_RESULT_SINGULAR_BOUND = 6
    integer(c_int32_t), parameter :: AMST_RESULT_CANDIDATE = 7
    integer(c_int32_t), parameter :: AMST_RESULT_ALPHA = 1000
    integer(c_int32_t), parameter :: AMST_RESULT_QUALITY_BEFORE = 1001
    integer(c_int32_t), parameter :: AMST_RESULT_QUALITY_AFTER = 1002
    integer(c_int32_t), parameter :: AMST_RESULT_SECONDS = 1003
    integer(c_int32_t), parameter :: AMST_RESULT_MAX = 2147483647

    ! amst_log_level
    integer(c_int32_t), parameter :: AMST_LOG_OFF = -1
    integer(c_int32_t), parameter :: AMST_LOG_ERROR = 0
    integer(c_int32_t), parameter :: AMST_LOG_WARNING = 1
    integer(c_int32_t), parameter :: AMST_LOG_INFO = 2
    integer(c_int32_t), parameter :: AMST_LOG_DEBUG = 3
    integer(c_int32_t), parameter :: AMST_LOG_MAX = 2147483647

    ! amst_scope
    integer(c_int32_t), parameter :: AMST_ALL = -2
    integer(c_int32_t), parameter :: AMST_SCOPE_MAX = 2147483647

    !> What a metric is over all faces; the 48 bytes of the C structure.
    type, bind(c) :: amst_summary
        integer(c_int64_t) :: count       !< faces measured
        integer(c_int64_t) :: acceptable  !< faces inside the metric's acceptable range
        real(c_double) :: min
        real(c_double) :: max
        real(c_double) :: mean
        real(c_double) :: stddev
    end type amst_summary

    abstract interface
        !> fraction is 0..1, stage a static English word, ended by a null. Return non-zero to cancel.
        integer(c_int32_t) function amst_progress_fn(user, fraction, stage) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: user
            real(c_double), value :: fraction
            type(c_ptr), value :: stage
        end function amst_progress_fn

        !> message is ended by a null and valid during the call only.
        subroutine amst_log_fn(user, level, message) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: user
            integer(c_int32_t), value :: level
            type(c_ptr), value :: message
        end subroutine amst_log_fn
    end interface

    interface
        ! library and errors

        integer(c_int32_t) function amst_version() bind(c)
            import :: c_int32_t
            implicit none
        end function amst_version

        type(c_ptr) function amst_version_string() bind(c)
            import :: c_ptr
            implicit none
        end function amst_version_string

        integer(c_int32_t) function amst_has(feature) bind(c)
            import :: c_char, c_int32_t
            implicit none
            character(kind=c_char), intent(in) :: feature(*)
        end function amst_has

        type(c_ptr) function amst_status_name(status) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            integer(c_int32_t), value :: status
        end function amst_status_name

        type(c_ptr) function amst_last_error() bind(c)
            import :: c_ptr
            implicit none
        end function amst_last_error

        integer(c_int32_t) function amst_last_error_where(entity, id, patch) bind(c)
            import :: c_int32_t
            implicit none
            integer(c_int32_t), intent(inout), optional :: entity, id, patch
        end function amst_last_error_where

        ! context

        integer(c_int32_t) function amst_context_create(index_base, out) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            integer(c_int32_t), value :: index_base
            type(c_ptr), intent(inout) :: out
        end function amst_context_create

        subroutine amst_context_destroy(ctx) bind(c)
            import :: c_ptr
            implicit none
            type(c_ptr), value :: ctx
        end subroutine amst_context_destroy

        integer(c_int32_t) function amst_context_set_threads(ctx, n) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            integer(c_int32_t), value :: n
        end function amst_context_set_threads

        integer(c_int32_t) function amst_context_set_log(ctx, level, fn, user) bind(c)
            import :: c_funptr, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            integer(c_int32_t), value :: level
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
        end function amst_context_set_log

        integer(c_int32_t) function amst_context_set_progress(ctx, fn, user) bind(c)
            import :: c_funptr, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
        end function amst_context_set_progress

        integer(c_int32_t) function amst_context_set_cancel(ctx, flag) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            integer(c_int32_t), value :: flag
        end function amst_context_set_cancel

        integer(c_int32_t) function amst_context_get_progress(ctx, fraction) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            real(c_double), intent(inout) :: fraction
        end function amst_context_get_progress

        ! options

        integer(c_int32_t) function amst_options_create(out) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), intent(inout) :: out
        end function amst_options_create

        subroutine amst_options_destroy(options) bind(c)
            import :: c_ptr
            implicit none
            type(c_ptr), value :: options
        end subroutine amst_options_destroy

        integer(c_int32_t) function amst_options_set_int(options, key, value) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: options
            integer(c_int32_t), value :: key
            integer(c_int64_t), value :: value
        end function amst_options_set_int

        integer(c_int32_t) function amst_options_set_real(options, key, value) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: options
            integer(c_int32_t), value :: key
            real(c_double), value :: value
        end function amst_options_set_real

        integer(c_int32_t) function amst_options_get_int(options, key, value) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: options
            integer(c_int32_t), value :: key
            integer(c_int64_t), intent(inout) :: value
        end function amst_options_get_int

        integer(c_int32_t) function amst_options_get_real(options, key, value) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: options
            integer(c_int32_t), value :: key
            real(c_double), intent(inout) :: value
        end function amst_options_get_real

        ! mesh

        integer(c_int32_t) function amst_mesh_create(ctx, dim, coords, n_vertices, vertex_stride, &
                component_stride, faces, n_faces, face_stride, corner_stride, corners_per_face, &
                options, out) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: coords(*)
            integer(c_int64_t), value :: n_vertices, vertex_stride, component_stride
            integer(c_int32_t), intent(in), optional :: faces(*)
            integer(c_int64_t), value :: n_faces, face_stride, corner_stride
            integer(c_int32_t), value :: corners_per_face
            type(c_ptr), value :: options
            type(c_ptr), intent(inout) :: out
        end function amst_mesh_create

        integer(c_int32_t) function amst_mesh_create_i64(ctx, dim, coords, n_vertices, vertex_stride, &
                component_stride, faces, n_faces, face_stride, corner_stride, corners_per_face, &
                options, out) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: coords(*)
            integer(c_int64_t), value :: n_vertices, vertex_stride, component_stride
            integer(c_int64_t), intent(in), optional :: faces(*)
            integer(c_int64_t), value :: n_faces, face_stride, corner_stride
            integer(c_int32_t), value :: corners_per_face
            type(c_ptr), value :: options
            type(c_ptr), intent(inout) :: out
        end function amst_mesh_create_i64

        integer(c_int32_t) function amst_mesh_read(ctx, path, options, out) bind(c)
            import :: c_char, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            character(kind=c_char), intent(in) :: path(*)
            type(c_ptr), value :: options
            type(c_ptr), intent(inout) :: out
        end function amst_mesh_read

        integer(c_int32_t) function amst_mesh_write(mesh, path) bind(c)
            import :: c_char, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            character(kind=c_char), intent(in) :: path(*)
        end function amst_mesh_write

        integer(c_int32_t) function amst_mesh_clone(mesh, out) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            type(c_ptr), intent(inout) :: out
        end function amst_mesh_clone

        subroutine amst_mesh_destroy(mesh) bind(c)
            import :: c_ptr
            implicit none
            type(c_ptr), value :: mesh
        end subroutine amst_mesh_destroy

        integer(c_int32_t) function amst_mesh_get_dim(mesh, dim) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout) :: dim
        end function amst_mesh_get_dim

        integer(c_int32_t) function amst_mesh_get_count(mesh, entity, count) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            integer(c_int64_t), intent(inout) :: count
        end function amst_mesh_get_count

        integer(c_int32_t) function amst_mesh_get_revision(mesh, revision) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), intent(inout) :: revision
        end function amst_mesh_get_revision

        integer(c_int32_t) function amst_mesh_get_points(mesh, out, capacity, needed) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_points

        integer(c_int32_t) function amst_mesh_set_points(mesh, points, n) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), intent(in), optional :: points(*)
            integer(c_int64_t), value :: n
        end function amst_mesh_set_points

        integer(c_int32_t) function amst_mesh_get_faces(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_faces

        integer(c_int32_t) function amst_mesh_get_edges(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_edges

        integer(c_int32_t) function amst_mesh_get_edge_faces(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_edge_faces

        integer(c_int32_t) function amst_mesh_find_edges(mesh, pairs, n, edges) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(in), optional :: pairs(*)
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(inout), optional :: edges(*)
        end function amst_mesh_find_edges

        integer(c_int32_t) function amst_mesh_get_valences(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_valences

        integer(c_int32_t) function amst_mesh_get_singularities(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_singularities

        integer(c_int32_t) function amst_mesh_check(mesh) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
        end function amst_mesh_check

        integer(c_int32_t) function amst_mesh_get_checksum(mesh, digest) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), intent(inout) :: digest
        end function amst_mesh_get_checksum

        ! flags

        integer(c_int32_t) function amst_mesh_set_flags(mesh, entity, ids, n, mask, value) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            integer(c_int32_t), intent(in), optional :: ids(*)
            integer(c_int64_t), value :: n
            integer(c_int32_t), value :: mask, value
        end function amst_mesh_set_flags

        integer(c_int32_t) function amst_mesh_get_flags(mesh, entity, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_flags

        integer(c_int32_t) function amst_mesh_detect_features(mesh, angle, found) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), value :: angle
            integer(c_int64_t), intent(inout), optional :: found
        end function amst_mesh_detect_features

        ! fields

        integer(c_int32_t) function amst_mesh_set_field(mesh, entity, name, components, carry, values, n) bind(c)
            import :: c_char, c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            character(kind=c_char), intent(in) :: name(*)
            integer(c_int32_t), value :: components, carry
            real(c_double), intent(in) :: values(*)
            integer(c_int64_t), value :: n
        end function amst_mesh_set_field

        integer(c_int32_t) function amst_mesh_get_field(mesh, entity, name, out, capacity, needed) bind(c)
            import :: c_char, c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            character(kind=c_char), intent(in) :: name(*)
            real(c_double), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_field

        integer(c_int32_t) function amst_mesh_remove_field(mesh, entity, name) bind(c)
            import :: c_char, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            character(kind=c_char), intent(in) :: name(*)
        end function amst_mesh_remove_field

        integer(c_int32_t) function amst_mesh_compute_cross_field(mesh, options) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
        end function amst_mesh_compute_cross_field

        integer(c_int32_t) function amst_mesh_get_alignment(mesh, mean_degrees) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), intent(inout) :: mean_degrees
        end function amst_mesh_get_alignment

        ! surface

        integer(c_int32_t) function amst_mesh_set_surface(mesh, points, n_points, triangles, n_triangles) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), intent(in), optional :: points(*)
            integer(c_int64_t), value :: n_points
            integer(c_int32_t), intent(in), optional :: triangles(*)
            integer(c_int64_t), value :: n_triangles
        end function amst_mesh_set_surface

        ! undoing

        integer(c_int32_t) function amst_mesh_mark(mesh, revision) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), intent(inout) :: revision
        end function amst_mesh_mark

        integer(c_int32_t) function amst_mesh_rollback(mesh, revision) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: revision
        end function amst_mesh_rollback

        integer(c_int32_t) function amst_mesh_forget(mesh, revision) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: revision
        end function amst_mesh_forget

        ! patches

        integer(c_int32_t) function amst_patches_create(mesh, options, out) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
            type(c_ptr), intent(inout) :: out
        end function amst_patches_create

        subroutine amst_patches_destroy(patches) bind(c)
            import :: c_ptr
            implicit none
            type(c_ptr), value :: patches
        end subroutine amst_patches_destroy

        integer(c_int32_t) function amst_patches_add_faces(patches, faces, n, patch) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), intent(in), optional :: faces(*)
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(inout), optional :: patch
        end function amst_patches_add_faces

        integer(c_int32_t) function amst_patches_add_rings(patches, vertex, rings, patch) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: vertex, rings
            integer(c_int32_t), intent(inout), optional :: patch
        end function amst_patches_add_rings

        integer(c_int32_t) function amst_patches_add_ball(patches, center, radius, patch) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            real(c_double), intent(in) :: center(3)
            real(c_double), value :: radius
            integer(c_int32_t), intent(inout), optional :: patch
        end function amst_patches_add_ball

        integer(c_int32_t) function amst_patches_add_box(patches, low, high, patch) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            real(c_double), intent(in) :: low(3), high(3)
            integer(c_int32_t), intent(inout), optional :: patch
        end function amst_patches_add_box

        integer(c_int32_t) function amst_patches_decompose(patches, method, added) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: method
            integer(c_int64_t), intent(inout), optional :: added
        end function amst_patches_decompose

        integer(c_int32_t) function amst_patches_set_corners(patches, patch, vertices, n) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(in), optional :: vertices(*)
            integer(c_int64_t), value :: n
        end function amst_patches_set_corners

        integer(c_int32_t) function amst_patches_set_alpha(patches, patch, alpha) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            real(c_double), value :: alpha
        end function amst_patches_set_alpha

        integer(c_int32_t) function amst_patches_get_count(patches, count) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int64_t), intent(inout) :: count
        end function amst_patches_get_count

        integer(c_int32_t) function amst_patches_get_faces(patches, patch, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_patches_get_faces

        integer(c_int32_t) function amst_patches_get_boundary(patches, patch, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_patches_get_boundary

        integer(c_int32_t) function amst_patches_get_corners(patches, patch, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_patches_get_corners

        integer(c_int32_t) function amst_patches_check(patches, patch, defects, convexity) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(inout) :: defects
            real(c_double), intent(inout), optional :: convexity
        end function amst_patches_check

        integer(c_int32_t) function amst_patches_write(patches, path) bind(c)
            import :: c_char, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            character(kind=c_char), intent(in) :: path(*)
        end function amst_patches_write

        integer(c_int32_t) function amst_patches_predict(patches, patch, alpha, options, faces, &
                singularities) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            real(c_double), value :: alpha
            type(c_ptr), value :: options
            integer(c_int64_t), intent(inout), optional :: faces, singularities
        end function amst_patches_predict

        ! operations

        integer(c_int32_t) function amst_adapt(mesh, patches, alpha, options, report) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, patches
            real(c_double), value :: alpha
            type(c_ptr), value :: options
            type(c_ptr), intent(inout), optional :: report
        end function amst_adapt

        integer(c_int32_t) function amst_reduce_singularities(mesh, patches, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, patches, options
            type(c_ptr), intent(inout), optional :: report
        end function amst_reduce_singularities

        integer(c_int32_t) function amst_smooth(mesh, patches, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, patches, options
            type(c_ptr), intent(inout), optional :: report
        end function amst_smooth

        integer(c_int32_t) function amst_clean(mesh, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
            type(c_ptr), intent(inout), optional :: report
        end function amst_clean

        ! chords

        integer(c_int32_t) function amst_mesh_get_chord(mesh, edge, closed, crossings, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: edge
            integer(c_int32_t), intent(inout), optional :: closed
            integer(c_int64_t), intent(inout), optional :: crossings
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_chord

        integer(c_int32_t) function amst_mesh_get_chord_ids(mesh, n_chords, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), intent(inout), optional :: n_chords
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_chord_ids

        integer(c_int32_t) function amst_mesh_get_chords(mesh, property, options, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
            integer(c_int32_t), value :: property
            integer(c_int64_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_chords

        integer(c_int32_t) function amst_collapse_chord(mesh, edge, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
            integer(c_int32_t), value :: edge
            type(c_ptr), intent(inout), optional :: report
        end function amst_collapse_chord

        integer(c_int32_t) function amst_split_chord(mesh, edge, n, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
            integer(c_int32_t), value :: edge, n
            type(c_ptr), intent(inout), optional :: report
        end function amst_split_chord

        integer(c_int32_t) function amst_insert_chords(mesh, patches, n, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, patches, options
            integer(c_int32_t), value :: n
            type(c_ptr), intent(inout), optional :: report
        end function amst_insert_chords

        ! quality

        integer(c_int32_t) function amst_mesh_get_quality(mesh, metric, out, capacity, needed) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: metric
            real(c_double), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_quality

        integer(c_int32_t) function amst_mesh_get_summary(mesh, metric, out) bind(c)
            import :: amst_summary, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: metric
            type(amst_summary), intent(inout) :: out
        end function amst_mesh_get_summary

        ! report

        subroutine amst_report_destroy(report) bind(c)
            import :: c_ptr
            implicit none
            type(c_ptr), value :: report
        end subroutine amst_report_destroy

        integer(c_int32_t) function amst_report_get_int(report, patch, key, value) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: report
            integer(c_int32_t), value :: patch, key
            integer(c_int64_t), intent(inout) :: value
        end function amst_report_get_int

        integer(c_int32_t) function amst_report_get_real(report, patch, key, value) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: report
            integer(c_int32_t), value :: patch, key
            real(c_double), intent(inout) :: value
        end function amst_report_get_real

        integer(c_int32_t) function amst_report_get_valence(report, patch, after, valence, count) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: report
            integer(c_int32_t), value :: patch, after, valence
            integer(c_int64_t), intent(inout) :: count
        end function amst_report_get_valence

        integer(c_int32_t) function amst_report_get_origin(report, entity, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: report
            integer(c_int32_t), value :: entity
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_report_get_origin
    end interface
end module amst_c
