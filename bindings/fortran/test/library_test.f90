program library_test
    use, intrinsic :: iso_c_binding, only: c_sizeof
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none

    call nothing_has_failed_yet()
    call version_and_features()
    call statuses_have_names()
    call errors_have_words_and_a_place()
    call errmsg_works_as_in_allocate()
    call finish()

contains

    subroutine nothing_has_failed_yet()
        integer(int32) :: entity, id, patch

        call claim(alphamst_last_error() == '', 'no error at first')
        call alphamst_last_error_where(entity, id, patch)
        call claim(entity == AMST_ENTITY_NONE .and. id == 0 .and. patch == 0, 'no place at first')
    end subroutine nothing_has_failed_yet

    subroutine version_and_features()
        character(len=16) :: text

        call claim(alphamst_version() == AMST_VERSION_MAJOR*10000 + AMST_VERSION_MINOR*100 + AMST_VERSION_PATCH, &
            'version')
        write (text, '(i0, ".", i0, ".", i0)') AMST_VERSION_MAJOR, AMST_VERSION_MINOR, AMST_VERSION_PATCH
        call claim(alphamst_version_string() == trim(text), 'version as text')
        call claim(alphamst_has('threads'), 'threads')
        call claim(alphamst_has('threads  '), 'threads, with trailing blanks')
        call claim(.not. alphamst_has('teleportation'), 'no such feature')
        call claim(.not. alphamst_has(''), 'no feature')
        call claim(c_sizeof(amst_summary(0, 0, 0, 0, 0, 0)) == 48, 'size of a summary')
    end subroutine version_and_features

    subroutine statuses_have_names()
        call claim(alphamst_status_name(AMST_OK) == 'AMST_OK', 'name of 0')
        call claim(alphamst_status_name(AMST_PARTIAL) == 'AMST_PARTIAL', 'name of 1')
        call claim(alphamst_status_name(AMST_ERR_STALE) == 'AMST_ERR_STALE', 'name of -9')
        call claim(alphamst_status_name(AMST_ERR_INTERNAL) == 'AMST_ERR_INTERNAL', 'name of -99')
    end subroutine statuses_have_names

    subroutine errors_have_words_and_a_place()
        type(amst_context) :: context
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        integer(int32) :: stat, entity, id, patch, edges(1)
        character(len=200) :: errmsg

        call context%create()
        call new_grid(mesh, context, 3, 3)
        call mesh%get_found_edges(reshape([1, 17], [2, 1]), edges, stat, errmsg)
        call claim(index(errmsg, 'vertex 17 ') > 0, 'the sentence numbers vertices from 1')
        call claim(alphamst_last_error() == errmsg, 'last_error has the same sentence')
        call refused(stat, AMST_ERR_RANGE, errmsg, 'vertex 17 of 16')
        call alphamst_last_error_where(entity, id, patch)
        call claim(entity == AMST_VERTEX .and. id == 17 .and. patch == 0, 'place of a vertex')

        call patches%create(mesh)
        call patches%add_faces([4, 5, 6])
        call mesh%set_flags(AMST_FACE, [9], AMST_FLAG_FIXED, AMST_FLAG_FIXED)
        call patches%add_faces([9], stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_PATCH, errmsg, 'a patch of a fixed face')
        call patches%set_corners(1, [1, 2, 99], stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'corner 99')
        call alphamst_last_error_where(id=id)
        call claim(id == 99, 'place of a corner')
        call alphamst_last_error_where(patch=patch)
        call alphamst_last_error_where()
    end subroutine errors_have_words_and_a_place

    subroutine errmsg_works_as_in_allocate()
        type(amst_context) :: context
        integer(int32) :: stat
        character(len=:), allocatable :: deferred
        character(len=200) :: whole
        character(len=8) :: short

        call context%create()
        whole = 'untouched'
        call context%set_threads(2, stat, whole)
        call claim(stat == AMST_OK .and. whole == 'untouched', 'success leaves errmsg')
        call context%set_threads(-3, stat, whole)
        call claim(stat == AMST_ERR_RANGE .and. index(whole, '-3') > 0, 'failure sets errmsg')
        short = 'x'
        call context%set_threads(-3, stat, short)
        call claim(short == whole(1:8), 'a short errmsg has the beginning')
        deferred = repeat('x', 200)
        call context%set_threads(-3, stat, deferred)
        call claim(len(deferred) == 200 .and. deferred == whole, 'errmsg of deferred length keeps it')
        call pass_on(context, stat, whole)
        call claim(index(whole, '-4') > 0, 'optional arguments pass through')
        call pass_on(context, stat)
        call claim(stat == AMST_ERR_RANGE, 'an absent errmsg passes through')
    end subroutine errmsg_works_as_in_allocate

    subroutine pass_on(context, stat, errmsg)
        type(amst_context), intent(inout) :: context
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call context%set_threads(-4, stat, errmsg)
    end subroutine pass_on

end program library_test
