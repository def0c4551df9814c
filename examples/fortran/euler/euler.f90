! Euler: a shock in air meets a ramp, and the mesh follows it and what comes of it.
!
!   build/release/examples/fortran/euler 80 [euler_]    least edge 1/80; pictures begin with euler_
!   build/release/examples/fortran/euler study [160]    beside meshes of one size; the truth has edges of 1/160
program euler
    use, intrinsic :: iso_fortran_env, only: int32, real64
    use alphamst
    use run
    implicit none
    type(amst_context) :: context
    type(outcome) :: got
    character(len=1024) :: argument, prefix
    integer :: n

    if (command_argument_count() < 1) error stop 'usage: euler N [PICTURE_PREFIX], or euler study [N]'
    call get_command_argument(1, argument)
    call get_command_argument(2, prefix)
    call context%create()
    call context%set_threads(1)
    if (argument == 'study') then
        n = 160
        if (prefix /= '') read (prefix, *) n
        call study((n))
    else
        read (argument, *) n
        if (n < 20 .or. mod(n, 20) /= 0) error stop 'N is a multiple of 20, at least 20'
        print '(a7, 2a7, 2a19, 2a10)', 'time', 'steps', 'faces', 'mass', 'energy', 'lost', 'lost'
        call solve(context, n, .true., got, prefix)
        print '(i0, a, f0.1, a, f0.1)', got%adaptations, ' adaptations; seconds ', got%seconds, ', of these in them ', &
            got%adapting
    end if

contains

    ! The error is the mean distance of the density to that on a much finer mesh.
    subroutine study(finest)
        integer, intent(in) :: finest
        type(outcome) :: truth
        integer :: k
        print '(a8, a7, 2a8, 3a10, 2a10)', 'mesh', '1/edge', 'faces', 'steps', 'seconds', 'adapting', 'error', &
            'lost', 'balance'
        call solve(context, finest, .false., truth)
        call row('truth', finest, truth, truth)
        do k = 1, 4
            if (5 * 2**k < finest) call compare('fixed', 5 * 2**k, truth)
        end do
        do k = 1, 4 ! whose largest edges are four times as long
            if (20 * k < finest) call compare('adapted', 20 * k, truth)
        end do
    end subroutine study

    subroutine compare(name, n, truth)
        character(len=*), intent(in) :: name
        integer, intent(in) :: n
        type(outcome), intent(in) :: truth
        type(outcome) :: tried
        call solve(context, n, name == 'adapted', tried)
        call row(name, n, tried, truth)
    end subroutine compare

    subroutine row(name, n, tried, truth)
        character(len=*), intent(in) :: name
        integer, intent(in) :: n
        type(outcome), intent(in) :: tried, truth
        print '(a8, i7, 2i8, 2f10.2, f10.5, 2es10.1)', name, n, size(tried%density), tried%steps, tried%seconds, &
            tried%adapting, distance(tried, truth), maxval(tried%lost), maxval(abs(tried%balance))
    end subroutine row

    function distance(a, b)
        type(outcome), intent(in) :: a, b
        real(real64) :: distance
        integer(int32), allocatable :: of_a(:), of_b(:)
        real(real64), allocatable :: areas(:)
        call a%mesh%overlap(b%mesh, of_a, of_b, areas)
        distance = sum(areas * abs(a%density(of_a) - b%density(of_b))) / sum(areas)
    end function distance

end program euler
