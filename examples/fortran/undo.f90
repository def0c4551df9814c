! Undo: two changes, each taken back, and the mesh is bit for bit what it was.
!
!   build/release/examples/fortran/undo examples/data/coast_small.msh
program undo
    use, intrinsic :: iso_fortran_env, only: int64, real64
    use alphamst
    implicit none
    type(amst_context) :: context
    type(amst_mesh) :: mesh
    integer(int64) :: digest, first, second
    character(len=1024) :: path

    if (command_argument_count() < 1) error stop 'usage: undo MESH'
    call get_command_argument(1, path)
    call context%create()
    call mesh%read(context, path)
    digest = mesh%checksum()
    print '(a16, a7, a10)', 'mesh            ', 'faces', 'singular'
    call print_row('read            ')

    call mesh%mark(first)
    call adapt_ball(4.9_real64, 5.3_real64, 3.0_real64)
    call print_row('refined         ')
    call mesh%mark(second)
    call alphamst_smooth(mesh)
    call print_row('smoothed        ')
    call mesh%rollback(second)
    call print_row('not smoothed    ')
    call mesh%rollback(first)
    call print_row('not refined     ')
    call mesh%forget(first)

contains

    subroutine print_row(what)
        character(len=16), intent(in) :: what
        character(len=:), allocatable :: state

        state = 'changed'
        if (mesh%checksum() == digest) state = 'as at the start'
        print '(a16, i7, i10, 3x, a)', what, mesh%count(AMST_FACE), size(mesh%singularities()), state
    end subroutine print_row

    subroutine adapt_ball(x, y, alpha)
        real(real64), intent(in) :: x, y, alpha
        type(amst_patches) :: patches

        call patches%create(mesh)
        call patches%add_ball([x, y, 0.0_real64], 0.8_real64)
        call alphamst_adapt(mesh, patches, alpha)
    end subroutine adapt_ball

end program undo
