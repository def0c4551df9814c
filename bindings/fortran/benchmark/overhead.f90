! What the types of module alphamst cost over the bare C call, and points into an array of the
! caller over a copy of it. Stops if a query costs more than 100 ns above the C call, or the points
! of 10^6 vertices more than 1.2 copies.
program overhead
    use, intrinsic :: iso_c_binding, only: c_ptr
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use amst_c, only: amst_mesh_get_count
    implicit none
    type(amst_context) :: context
    type(amst_mesh) :: mesh

    call context%create()
    call new_grid(999)
    call time_queries()
    call time_points()

contains

    subroutine new_grid(n)
        integer, intent(in) :: n
        real(real64), allocatable :: points(:, :)
        integer(int32), allocatable :: faces(:, :)
        integer :: i, j, v

        allocate (points(2, (n + 1)*(n + 1)), faces(4, n*n))
        do j = 0, n
            do i = 0, n
                points(:, 1 + i + j*(n + 1)) = [i, j]
            end do
        end do
        do j = 0, n - 1
            do i = 0, n - 1
                v = 1 + i + j*(n + 1)
                faces(:, 1 + i + j*n) = [v, v + 1, v + n + 2, v + n + 1]
            end do
        end do
        call mesh%create(context, points, faces)
    end subroutine new_grid

    subroutine time_queries()
        integer, parameter :: repetitions = 5, calls = 2000000
        type(c_ptr) :: handle
        integer(int64) :: count, total
        integer(int32) :: status
        real(real64) :: start, c_time, time
        integer :: k, r

        handle = mesh%c_handle()
        total = 0
        c_time = huge(c_time)
        time = huge(time)
        do r = 1, repetitions
            start = seconds()
            do k = 1, calls
                status = amst_mesh_get_count(handle, AMST_FACE, count)
                total = total + count + status
            end do
            c_time = min(c_time, (seconds() - start)/calls)
            start = seconds()
            do k = 1, calls
                total = total + mesh%count(AMST_FACE)
            end do
            time = min(time, (seconds() - start)/calls)
        end do
        if (total /= 2_int64*repetitions*calls*998001) error stop 'wrong counts'
        print '(a, f7.1, a)', 'C call    ', 1e9_real64*c_time, ' ns'
        print '(a, f7.1, a, f7.1, a)', 'mesh%count', 1e9_real64*time, ' ns,', 1e9_real64*(time - c_time), ' ns more'
        if (time - c_time > 100e-9_real64) error stop 'a query costs too much'
    end subroutine time_queries

    subroutine time_points()
        integer, parameter :: repetitions = 20
        real(real64), allocatable :: from(:, :), to(:, :)
        real(real64) :: start, copy_time, time
        integer :: r

        allocate (from(2, 1000000), to(2, 1000000))
        call mesh%get_points(from)
        copy_time = huge(copy_time)
        time = huge(time)
        do r = 1, repetitions
            start = seconds()
            to(:, :) = from
            copy_time = min(copy_time, seconds() - start)
            if (to(1, 1000000) < 999) error stop 'wrong copy'
            to = 0
            start = seconds()
            call mesh%get_points(to)
            time = min(time, seconds() - start)
            if (to(1, 1000000) < 999) error stop 'wrong points'
        end do
        print '(a, f7.3, a)', 'copy      ', 1e3_real64*copy_time, ' ms'
        print '(a, f7.3, a, f5.2, a)', 'get_points', 1e3_real64*time, ' ms,', time/copy_time, ' copies'
        if (time > 1.2_real64*copy_time) error stop 'points cost too much'
    end subroutine time_points

    function seconds()
        real(real64) :: seconds
        integer(int64) :: ticks, rate

        call system_clock(ticks, rate)
        seconds = real(ticks, real64)/real(rate, real64)
    end function seconds

end program overhead
