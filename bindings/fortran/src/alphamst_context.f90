!> Contexts: threads, log, progress and cancel. Ids count from 1 in every context of this binding,
!> and 0 is "none".
module alphamst_context
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_funloc, c_funptr, &
        c_int32_t, c_loc, c_null_funptr, c_null_ptr, c_ptr
    use, intrinsic :: iso_fortran_env, only: int32, real64
    use amst_c, only: AMST_LOG_OFF, amst_context_create, amst_context_destroy, &
        amst_context_get_progress, amst_context_set_cancel, amst_context_set_log, &
        amst_context_set_progress, amst_context_set_threads
    use alphamst_handle, only: amst_handle, handle_to_copy
    use alphamst_library, only: settle, to_fortran
    implicit none
    private

    public :: amst_progress_listener, amst_log_listener

    abstract interface
        !> Called on the thread of the operation with fraction 0..1 and an English word for the
        !> stage; .true. cancels the operation, which then changes nothing and has the status
        !> AMST_ERR_CANCELLED. user is what set_progress was given, not associated if nothing was.
        !> Asking and destroying is allowed here, changing something of the context is AMST_ERR_STATE.
        function amst_progress_listener(fraction, stage, user) result(cancel)
            import :: real64
            implicit none
            real(real64), intent(in) :: fraction
            character(len=*), intent(in) :: stage
            class(*), pointer, intent(in) :: user
            logical :: cancel
        end function amst_progress_listener

        !> Called on the thread of the call with AMST_LOG_ERROR to AMST_LOG_DEBUG.
        subroutine amst_log_listener(level, message, user)
            import :: int32
            implicit none
            integer(int32), intent(in) :: level
            character(len=*), intent(in) :: message
            class(*), pointer, intent(in) :: user
        end subroutine amst_log_listener
    end interface

    ! Lies still in memory, whatever happens to the context variable: C has its address.
    type :: listeners
        procedure(amst_progress_listener), pointer, nopass :: progress => null()
        procedure(amst_log_listener), pointer, nopass :: log => null()
        class(*), pointer :: progress_user => null(), log_user => null()
    end type listeners

    !> A context serves one thread at a time; different contexts share nothing. Contexts cannot be
    !> assigned: that is an error stop.
    type, extends(amst_handle), public :: amst_context
        private
        type(listeners), pointer :: listeners => null()
    contains
        !> create([stat, errmsg]): 1 thread, silent.
        procedure :: create
        !> set_threads(n [, stat, errmsg]): 0 all cores, n at most n. Errors: RANGE (n < 0).
        procedure :: set_threads
        !> set_progress([listener, user, stat, errmsg]): without listener none is called any more.
        !> listener and user must exist until they are replaced or the context is destroyed.
        procedure :: set_progress
        !> set_log(level [, listener, user, stat, errmsg]): messages up to level, AMST_LOG_OFF to
        !> AMST_LOG_DEBUG: at AMST_LOG_INFO one a stage, at AMST_LOG_DEBUG one a patch or window; otherwise
        !> as set_progress. Errors: ARGUMENT (level).
        procedure :: set_log
        !> set_cancel(flag [, stat, errmsg]): a raised flag stops operations with AMST_ERR_CANCELLED
        !> until it is lowered. From any thread, also while an operation runs.
        procedure :: set_cancel
        !> progress([stat, errmsg]): 0..1 of the operation under way or of the last one. From any thread.
        procedure :: progress
        procedure :: destroy
        procedure, private :: refuse_copy
        generic :: assignment(=) => refuse_copy
        final :: finalize
    end type amst_context

