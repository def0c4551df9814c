!> What the handle types of module alphamst have in common: each variable owns one handle of the C
!> interface and ends it once, by destroy or when the variable ceases to exist.
!>
!> Handles follow assignment where a type says so, and move_alloc. They do not follow copies made bit
!> by bit, which have no handle: allocate with source=, structure constructors, function results, and
!> with gfortran 12 the assignment of a type that has a component with a handle. Give such a type an
!> assignment(=) of its own.
module alphamst_handle
    use, intrinsic :: iso_c_binding, only: c_associated, c_intptr_t, c_loc, c_null_ptr, c_ptr
    implicit none
    private

    public :: handle_to_copy

    type, abstract, public :: amst_handle
        private
        type(c_ptr) :: handle = c_null_ptr
        ! Address of the variable that owns the handle. Copies made bit by bit, as by allocate with
        ! source= or by a structure constructor, lie elsewhere and therefore have and end nothing.
        integer(c_intptr_t) :: home = 0
    contains
        !> The handle for calls of module amst_c, c_null_ptr if there is none. It stays with self.
        procedure :: c_handle
        !> Whether self has a handle: after a create that succeeded and before destroy.
        procedure :: exists
        !> Own this handle, made by a call of module amst_c, and end the one before.
        procedure :: adopt
        !> Give the handle to the caller, who ends it; c_null_ptr if there is none.
        procedure :: release
        !> End the handle; nothing happens if there is none. Handles may end in any order.
        procedure(end_handle), deferred :: destroy
    end type amst_handle

    abstract interface
        subroutine end_handle(self)
            import :: amst_handle
            implicit none
            class(amst_handle), intent(inout) :: self
        end subroutine end_handle
    end interface

contains

    pure function c_handle(self) result(handle)
        class(amst_handle), intent(in) :: self
        type(c_ptr) :: handle

        handle = c_null_ptr
        if (self%home == address_of(self)) handle = self%handle
    end function c_handle

    pure function exists(self)
        class(amst_handle), intent(in) :: self
        logical :: exists

        exists = c_associated(self%c_handle())
    end function exists

    subroutine adopt(self, handle)
        class(amst_handle), intent(inout) :: self
        type(c_ptr), intent(in) :: handle

        call self%destroy()
        self%handle = handle
        self%home = address_of(self)
    end subroutine adopt

    function release(self) result(handle)
        class(amst_handle), intent(inout) :: self
        type(c_ptr) :: handle

        handle = self%c_handle()
        self%handle = c_null_ptr
        self%home = 0
    end function release

    !> The handle on the right of an assignment, which may be a copy made bit by bit by the compiler:
    !> gfortran makes one of the second a in a = a.
    pure function handle_to_copy(self) result(handle)
        class(amst_handle), intent(in) :: self
        type(c_ptr) :: handle

        handle = self%handle
    end function handle_to_copy

    pure function address_of(self) result(address)
        class(amst_handle), intent(in), target :: self
        integer(c_intptr_t) :: address

        address = transfer(c_loc(self%handle), address)
    end function address_of

end module alphamst_handle
