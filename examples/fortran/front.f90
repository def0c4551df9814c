! Refine around a moving front: at every step the mesh is fine where the front is and as it was
! everywhere else.
!
!   build/release/examples/fortran/front examples/data/coast_small.msh [front_]
program front
    use, intrinsic :: iso_fortran_env, only: int64, real64
    use alphamst
    implicit none
    integer, parameter :: steps = 5
    type(amst_context) :: context
    type(amst_mesh) :: mesh
    type(amst_patches) :: patches
    type(amst_report) :: report
    integer(int64) :: coarse
    real(real64) :: center(3)
    character(len=1024) :: path, prefix
    integer :: step

    if (command_argument_count() < 1) error stop 'usage: front MESH [PICTURE_PREFIX]'
    call get_command_argument(1, path)
    call get_command_argument(2, prefix)
    call context%create()
    call mesh%read(context, path)
    call mesh%mark(coarse)

    print '(a4, a7, a7, a10, a13)', 'step', 'near', 'faces', 'singular', 'smallest SJ'
    do step = 0, steps - 1
        center = [4.2_real64 + 0.3_real64*step, 5.2_real64 + 0.05_real64*step, 0.0_real64]
        call mesh%rollback(coarse) ! the front has moved on
        call patches%create(mesh)
        call patches%add_ball(center, 0.8_real64)
        call alphamst_adapt(mesh, patches, 2.0_real64, report=report)
        print '(i4, i7, i7, i10, f13.4)', step, report%get_int(AMST_RESULT_FACES_AFTER), &
            mesh%count(AMST_FACE), report%get_int(AMST_RESULT_SINGULAR_AFTER), &
            report%get_real(AMST_RESULT_QUALITY_AFTER)
        if (command_argument_count() > 1) then
            write (path, '(a, i0, a)') trim(prefix), step, '.svg'
            call patches%write(path)
        end if
    end do
end program front
