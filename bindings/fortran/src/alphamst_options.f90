!> Options: numeric settings by key, all with defaults. An optional argument of this type that is
!> left out, or was never created, means all defaults.
module alphamst_options
    use, intrinsic :: iso_c_binding, only: c_associated, c_null_ptr, c_ptr
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use amst_c, only: AMST_OPT_ALIGN, AMST_OPT_BUFFER_LAYERS, AMST_OPT_ERROR_ORDER, AMST_OPT_GRADATION, &
        AMST_OPT_MAX_EDGE, AMST_OPT_MIN_EDGE, AMST_OPT_CANDIDATES, AMST_OPT_CHART, AMST_OPT_EDIT_BOUNDARY, &
        AMST_OPT_EFFORT, AMST_OPT_KEEP_BOUNDARY, AMST_OPT_SHARP_ANGLE, AMST_OPT_SIZE_BAND, &
        AMST_OPT_LEAST_SIZE, AMST_OPT_MIN_CONVEXITY, AMST_OPT_MIN_QUALITY, &
        AMST_OPT_NODE_LIMIT, AMST_OPT_PATCH_FACES, AMST_OPT_QUADRANGULATE, AMST_OPT_REPAIR_PATCHES, &
        AMST_OPT_SEED, AMST_OPT_SIZE_WEIGHT, AMST_OPT_SMOOTH_STEPS, AMST_OPT_STARTS, AMST_OPT_STRATEGY, &
        AMST_OPT_TOLERANCE, AMST_OPT_TRANSITION, amst_options_create, amst_options_destroy, &
        amst_options_get_edges, amst_options_get_int, amst_options_get_real, amst_options_set_edges, &
        amst_options_set_int, amst_options_set_real
    use alphamst_arrays, only: check_rows, fetch_rows
    use alphamst_handle, only: amst_handle, handle_to_copy
    use alphamst_library, only: settle
    implicit none
    private

    public :: handle_of_options

    integer(int32), parameter :: int_keys(*) = [AMST_OPT_SEED, AMST_OPT_SMOOTH_STEPS, &
        AMST_OPT_REPAIR_PATCHES, AMST_OPT_CANDIDATES, AMST_OPT_NODE_LIMIT, &
        AMST_OPT_QUADRANGULATE, AMST_OPT_EDIT_BOUNDARY, AMST_OPT_STRATEGY, AMST_OPT_ALIGN, &
        AMST_OPT_CHART, AMST_OPT_KEEP_BOUNDARY, AMST_OPT_STARTS, &
        AMST_OPT_BUFFER_LAYERS]
    integer(int32), parameter :: real_keys(*) = [AMST_OPT_MIN_QUALITY, AMST_OPT_MIN_CONVEXITY, &
        AMST_OPT_PATCH_FACES, AMST_OPT_TOLERANCE, AMST_OPT_EFFORT, AMST_OPT_SIZE_WEIGHT, &
        AMST_OPT_TRANSITION, AMST_OPT_LEAST_SIZE, AMST_OPT_SHARP_ANGLE, AMST_OPT_SIZE_BAND, &
        AMST_OPT_MIN_EDGE, AMST_OPT_MAX_EDGE, AMST_OPT_GRADATION, AMST_OPT_ERROR_ORDER]

    !> Assignment makes options of their own with the same values.
    type, extends(amst_handle), public :: amst_options
    contains
        !> create([stat, errmsg])
        procedure :: create
        !> set(key, value [, stat, errmsg]): an integer value for the keys AMST_OPT_* below 1000, a
        !> real(real64) one for the others. Errors: NOT_FOUND (key), RANGE (value), NOT_FINITE.
        generic :: set => set_int32, set_int64, set_real
        !> get_int(key [, stat, errmsg]), a value of kind int64. Errors: NOT_FOUND.
        procedure :: get_int
        !> get_real(key [, stat, errmsg]). Errors: NOT_FOUND.
        procedure :: get_real
        !> set_edges(vertices(2, n) [, stat, errmsg]): edges of a new mesh that no pair of triangles
        !> crosses, instead of those set before. Errors: ARGUMENT (extents). A mesh is not made, with
        !> NOT_FOUND, if one of them is no side of its faces.
        procedure :: set_edges
        !> edges(2, n), as they were set
        procedure :: edges
        procedure :: destroy
        procedure, private :: set_int32, set_int64, set_real, assign
        generic :: assignment(=) => assign
        final :: finalize
    end type amst_options

