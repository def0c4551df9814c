!> Records what a listener is told, and tells it what to do.
module witnesses
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none

    type :: witness
        integer :: calls = 0, stop_at = -1, messages = 0
        real(real64) :: last = -1
        character(len=80) :: stage = '', message = ''
        type(amst_context), pointer :: context => null()
        type(amst_mesh), pointer :: mesh => null()
        type(amst_patches), pointer :: patches => null()
    end type witness

contains

    function watch(fraction, stage, user) result(cancel)
        real(real64), intent(in) :: fraction
        character(len=*), intent(in) :: stage
        class(*), pointer, intent(in) :: user
        logical :: cancel

        cancel = .false.
        select type (user)
        type is (witness)
            call claim(fraction >= user%last .and. fraction <= 1, 'fractions rise')
            if (associated(user%context)) &
                call claim(abs(user%context%progress() - fraction) <= 0, 'progress is polled')
            user%last = fraction
            user%stage = stage
            cancel = user%calls == user%stop_at
            user%calls = user%calls + 1
        class default
            call claim(.false., 'the user object comes back')
        end select
    end function watch

    function meddle(fraction, stage, user) result(cancel)
        real(real64), intent(in) :: fraction
        character(len=*), intent(in) :: stage
        class(*), pointer, intent(in) :: user
        logical :: cancel
        integer(int32) :: stat
        character(len=200) :: errmsg

        cancel = fraction > 2 .or. stage == ''
        select type (user)
        type is (witness)
            user%calls = user%calls + 1
            call alphamst_clean(user%mesh, stat=stat, errmsg=errmsg)
            call refused(stat, AMST_ERR_STATE, errmsg, 'an operation in a listener')
            call user%context%set_progress(stat=stat, errmsg=errmsg)
            call refused(stat, AMST_ERR_STATE, errmsg, 'another listener in a listener')
            call user%mesh%check(stat)
            call claim(stat == AMST_OK, 'asking in a listener')
        end select
    end function meddle

    function destroy_all(fraction, stage, user) result(cancel)
        real(real64), intent(in) :: fraction
        character(len=*), intent(in) :: stage
        class(*), pointer, intent(in) :: user
        logical :: cancel

        cancel = fraction > 2 .or. stage == ''
        select type (user)
        type is (witness)
            user%calls = user%calls + 1
            call user%patches%destroy()
            call user%mesh%destroy()
        end select
    end function destroy_all

    function alone(fraction, stage, user) result(cancel)
        real(real64), intent(in) :: fraction
        character(len=*), intent(in) :: stage
        class(*), pointer, intent(in) :: user
        logical :: cancel

        cancel = .not. associated(user) .and. fraction >= 0 .and. len(stage) > 0
    end function alone

    subroutine listen(level, message, user)
        integer(int32), intent(in) :: level
        character(len=*), intent(in) :: message
        class(*), pointer, intent(in) :: user

        call claim(level >= AMST_LOG_ERROR .and. level <= AMST_LOG_INFO, 'level of a message')
        select type (user)
        type is (witness)
            user%messages = user%messages + 1
            user%message = message
        end select
    end subroutine listen

end module witnesses

program context_test
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    use witnesses
    implicit none

    call threads_and_levels()
    call progress_and_log()
    call cancelled_at_any_call()
    call the_flag_stops()
    call listeners_may_ask_but_not_change()
    call handles_may_end_in_a_listener()
    call listeners_end_with_the_context()
    call finish()

