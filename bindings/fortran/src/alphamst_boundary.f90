!> The boundary as the caller knows it, for operations with AMST_OPT_EDIT_BOUNDARY.
module alphamst_boundary
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_funloc, c_int32_t, &
        c_int64_t, c_loc, c_null_funptr, c_null_ptr, c_ptr
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use amst_c, only: amst_mesh_get_dim, amst_mesh_set_projection
    implicit none
    private

    public :: amst_projection, held_projection, project_by, hold, let_go

    abstract interface
        !> Sets projected(dim, n) to the points of the boundary that belong to points(dim, n), which are on
        !> or near edges with these markers(n). failed, .false. before: the operation has the status
        !> AMST_ERR_PROJECTION and changes nothing. user is what set_projection was given, not associated
        !> if nothing was. Called on the thread of the operation; equal points have equal results.
        !> Asking is allowed here, changing something of the context is AMST_ERR_STATE.
        subroutine amst_projection(markers, points, projected, failed, user)
            import :: int32, real64
            implicit none
            integer(int32), intent(in) :: markers(:)
            real(real64), intent(in) :: points(:, :)
            real(real64), intent(inout) :: projected(:, :)
            logical, intent(inout) :: failed
            class(*), pointer, intent(in) :: user
        end subroutine amst_projection
    end interface

    !> Lies still in memory, whatever happens to mesh variables: C has its address. The mesh and its
    !> copies hold it.
    type :: held_projection
        private
        procedure(amst_projection), pointer, nopass :: project => null()
        class(*), pointer :: user => null()
        integer(int32) :: dim = 0
        integer :: holders = 1
    end type held_projection

contains

    !> Give the mesh another projection, or none. held becomes the new one, and the mesh holds the one
    !> before no longer; after a failure all is as it was.
    function project_by(mesh, held, projection, user) result(status)
        type(c_ptr), intent(in) :: mesh
        type(held_projection), pointer, intent(inout) :: held
        procedure(amst_projection), optional :: projection
        class(*), intent(inout), target, optional :: user
        integer(int32) :: status
        type(held_projection), pointer :: before

        before => held
        if (present(projection)) then
            allocate (held)
            held%project => projection
            if (present(user)) held%user => user
            status = amst_mesh_get_dim(mesh, held%dim)
            if (status >= 0) status = amst_mesh_set_projection(mesh, c_funloc(call_projection), c_loc(held))
            if (status < 0) deallocate (held)
        else
            held => null()
            status = amst_mesh_set_projection(mesh, c_null_funptr, c_null_ptr)
        end if
        if (status < 0) then
            held => before
        else if (associated(before)) then
            before%holders = before%holders - 1
            if (before%holders == 0) deallocate (before)
        end if
    end function project_by

    !> For a copy of the mesh.
    subroutine hold(held)
        type(held_projection), pointer, intent(in) :: held

        if (associated(held)) held%holders = held%holders + 1
    end subroutine hold

    !> Before the mesh is destroyed. An operation under way, in whose callback that happens, would still
    !> call: the library then refuses to let go of it, and what is left, some bytes, stays.
    subroutine let_go(mesh, held)
        type(c_ptr), intent(in) :: mesh
        type(held_projection), pointer, intent(inout) :: held

        if (c_associated(mesh) .and. associated(held)) then
            if (amst_mesh_set_projection(mesh, c_null_funptr, c_null_ptr) >= 0) then
                held%holders = held%holders - 1
                if (held%holders == 0) deallocate (held)
            end if
        end if
        held => null()
    end subroutine let_go

    function call_projection(user, n, marker, points, projected) result(status) bind(c, name='')
        type(c_ptr), value :: user
        integer(c_int64_t), value :: n
        type(c_ptr), value :: marker, points, projected
        integer(c_int32_t) :: status
        type(held_projection), pointer :: held
        integer(c_int32_t), pointer :: markers(:)
        real(c_double), pointer :: given(:, :), found(:, :)
        logical :: failed

        status = 0
        if (n <= 0) return
        call c_f_pointer(user, held)
        call c_f_pointer(marker, markers, [n])
        call c_f_pointer(points, given, [int(held%dim, int64), n])
        call c_f_pointer(projected, found, [int(held%dim, int64), n])
        failed = .false.
        call held%project(markers, given, found, failed, held%user)
        if (failed) status = 1
    end function call_projection

end module alphamst_boundary
