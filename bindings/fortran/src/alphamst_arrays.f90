!> Arrays out of the library: ask for the size, allocate, fill; or fill an array of the caller.
!>
!> Each getter of the C interface has one of three signatures, which name the interfaces here:
!> ids (handle, out, capacity, needed), ids_of and reals_of with a key or patch after the handle.
module alphamst_arrays
    use, intrinsic :: iso_c_binding, only: c_ptr
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use amst_c, only: AMST_ERR_ARGUMENT, ids => amst_mesh_get_faces, ids_of => amst_mesh_get_flags, &
        reals_of => amst_mesh_get_quality
    use alphamst_library, only: settle
    implicit none
    private

    public :: fetch_rows, fetch_row, fetch_row_of, fetch_reals_of
    public :: fill_rows, fill_row, fill_row_of, fill_reals_of
    public :: check_rows, deliver

contains

    !> The answer of a getter as values(rows, n).
    subroutine fetch_rows(getter, handle, rows, values, stat, errmsg)
        procedure(ids) :: getter
        type(c_ptr), intent(in) :: handle
        integer(int32), intent(in) :: rows
        integer(int32), allocatable, intent(out) :: values(:, :)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: needed
        integer(int32) :: status

        needed = 0
        status = getter(handle, capacity=0_int64, needed=needed)
        allocate (values(rows, needed/rows))
        if (status >= 0) status = getter(handle, values, needed, needed)
        call settle(status, stat, errmsg)
    end subroutine fetch_rows

    subroutine fetch_row(getter, handle, values, stat, errmsg)
        procedure(ids) :: getter
        type(c_ptr), intent(in) :: handle
        integer(int32), allocatable, intent(out) :: values(:)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: needed
        integer(int32) :: status

        needed = 0
        status = getter(handle, capacity=0_int64, needed=needed)
        allocate (values(needed))
        if (status >= 0) status = getter(handle, values, needed, needed)
        call settle(status, stat, errmsg)
    end subroutine fetch_row

    subroutine fetch_row_of(getter, handle, key, values, stat, errmsg)
        procedure(ids_of) :: getter
        type(c_ptr), intent(in) :: handle
        integer(int32), intent(in) :: key
        integer(int32), allocatable, intent(out) :: values(:)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: needed
        integer(int32) :: status

        needed = 0
        status = getter(handle, key, capacity=0_int64, needed=needed)
        allocate (values(needed))
        if (status >= 0) status = getter(handle, key, values, needed, needed)
        call settle(status, stat, errmsg)
    end subroutine fetch_row_of

    subroutine fetch_reals_of(getter, handle, key, values, stat, errmsg)
        procedure(reals_of) :: getter
        type(c_ptr), intent(in) :: handle
        integer(int32), intent(in) :: key
        real(real64), allocatable, intent(out) :: values(:)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: needed
        integer(int32) :: status

        needed = 0
        status = getter(handle, key, capacity=0_int64, needed=needed)
        allocate (values(needed))
        if (status >= 0) status = getter(handle, key, values, needed, needed)
        call settle(status, stat, errmsg)
    end subroutine fetch_reals_of

    !> The answer into the first n columns of values, whose first extent must be rows.
    subroutine fill_rows(getter, handle, rows, values, n, stat, errmsg)
        procedure(ids) :: getter
        type(c_ptr), intent(in) :: handle
        integer(int32), intent(in) :: rows
        integer(int32), intent(inout), contiguous :: values(:, :)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: needed
        integer(int32) :: status

        needed = 0
        if (check_rows(size(values, 1, int32), rows, stat, errmsg)) then
            status = getter(handle, values, size(values, kind=int64), needed)
            call deliver(status, needed/rows, n, stat, errmsg)
        end if
    end subroutine fill_rows

    subroutine fill_row(getter, handle, values, n, stat, errmsg)
        procedure(ids) :: getter
        type(c_ptr), intent(in) :: handle
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: needed
        integer(int32) :: status

        needed = 0
        status = getter(handle, values, size(values, kind=int64), needed)
        call deliver(status, needed, n, stat, errmsg)
    end subroutine fill_row

    subroutine fill_row_of(getter, handle, key, values, n, stat, errmsg)
        procedure(ids_of) :: getter
        type(c_ptr), intent(in) :: handle
        integer(int32), intent(in) :: key
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: needed
        integer(int32) :: status

        needed = 0
        status = getter(handle, key, values, size(values, kind=int64), needed)
        call deliver(status, needed, n, stat, errmsg)
    end subroutine fill_row_of

    subroutine fill_reals_of(getter, handle, key, values, n, stat, errmsg)
        procedure(reals_of) :: getter
        type(c_ptr), intent(in) :: handle
        integer(int32), intent(in) :: key
        real(real64), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: needed
        integer(int32) :: status

        needed = 0
        status = getter(handle, key, values, size(values, kind=int64), needed)
        call deliver(status, needed, n, stat, errmsg)
    end subroutine fill_reals_of

    !> n is told also where the array was too small: it is what it should have had.
    subroutine deliver(status, count, n, stat, errmsg)
        integer(int32), intent(in) :: status
        integer(int64), intent(in) :: count
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        if (present(n)) n = count
        call settle(status, stat, errmsg)
    end subroutine deliver

    !> Whether an array has the first extent it must have; otherwise the failure is delivered.
    function check_rows(rows, wanted, stat, errmsg) result(fits)
        integer(int32), intent(in) :: rows, wanted
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        logical :: fits
        character(len=64) :: sentence

        fits = rows == wanted
        if (fits) return
        write (sentence, '(a, i0, a, i0)') 'first extent of the array is ', rows, ', not ', wanted
        call settle(AMST_ERR_ARGUMENT, stat, errmsg, trim(sentence))
    end function check_rows

end module alphamst_arrays
