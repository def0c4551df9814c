!> Reports: what an operation did, for each patch and for all together.
module alphamst_report
    use, intrinsic :: iso_c_binding, only: c_associated
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use amst_c, only: AMST_ALL, amst_report_destroy, amst_report_get_int, amst_report_get_origin, &
        amst_report_get_real, amst_report_get_valence
    use alphamst_arrays, only: fetch_row_of, fill_row_of
    use alphamst_handle, only: amst_handle, handle_to_copy
    use alphamst_library, only: settle
    implicit none
    private

    !> Made by an operation; outlives mesh and patches. Reports cannot be assigned: that is an error
    !> stop. An argument patch that is left out means all patches together, AMST_ALL. All procedures
    !> have the optional arguments stat and errmsg. Errors: RANGE (patch), NOT_FOUND (key).
    type, extends(amst_handle), public :: amst_report
    contains
        !> get_int(key [, patch]): an AMST_RESULT_* below 1000, kind int64. AMST_RESULT_UNUSED_OPTION: the
        !> AMST_OPT_* of the first option that was set and had no effect on the call, -1 if none.
        procedure :: get_int
        !> get_real(key [, patch]): an AMST_RESULT_* from 1000
        procedure :: get_real
        !> valence(valence, after [, patch]): number, kind int64, of interior vertices of this valence
        !> before (.false.) or after (.true.) the operation
        procedure :: valence => get_valence
        !> origin(entity): for each vertex, edge or face after the operation the one it was before, 0 if
        !> there is none; edges and faces are the same if their vertices are; get_origin(entity, values [, n]). Errors: ARGUMENT (entity), BUFFER_TOO_SMALL.
        procedure :: origin, get_origin
        procedure :: destroy
        procedure, private :: refuse_copy
        generic :: assignment(=) => refuse_copy
        final :: finalize
    end type amst_report

contains

    function get_int(self, key, patch, stat, errmsg) result(value)
        class(amst_report), intent(in) :: self
        integer(int32), intent(in) :: key
        integer(int32), intent(in), optional :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: value

        value = 0
        call settle(amst_report_get_int(self%c_handle(), one_or_all(patch), key, value), stat, errmsg)
    end function get_int

    function get_real(self, key, patch, stat, errmsg) result(value)
        class(amst_report), intent(in) :: self
        integer(int32), intent(in) :: key
        integer(int32), intent(in), optional :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        real(real64) :: value

        value = 0
        call settle(amst_report_get_real(self%c_handle(), one_or_all(patch), key, value), stat, errmsg)
    end function get_real

    function get_valence(self, valence, after, patch, stat, errmsg) result(count)
        class(amst_report), intent(in) :: self
        integer(int32), intent(in) :: valence
        logical, intent(in) :: after
        integer(int32), intent(in), optional :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: count

        count = 0
        call settle(amst_report_get_valence(self%c_handle(), one_or_all(patch), merge(1_int32, 0_int32, after), &
            valence, count), stat, errmsg)
    end function get_valence

    function origin(self, entity, stat, errmsg) result(values)
        class(amst_report), intent(in) :: self
        integer(int32), intent(in) :: entity
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)

        call fetch_row_of(amst_report_get_origin, self%c_handle(), entity, values, stat, errmsg)
    end function origin

    subroutine get_origin(self, entity, values, n, stat, errmsg)
        class(amst_report), intent(in) :: self
        integer(int32), intent(in) :: entity
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_row_of(amst_report_get_origin, self%c_handle(), entity, values, n, stat, errmsg)
    end subroutine get_origin

    subroutine destroy(self)
        class(amst_report), intent(inout) :: self

        call amst_report_destroy(self%release())
    end subroutine destroy

    impure elemental subroutine finalize(self)
        type(amst_report), intent(inout) :: self

        call self%destroy()
    end subroutine finalize

    impure elemental subroutine refuse_copy(self, other)
        class(amst_report), intent(inout) :: self
        class(amst_report), intent(in) :: other

        if (c_associated(handle_to_copy(other))) error stop 'an amst_report cannot be assigned'
        call self%destroy()
    end subroutine refuse_copy

    function one_or_all(patch) result(which)
        integer(int32), intent(in), optional :: patch
        integer(int32) :: which

        which = AMST_ALL
        if (present(patch)) which = patch
    end function one_or_all

end module alphamst_report
