! Sizes: what the report tells of the faces of two patches and of both together, for several alphas.
!
!   build/release/examples/fortran/sizes examples/data/coast_small.msh [after_]
program sizes
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    implicit none
    real(real64), parameter :: alphas(4) = [0.5_real64, 1.0_real64, 2.0_real64, 4.0_real64]
    type(amst_context) :: context
    type(amst_mesh) :: mesh
    type(amst_patches) :: patches
    type(amst_report) :: report
    integer(int64) :: begun
    character(len=1024) :: path, prefix
    integer :: i

    if (command_argument_count() < 1) error stop 'usage: sizes MESH [PICTURE_PREFIX]'
    call get_command_argument(1, path)
    call get_command_argument(2, prefix)
    call context%create()
    call mesh%read(context, path)
    call mesh%mark(begun)

    print '(a5, a6, a7, a10, a8, a8, a8, a8, a8, a8)', 'alpha', 'patch', 'faces', 'singular', 'before', &
        'after', 'area', 'edge', 'aspect', 'step'
    do i = 1, size(alphas)
        call mesh%rollback(begun)
        call patches%create(mesh)
        call patches%add_ball([4.2_real64, 5.2_real64, 0.0_real64], 0.7_real64)
        call patches%add_ball([6.0_real64, 5.0_real64, 0.0_real64], 0.7_real64)
        call alphamst_adapt(mesh, patches, alphas(i), report=report)
        call print_row('1', 1)
        call print_row('2', 2)
        call print_row('both', AMST_ALL)
        if (command_argument_count() > 1) then
            write (path, '(a, i0, a)') trim(prefix), i - 1, '.svg'
            call patches%write(path)
        end if
    end do

contains

    subroutine print_row(name, patch)
        character(len=*), intent(in) :: name
        integer(int32), intent(in) :: patch
        print '(f5.1, a6, i7, i10, f8.2, f8.2, f8.2, f8.2, f8.2, f8.2)', alphas(i), name, &
            report%get_int(AMST_RESULT_FACES_AFTER, patch), report%get_int(AMST_RESULT_SINGULAR_AFTER, patch), &
            report%get_real(AMST_RESULT_SIZE_ERROR_BEFORE, patch), &
            report%get_real(AMST_RESULT_SIZE_ERROR_AFTER, patch), &
            report%get_real(AMST_RESULT_LEAST_AREA_AFTER, patch), &
            report%get_real(AMST_RESULT_SHORTEST_EDGE_AFTER, patch), &
            report%get_real(AMST_RESULT_ASPECT_RATIO_AFTER, patch), report%get_real(AMST_RESULT_TIME_STEP, patch)
    end subroutine print_row
end program sizes
