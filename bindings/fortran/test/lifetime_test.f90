!> Handles end once: in any order, at the end of a scope, after assignment and after copies made bit
!> by bit. The last of these are what valgrind looks at.
module owners
    use alphamst
    implicit none

    !> A type with a mesh in it says itself how it is assigned.
    type :: owner
        integer :: number = 0
        type(amst_mesh) :: mesh
    contains
        procedure, private :: assign
        generic :: assignment(=) => assign
    end type owner

contains

    subroutine assign(self, other)
        class(owner), intent(inout) :: self
        class(owner), intent(in) :: other

        self%number = other%number
        self%mesh = other%mesh
    end subroutine assign

end module owners

program lifetime_test
    use, intrinsic :: iso_c_binding, only: c_associated, c_null_ptr, c_ptr
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    use owners
    implicit none

    type :: world
        type(amst_context) :: context
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        type(amst_report) :: report
    end type world

    call any_order_of_destroy()
    call scopes_end_handles()
    call deallocation_ends_handles()
    call intent_out_ends_handles()
    call create_replaces()
    call assignment_clones()
    call arrays_are_assigned_one_by_one()
    call components_are_assigned()
    call copies_bit_by_bit_end_nothing()
    call handles_change_hands()
    call finish()

contains

    !> Its projection is held by all copies.
    subroutine new_projected_grid(mesh, context, nx, ny)
        type(amst_mesh), intent(inout) :: mesh
        type(amst_context), intent(in) :: context
        integer, intent(in) :: nx, ny

        call new_grid(mesh, context, nx, ny)
        call mesh%set_projection(stay)
        call mesh%set_projection(stay) ! ends the one before
    end subroutine new_projected_grid

    subroutine stay(markers, points, projected, failed, user)
        integer(int32), intent(in) :: markers(:)
        real(real64), intent(in) :: points(:, :)
        real(real64), intent(inout) :: projected(:, :)
        logical, intent(inout) :: failed
        class(*), pointer, intent(in) :: user

        projected = points
        failed = size(markers) /= size(points, 2) .or. associated(user)
    end subroutine stay

    subroutine set_up(w)
        type(world), intent(inout) :: w

        call w%context%create()
        call new_projected_grid(w%mesh, w%context, 6, 6)
        call w%patches%create(w%mesh)
        call w%patches%add_faces(square(6, 1, 5))
        call alphamst_adapt(w%mesh, w%patches, 2.0_real64, report=w%report)
    end subroutine set_up

    !> All 24 orders; what is left works after every step.
    subroutine any_order_of_destroy()
        integer :: order(4), a, b, c, d, n

        n = 0
        do a = 1, 4
            do b = 1, 4
                do c = 1, 4
                    d = 10 - a - b - c
                    order = [a, b, c, d]
                    if (any([count(order == 1), count(order == 2), count(order == 3), count(order == 4)] /= 1)) cycle
                    call destroy_in_order(order)
                    n = n + 1
                end do
            end do
        end do
        call claim(n == 24, 'all orders')
    end subroutine any_order_of_destroy

    subroutine destroy_in_order(order)
        integer, intent(in) :: order(4)
        type(world) :: w
        integer :: k

        call set_up(w)
        do k = 1, 4
            select case (order(k))
            case (1)
                call w%context%destroy()
            case (2)
                call w%mesh%destroy()
            case (3)
                call w%patches%destroy()
            case (4)
                call w%report%destroy()
            end select
            if (w%mesh%exists()) call w%mesh%check()
            if (w%patches%exists()) call claim(size(w%patches%faces(1)) == 32, 'patches that are left')
            if (w%report%exists()) call claim(w%report%get_int(AMST_RESULT_FACES_AFTER) == 32, 'report that is left')
        end do
    end subroutine destroy_in_order

    subroutine scopes_end_handles()
        integer :: k

        do k = 1, 3
            block
                type(world) :: w
                type(amst_options) :: options

                call options%create()
                call set_up(w)
            end block
        end do
    end subroutine scopes_end_handles

    subroutine deallocation_ends_handles()
        type(world), allocatable :: w, moved
        type(amst_options), pointer :: options(:)

        allocate (w)
        call set_up(w)
        call move_alloc(w, moved)
        call claim(moved%mesh%count(AMST_FACE) == 36 - 16 + 32, 'moved by move_alloc')
        deallocate (moved)
        allocate (options(3))
        call options(1)%create()
        call options(3)%create()
        deallocate (options)
    end subroutine deallocation_ends_handles

    subroutine intent_out_ends_handles()
        type(world) :: w

        call set_up(w)
        call forget(w%mesh)
        call claim(.not. w%mesh%exists(), 'ended by intent(out)')
    end subroutine intent_out_ends_handles

    subroutine forget(mesh)
        type(amst_mesh), intent(out) :: mesh

        call claim(.not. mesh%exists(), 'intent(out) is empty')
    end subroutine forget

    subroutine create_replaces()
        type(world) :: w

        call set_up(w)
        call new_projected_grid(w%mesh, w%context, 2, 2)
        call claim(w%mesh%count(AMST_FACE) == 4, 'another mesh in its place')
        call w%patches%create(w%mesh)
        call claim(w%patches%count() == 0, 'another set in its place')
        call w%context%create()
        call w%mesh%check()
    end subroutine create_replaces

    subroutine assignment_clones()
        type(world) :: w
        type(amst_mesh) :: copy, nothing
        integer(int64) :: digest
        integer(int32) :: stat
        character(len=200) :: errmsg

        call set_up(w)
        digest = w%mesh%checksum()
        call new_projected_grid(copy, w%context, 2, 2)
        copy = w%mesh ! over a mesh there was
        call copy%set_flags(AMST_VERTEX, AMST_FLAG_FIXED, AMST_FLAG_FIXED)
        call claim(w%mesh%checksum() == digest, 'a copy goes its own way')
        call w%mesh%destroy()
        call claim(copy%count(AMST_FACE) == 52, 'a copy outlives')
        digest = copy%checksum()
        copy = copy
        call claim(copy%checksum() == digest, 'assigned to itself')
        w%mesh = (copy)
        call claim(w%mesh%checksum() == digest, 'assigned an expression')
        call copy%clone(w%mesh, stat, errmsg)
        call claim(stat == AMST_OK .and. w%mesh%exists(), 'cloned')
        call nothing%clone(copy, stat, errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'a clone of nothing')
        call claim(copy%exists(), 'a failed clone leaves the mesh there was')
        copy = nothing
        call claim(.not. copy%exists(), 'nothing assigned')
    end subroutine assignment_clones

    subroutine arrays_are_assigned_one_by_one()
        type(amst_context) :: context
        type(amst_mesh) :: a(3), b(3)

        call context%create()
        call new_projected_grid(a(1), context, 1, 1)
        call new_projected_grid(a(3), context, 3, 1)
        b = a
        call a(1)%destroy()
        call claim(b(1)%count(AMST_FACE) == 1, 'first element')
        call claim(.not. b(2)%exists(), 'second element')
        b(1:2) = b(3)
        call claim(b(1)%count(AMST_FACE) == 3, 'a scalar to a section')
        call claim(b(2)%count(AMST_FACE) == 3, 'and to its second element')
    end subroutine arrays_are_assigned_one_by_one

    subroutine components_are_assigned()
        type(amst_context) :: context
        type(owner) :: a, b

        call context%create()
        call new_projected_grid(a%mesh, context, 2, 1)
        a%number = 7
        call new_projected_grid(b%mesh, context, 3, 1)
        b = a
        call a%mesh%destroy()
        call claim(b%number == 7 .and. b%mesh%exists(), 'a component')
        call claim(b%mesh%count(AMST_FACE) == 2, 'is a mesh of its own')
    end subroutine components_are_assigned

    !> allocate with source= does not know of defined assignment.
    subroutine copies_bit_by_bit_end_nothing()
        type(world) :: w
        type(amst_mesh), allocatable :: copy
        type(amst_context), allocatable :: context

        call set_up(w)
        allocate (copy, source=w%mesh)
        call claim(.not. copy%exists(), 'a copy made bit by bit has no handle')
        deallocate (copy)
        allocate (context, source=w%context)
        deallocate (context)
        call w%mesh%check()
        call w%context%set_threads(2)
        call new_projected_grid(w%mesh, w%context, 2, 2)
    end subroutine copies_bit_by_bit_end_nothing

    subroutine handles_change_hands()
        type(world) :: w
        type(amst_mesh) :: other
        type(c_ptr) :: handle

        call set_up(w)
        call w%mesh%set_projection() ! a handle given away keeps it for good
        handle = w%mesh%c_handle()
        call claim(c_associated(handle), 'a handle to look at')
        handle = w%mesh%release()
        call claim(.not. w%mesh%exists(), 'a handle given away')
        call other%adopt(handle)
        call claim(other%count(AMST_FACE) == 52, 'and taken')
        call other%adopt(c_null_ptr)
        call claim(.not. other%exists(), 'and ended')
    end subroutine handles_change_hands

end program lifetime_test
