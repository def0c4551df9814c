!> Constants, structures and callbacks of the C interface; part of amst_c.
module amst_c_types
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_ptr
    implicit none
    private :: c_double, c_int32_t, c_int64_t, c_ptr

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
    integer(c_int32_t), parameter :: AMST_ERR_PROJECTION = -20
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
    integer(c_int32_t), parameter :: AMST_CARRY_AVERAGE = 4
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

    ! amst_geometry
    integer(c_int32_t), parameter :: AMST_GEOMETRY_INVALID = -1
    integer(c_int32_t), parameter :: AMST_GEOMETRY_CENTROIDS = 0
    integer(c_int32_t), parameter :: AMST_GEOMETRY_LENGTHS = 1
    integer(c_int32_t), parameter :: AMST_GEOMETRY_NORMALS = 2
    integer(c_int32_t), parameter :: AMST_GEOMETRY_MAX = 2147483647

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
    integer(c_int32_t), parameter :: AMST_OPT_ALIGN = 8
    integer(c_int32_t), parameter :: AMST_OPT_CHART = 9
    integer(c_int32_t), parameter :: AMST_OPT_KEEP_BOUNDARY = 10
    integer(c_int32_t), parameter :: AMST_OPT_STARTS = 11
    integer(c_int32_t), parameter :: AMST_OPT_BUFFER_LAYERS = 12
    integer(c_int32_t), parameter :: AMST_OPT_MIN_QUALITY = 1000
    integer(c_int32_t), parameter :: AMST_OPT_MIN_CONVEXITY = 1001
    integer(c_int32_t), parameter :: AMST_OPT_PATCH_FACES = 1002
    integer(c_int32_t), parameter :: AMST_OPT_TOLERANCE = 1003
    integer(c_int32_t), parameter :: AMST_OPT_EFFORT = 1004
    integer(c_int32_t), parameter :: AMST_OPT_SIZE_WEIGHT = 1005
    integer(c_int32_t), parameter :: AMST_OPT_TRANSITION = 1006
    integer(c_int32_t), parameter :: AMST_OPT_LEAST_SIZE = 1007
    integer(c_int32_t), parameter :: AMST_OPT_SHARP_ANGLE = 1008
    integer(c_int32_t), parameter :: AMST_OPT_SIZE_BAND = 1009
    integer(c_int32_t), parameter :: AMST_OPT_MIN_EDGE = 1010
    integer(c_int32_t), parameter :: AMST_OPT_MAX_EDGE = 1011
    integer(c_int32_t), parameter :: AMST_OPT_GRADATION = 1012
    integer(c_int32_t), parameter :: AMST_OPT_ERROR_ORDER = 1013
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
    integer(c_int32_t), parameter :: AMST_RESULT_UNUSED_OPTION = 8
    integer(c_int32_t), parameter :: AMST_RESULT_ALPHA = 1000
    integer(c_int32_t), parameter :: AMST_RESULT_QUALITY_BEFORE = 1001
    integer(c_int32_t), parameter :: AMST_RESULT_QUALITY_AFTER = 1002
    integer(c_int32_t), parameter :: AMST_RESULT_SECONDS = 1003
    integer(c_int32_t), parameter :: AMST_RESULT_SIZE_ERROR_BEFORE = 1004
    integer(c_int32_t), parameter :: AMST_RESULT_SIZE_ERROR_AFTER = 1005
    integer(c_int32_t), parameter :: AMST_RESULT_LEAST_AREA_BEFORE = 1006
    integer(c_int32_t), parameter :: AMST_RESULT_LEAST_AREA_AFTER = 1007
    integer(c_int32_t), parameter :: AMST_RESULT_TIME_STEP = 1008
    integer(c_int32_t), parameter :: AMST_RESULT_SHORTEST_EDGE_BEFORE = 1009
    integer(c_int32_t), parameter :: AMST_RESULT_SHORTEST_EDGE_AFTER = 1010
    integer(c_int32_t), parameter :: AMST_RESULT_ASPECT_RATIO_BEFORE = 1011
    integer(c_int32_t), parameter :: AMST_RESULT_ASPECT_RATIO_AFTER = 1012
    integer(c_int32_t), parameter :: AMST_RESULT_AREA_GAINED = 1013
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

        !> Writes n points of the boundary to projected. 0: done; else the call under way fails.
        integer(c_int32_t) function amst_projection_fn(user, n, marker, points, projected) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: user
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(in) :: marker(*)
            real(c_double), intent(in) :: points(*)
            real(c_double), intent(inout) :: projected(*)
        end function amst_projection_fn
    end interface
end module amst_c_types
