! Improve a region: fewer singular vertices and better corners with the same number of faces.
!
!   build/release/examples/fortran/improve examples/data/coast_small.msh [after.svg]
program improve
    use, intrinsic :: iso_fortran_env, only: int32, real64
    use alphamst
    implicit none
    type(amst_context) :: context
    type(amst_mesh) :: mesh
    type(amst_patches) :: patches
    type(amst_report) :: report
    character(len=1024) :: path

    if (command_argument_count() < 1) error stop 'usage: improve MESH [PICTURE]'
    call get_command_argument(1, path)
    call context%create()
    call mesh%read(context, path)
    call patches%create(mesh)
    call patches%add_box([3.8_real64, 4.4_real64, 0.0_real64], [6.2_real64, 6.4_real64, 0.0_real64])
    call alphamst_adapt(mesh, patches, 1.0_real64, report=report)

    print '(a8, a7, a10, a13)', 'region  ', 'faces', 'singular', 'smallest SJ'
    call print_row('before  ', AMST_RESULT_FACES_BEFORE, AMST_RESULT_SINGULAR_BEFORE, AMST_RESULT_QUALITY_BEFORE)
    call print_row('after   ', AMST_RESULT_FACES_AFTER, AMST_RESULT_SINGULAR_AFTER, AMST_RESULT_QUALITY_AFTER)
    if (command_argument_count() > 1) then
        call get_command_argument(2, path)
        call patches%write(path)
    end if

contains

    subroutine print_row(state, faces, singular, quality)
        character(len=8), intent(in) :: state
        integer(int32), intent(in) :: faces, singular, quality

        print '(a8, i7, i10, f13.4)', state, report%get_int(faces, 1), report%get_int(singular, 1), &
            report%get_real(quality, 1)
    end subroutine print_row

end program improve
