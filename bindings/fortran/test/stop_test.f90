!> Failures without stat, and assignments that cannot be, stop the program with a sentence. The
!> program runs itself for each of them.
program stop_test
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    character(len=32) :: which

    call get_command_argument(1, which)
    select case (which)
    case ('')
        call expect('threads', '-3')
        call expect('errmsg', '-3')
        call expect('function', 'metric')
        call expect('rows', 'first extent of the array is 3, not 2')
        call expect('no_mesh', 'mesh')
        call expect('context', 'an amst_context cannot be assigned')
        call expect('patches', 'an amst_patches cannot be assigned')
        call expect('report', 'an amst_report cannot be assigned')
        call finish()
    case default
        call fail(trim(which))
    end select

contains

    subroutine expect(how, words)
        character(len=*), intent(in) :: how, words
        character(len=1024) :: program_name, line
        integer :: code, unit, status
        logical :: said

        call get_command_argument(0, program_name)
        code = 0
        call execute_command_line('"'//trim(program_name)//'" '//how//' 2> stop_test.txt', exitstat=code)
        call claim(code /= 0, how//' stops')
        said = .false.
        open (newunit=unit, file='stop_test.txt', status='old', action='read')
        do
            read (unit, '(a)', iostat=status) line
            if (status /= 0) exit
            said = said .or. index(line, words) > 0
        end do
        close (unit, status='delete')
        call claim(said, how//' says: '//words)
    end subroutine expect

    subroutine fail(how)
        character(len=*), intent(in) :: how
        type(amst_context) :: context, other_context
        type(amst_mesh) :: mesh, no_mesh
        type(amst_patches) :: patches, other_patches
        type(amst_report) :: report, other_report
        type(amst_summary) :: summary
        real(real64) :: solid(3, 9)
        integer(int64) :: count
        character(len=100) :: errmsg

        call context%create()
        call new_grid(mesh, context, 2, 2)
        call patches%create(mesh)
        call patches%add_faces([1, 2, 3, 4])
        call alphamst_adapt(mesh, patches, 1.0_real64, report=report)
        select case (how)
        case ('threads')
            call context%set_threads(-3)
        case ('errmsg')
            call context%set_threads(-3, errmsg=errmsg)
        case ('function')
            summary = mesh%summary(99)
            print *, summary%count
        case ('rows')
            call mesh%get_points(solid)
        case ('no_mesh')
            count = no_mesh%count(AMST_FACE)
            print *, count
        case ('context')
            other_context = context
        case ('patches')
            other_patches = patches
        case ('report')
            other_report = report
        end select
    end subroutine fail

end program stop_test