contains

    subroutine create(self, stat, errmsg)
        class(amst_context), intent(inout) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(int32) :: status

        handle = c_null_ptr
        status = amst_context_create(1_c_int32_t, handle)
        if (status >= 0) then
            call self%adopt(handle)
            allocate (self%listeners)
        end if
        call settle(status, stat, errmsg)
    end subroutine create

    subroutine set_threads(self, n, stat, errmsg)
        class(amst_context), intent(inout) :: self
        integer(int32), intent(in) :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_context_set_threads(self%c_handle(), n), stat, errmsg)
    end subroutine set_threads

    subroutine set_progress(self, listener, user, stat, errmsg)
        class(amst_context), intent(inout) :: self
        procedure(amst_progress_listener), optional :: listener
        class(*), intent(inout), target, optional :: user
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_funptr) :: thunk
        integer(int32) :: status

        thunk = c_null_funptr
        if (present(listener)) thunk = c_funloc(call_progress)
        status = amst_context_set_progress(self%c_handle(), thunk, address_of(self%listeners))
        if (status >= 0) then
            self%listeners%progress => null()
            self%listeners%progress_user => null()
            if (present(listener)) self%listeners%progress => listener
            if (present(user)) self%listeners%progress_user => user
        end if
        call settle(status, stat, errmsg)
    end subroutine set_progress

    subroutine set_log(self, level, listener, user, stat, errmsg)
        class(amst_context), intent(inout) :: self
        integer(int32), intent(in) :: level
        procedure(amst_log_listener), optional :: listener
        class(*), intent(inout), target, optional :: user
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_funptr) :: thunk
        integer(int32) :: status

        thunk = c_null_funptr
        if (present(listener)) thunk = c_funloc(call_log)
        status = amst_context_set_log(self%c_handle(), level, thunk, address_of(self%listeners))
        if (status >= 0) then
            self%listeners%log => null()
            self%listeners%log_user => null()
            if (present(listener)) self%listeners%log => listener
            if (present(user)) self%listeners%log_user => user
        end if
        call settle(status, stat, errmsg)
    end subroutine set_log

    subroutine set_cancel(self, flag, stat, errmsg)
        class(amst_context), intent(in) :: self
        logical, intent(in) :: flag
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_context_set_cancel(self%c_handle(), merge(1_c_int32_t, 0_c_int32_t, flag)), stat, errmsg)
    end subroutine set_cancel

    function progress(self, stat, errmsg) result(fraction)
        class(amst_context), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        real(real64) :: fraction

        fraction = 0
        call settle(amst_context_get_progress(self%c_handle(), fraction), stat, errmsg)
    end function progress

    ! Meshes keep the context of the C side alive, and an operation under way would still call: the
    ! listeners go only once the library has let go of them. It does not in a callback; then what is
    ! left, some hundred bytes, says nothing any more and stays.
    subroutine destroy(self)
        class(amst_context), intent(inout) :: self
        type(c_ptr) :: handle
        integer(int32) :: progress_status, log_status

        handle = self%release()
        if (c_associated(handle)) then
            progress_status = amst_context_set_progress(handle, c_null_funptr, c_null_ptr)
            log_status = amst_context_set_log(handle, AMST_LOG_OFF, c_null_funptr, c_null_ptr)
            if (progress_status >= 0 .and. log_status >= 0) then
                deallocate (self%listeners)
            else
                self%listeners = listeners()
            end if
            call amst_context_destroy(handle)
        end if
        self%listeners => null()
    end subroutine destroy

    impure elemental subroutine finalize(self)
        type(amst_context), intent(inout) :: self

        call self%destroy()
    end subroutine finalize

    impure elemental subroutine refuse_copy(self, other)
        class(amst_context), intent(inout) :: self
        class(amst_context), intent(in) :: other

        if (c_associated(handle_to_copy(other))) error stop 'an amst_context cannot be assigned: create another one'
        call self%destroy()
    end subroutine refuse_copy

    function address_of(held) result(address)
        type(listeners), pointer, intent(in) :: held
        type(c_ptr) :: address

        address = c_null_ptr
        if (associated(held)) address = c_loc(held)
    end function address_of

    function call_progress(user, fraction, stage) result(cancel) bind(c, name='')
        type(c_ptr), value :: user
        real(c_double), value :: fraction
        type(c_ptr), value :: stage
        integer(c_int32_t) :: cancel
        type(listeners), pointer :: held

        cancel = 0
        call c_f_pointer(user, held)
        if (.not. associated(held%progress)) return
        if (held%progress(fraction, to_fortran(stage), held%progress_user)) cancel = 1
    end function call_progress

    subroutine call_log(user, level, message) bind(c, name='')
        type(c_ptr), value :: user
        integer(c_int32_t), value :: level
        type(c_ptr), value :: message
        type(listeners), pointer :: held

        call c_f_pointer(user, held)
        if (associated(held%log)) call held%log(level, to_fortran(message), held%log_user)
    end subroutine call_log

end module alphamst_context