contains

    subroutine set_up(context, mesh, patches)
        type(amst_context), intent(inout) :: context
        type(amst_mesh), intent(inout) :: mesh
        type(amst_patches), intent(inout) :: patches

        call context%create()
        call new_grid(mesh, context, 10, 10)
        call patches%create(mesh)
        call patches%add_faces(square(10, 1, 5))
        call patches%add_faces(square(10, 5, 9))
    end subroutine set_up

    subroutine threads_and_levels()
        type(amst_context) :: context
        integer(int32) :: stat
        real(real64) :: fraction
        character(len=200) :: errmsg

        call context%set_threads(1, stat, errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'a context never created')
        call context%set_progress(watch, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'a listener without a context')
        call context%create(stat, errmsg)
        call claim(stat == AMST_OK .and. context%exists(), 'create')
        call context%set_threads(0)
        call context%set_threads(-1, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, '-1 threads')
        call context%set_log(AMST_LOG_DEBUG + 1, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'level 4')
        call context%destroy()
        call context%destroy()
        fraction = context%progress(stat, errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'a context destroyed')
        call claim(abs(fraction) <= 0, 'a failed function is 0')
    end subroutine threads_and_levels

    subroutine progress_and_log()
        type(amst_context), target :: context
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        type(witness), target :: seen
        integer :: calls, messages

        call set_up(context, mesh, patches)
        call context%set_threads(2)
        seen%context => context
        call context%set_progress(watch, seen)
        call context%set_log(AMST_LOG_INFO, listen, seen)
        call alphamst_adapt(mesh, patches, 2.0_real64)
        call claim(seen%calls >= 2 .and. abs(seen%last - 1) <= 0, 'progress ends at 1')
        call claim(abs(context%progress() - 1) <= 0, 'progress after the operation')
        call claim(seen%messages > 0 .and. seen%message /= '' .and. seen%stage /= '', 'words of stage and log')
        calls = seen%calls
        messages = seen%messages
        call context%set_progress()
        call context%set_log(AMST_LOG_OFF)
        call alphamst_adapt(mesh, patches, 1.0_real64)
        call claim(seen%calls == calls .and. seen%messages == messages, 'silent again')
        call context%set_progress(alone)
        call alphamst_smooth(mesh, stat=calls)
        call claim(calls == AMST_ERR_CANCELLED, 'a listener without user')
    end subroutine progress_and_log

    subroutine cancelled_at_any_call()
        type(amst_context) :: context
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        type(amst_report) :: report
        type(witness), target :: seen
        integer(int64) :: before
        integer(int32) :: stat
        integer :: stops
        character(len=200) :: errmsg

        call set_up(context, mesh, patches)
        before = mesh%checksum()
        call context%set_progress(watch, seen)
        stops = 0
        do
            seen%calls = 0
            seen%last = -1
            seen%stop_at = stops
            call alphamst_adapt(mesh, patches, 2.0_real64, report=report, stat=stat, errmsg=errmsg)
            if (stat >= 0) exit
            call refused(stat, AMST_ERR_CANCELLED, errmsg, 'a cancelled operation')
            call claim(mesh%checksum() == before, 'the mesh is as before')
            call claim(mesh%revision() == 0, 'the revision is as before')
            call claim(size(patches%faces(1)) == 16, 'the patches are as before')
            call claim(.not. report%exists(), 'no report of a cancelled operation')
            stops = stops + 1
            if (stops > 10000) exit
        end do
        call claim(stops >= 2 .and. stops == seen%calls, 'cancelled at every call')
        call claim(report%exists(), 'a report in the end')
        call claim(mesh%checksum() /= before, 'done in the end')
    end subroutine cancelled_at_any_call

    subroutine the_flag_stops()
        type(amst_context) :: context
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        integer(int32) :: stat
        integer(int64) :: before
        character(len=200) :: errmsg

        call set_up(context, mesh, patches)
        before = mesh%checksum()
        call context%set_cancel(.true.)
        call alphamst_adapt(mesh, patches, 2.0_real64, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_CANCELLED, errmsg, 'adapt with the flag raised')
        call alphamst_reduce_singularities(mesh, patches, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_CANCELLED, errmsg, 'reduce with the flag raised')
        call claim(mesh%checksum() == before, 'the mesh is as before')
        call context%set_cancel(.false., stat, errmsg)
        call alphamst_smooth(mesh, stat=stat)
        call claim(stat == AMST_OK, 'the flag is lowered')
    end subroutine the_flag_stops

    subroutine listeners_may_ask_but_not_change()
        type(amst_context), target :: context
        type(amst_mesh), target :: mesh
        type(amst_patches) :: patches
        type(witness), target :: seen

        call set_up(context, mesh, patches)
        seen%context => context
        seen%mesh => mesh
        call context%set_progress(meddle, seen)
        call alphamst_adapt(mesh, patches, 2.0_real64)
        call claim(seen%calls > 0, 'the listener was called')
    end subroutine listeners_may_ask_but_not_change

    subroutine handles_may_end_in_a_listener()
        type(amst_context) :: context
        type(amst_mesh), target :: mesh
        type(amst_patches), target :: patches
        type(amst_report) :: report
        type(witness), target :: seen

        call set_up(context, mesh, patches)
        seen%mesh => mesh
        seen%patches => patches
        call context%set_progress(destroy_all, seen)
        call alphamst_adapt(mesh, patches, 2.0_real64, report=report)
        call claim(seen%calls >= 1, 'the listener was called')
        call claim(report%get_int(AMST_RESULT_FACES_BEFORE, 1) == 16, 'the report is whole')
        call claim(.not. mesh%exists() .and. .not. patches%exists(), 'mesh and patches are gone')
    end subroutine handles_may_end_in_a_listener

    subroutine listeners_end_with_the_context()
        type(amst_context) :: context
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        type(witness), target :: seen

        call set_up(context, mesh, patches)
        call context%set_progress(watch, seen)
        call context%set_log(AMST_LOG_DEBUG, listen, seen)
        call context%destroy()
        call alphamst_adapt(mesh, patches, 2.0_real64)
        call claim(seen%calls == 0 .and. seen%messages == 0, 'nobody listens any more')
    end subroutine listeners_end_with_the_context

end program context_test