contains

    subroutine create(self, stat, errmsg)
        class(amst_options), intent(inout) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(int32) :: status

        handle = c_null_ptr
        status = amst_options_create(handle)
        if (status >= 0) call self%adopt(handle)
        call settle(status, stat, errmsg)
    end subroutine create

    subroutine set_int32(self, key, value, stat, errmsg)
        class(amst_options), intent(inout) :: self
        integer(int32), intent(in) :: key, value
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call self%set_int64(key, int(value, int64), stat, errmsg)
    end subroutine set_int32

    subroutine set_int64(self, key, value, stat, errmsg)
        class(amst_options), intent(inout) :: self
        integer(int32), intent(in) :: key
        integer(int64), intent(in) :: value
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_options_set_int(self%c_handle(), key, value), stat, errmsg)
    end subroutine set_int64

    subroutine set_real(self, key, value, stat, errmsg)
        class(amst_options), intent(inout) :: self
        integer(int32), intent(in) :: key
        real(real64), intent(in) :: value
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_options_set_real(self%c_handle(), key, value), stat, errmsg)
    end subroutine set_real

    function get_int(self, key, stat, errmsg) result(value)
        class(amst_options), intent(in) :: self
        integer(int32), intent(in) :: key
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: value

        value = 0
        call settle(amst_options_get_int(self%c_handle(), key, value), stat, errmsg)
    end function get_int

    function get_real(self, key, stat, errmsg) result(value)
        class(amst_options), intent(in) :: self
        integer(int32), intent(in) :: key
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        real(real64) :: value

        value = 0
        call settle(amst_options_get_real(self%c_handle(), key, value), stat, errmsg)
    end function get_real

    subroutine set_edges(self, vertices, stat, errmsg)
        class(amst_options), intent(inout) :: self
        integer(int32), intent(in), contiguous :: vertices(:, :)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        if (check_rows(size(vertices, 1, int32), 2_int32, stat, errmsg)) call settle( &
            amst_options_set_edges(self%c_handle(), vertices, size(vertices, 2, int64)), stat, errmsg)
    end subroutine set_edges

    function edges(self, stat, errmsg) result(values)
        class(amst_options), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:, :)

        call fetch_rows(amst_options_get_edges, self%c_handle(), 2_int32, values, stat, errmsg)
    end function edges

    subroutine destroy(self)
        class(amst_options), intent(inout) :: self

        call amst_options_destroy(self%release())
    end subroutine destroy

    impure elemental subroutine finalize(self)
        type(amst_options), intent(inout) :: self

        call self%destroy()
    end subroutine finalize

    impure elemental subroutine assign(self, other)
        class(amst_options), intent(inout) :: self
        class(amst_options), intent(in) :: other
        type(c_ptr) :: from, to
        integer(int64) :: int_value
        real(real64) :: real_value
        integer(int32), allocatable :: edges(:, :)
        integer :: k

        from = handle_to_copy(other)
        to = c_null_ptr
        if (c_associated(from)) then
            call settle(amst_options_create(to))
            do k = 1, size(int_keys)
                call settle(amst_options_get_int(from, int_keys(k), int_value))
                call settle(amst_options_set_int(to, int_keys(k), int_value))
            end do
            do k = 1, size(real_keys)
                call settle(amst_options_get_real(from, real_keys(k), real_value))
                call settle(amst_options_set_real(to, real_keys(k), real_value))
            end do
            call fetch_rows(amst_options_get_edges, from, 2_int32, edges)
            call settle(amst_options_set_edges(to, edges, size(edges, 2, int64)))
        end if
        call self%adopt(to)
    end subroutine assign

    !> The handle of options that may be left out.
    function handle_of_options(options) result(handle)
        type(amst_options), intent(in), optional :: options
        type(c_ptr) :: handle

        handle = c_null_ptr
        if (present(options)) handle = options%c_handle()
    end function handle_of_options

end module alphamst_options
