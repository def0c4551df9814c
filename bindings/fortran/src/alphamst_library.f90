!> The library in use, and its errors.
!>
!> Every procedure that can fail has the optional arguments stat and errmsg of the allocate
!> statement: stat becomes 0 (AMST_OK), positive for success with a remark (AMST_PARTIAL) or
!> negative, one of AMST_ERR_*; errmsg gets the library's sentence on failure and stays as it is
!> otherwise. A failure without stat is an error stop with that sentence. What the binding refuses by
!> itself, arrays of the wrong first extent, is not in alphamst_last_error.
module alphamst_library
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_null_char, c_ptr, c_size_t
    use, intrinsic :: iso_fortran_env, only: int32
    use amst_c, only: AMST_ENTITY_NONE, amst_has, amst_last_error, amst_last_error_where, amst_status_name, &
        amst_version, amst_version_string
    implicit none
    private

    public :: alphamst_version, alphamst_version_string, alphamst_has
    public :: alphamst_status_name, alphamst_last_error, alphamst_last_error_where
    public :: settle, to_c, to_fortran

    interface
        function strlen(text) bind(c)
            import :: c_ptr, c_size_t
            implicit none
            type(c_ptr), value :: text
            integer(c_size_t) :: strlen
        end function strlen
    end interface

contains

    !> major * 10000 + minor * 100 + patch of the library in use.
    function alphamst_version() result(version)
        integer(int32) :: version

        version = amst_version()
    end function alphamst_version

    !> The version of the library in use as text, "0.1.0".
    function alphamst_version_string() result(text)
        character(len=:), allocatable :: text

        text = to_fortran(amst_version_string())
    end function alphamst_version_string

    !> Whether the library has the named feature, "threads".
    function alphamst_has(feature)
        character(len=*), intent(in) :: feature
        logical :: alphamst_has

        alphamst_has = amst_has(to_c(feature)) /= 0
    end function alphamst_has

    !> Name of a status, "AMST_ERR_STALE".
    function alphamst_status_name(status) result(name)
        integer(int32), intent(in) :: status
        character(len=:), allocatable :: name

        name = to_fortran(amst_status_name(status))
    end function alphamst_status_name

    !> Sentence about the last failure on this thread, "" if there was none.
    function alphamst_last_error() result(text)
        character(len=:), allocatable :: text

        text = to_fortran(amst_last_error())
    end function alphamst_last_error

    !> Where the last failure on this thread happened: entity is AMST_VERTEX, AMST_EDGE, AMST_FACE or
    !> AMST_ENTITY_NONE, id and patch are numbers from 1, or 0 if it is not about one.
    subroutine alphamst_last_error_where(entity, id, patch)
        integer(int32), intent(out), optional :: entity, id, patch
        integer(int32) :: about, of_entity, of_patch, status

        status = amst_last_error_where(about, of_entity, of_patch)
        if (status < 0) about = AMST_ENTITY_NONE
        ! A failure without a context has the "none" of C, -1.
        if (about == AMST_ENTITY_NONE) of_entity = 0
        if (of_patch == -1) of_patch = 0
        if (present(entity)) entity = about
        if (present(id)) id = of_entity
        if (present(patch)) patch = of_patch
    end subroutine alphamst_last_error_where

    !> Deliver a status as every procedure of the binding does. sentence stands for the library's
    !> where the binding itself has refused something.
    subroutine settle(status, stat, errmsg, sentence)
        integer(int32), intent(in) :: status
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        character(len=*), intent(in), optional :: sentence
        character(len=:), allocatable :: text

        if (present(stat)) stat = status
        if (status >= 0) return
        if (present(sentence)) then
            text = sentence
        else
            text = alphamst_last_error()
        end if
        if (present(errmsg)) errmsg = text
        if (.not. present(stat)) error stop text
    end subroutine settle

    !> text without trailing blanks, as C wants it.
    pure function to_c(text) result(string)
        character(len=*), intent(in) :: text
        character(kind=c_char, len=len_trim(text) + 1) :: string

        string = trim(text)//c_null_char
    end function to_c

    !> A copy of a C string, "" for NULL.
    function to_fortran(string) result(text)
        type(c_ptr), intent(in) :: string
        character(len=:), allocatable :: text
        character(kind=c_char), pointer :: characters(:)
        integer :: i

        if (.not. c_associated(string)) then
            text = ''
            return
        end if
        call c_f_pointer(string, characters, [strlen(string)])
        allocate (character(len=size(characters)) :: text)
        do i = 1, size(characters)
            text(i:i) = characters(i)
        end do
    end function to_fortran

end module alphamst_library
