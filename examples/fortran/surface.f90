! Surface: a torus of triangles that lie at random becomes quads, and a fraction alpha of these, with few
! singular vertices; all vertices stay on the surface.
!
!   build/release/examples/fortran/surface 0.5 [after.svg]
program surface
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    implicit none
    integer(int32), parameter :: around = 64, across = 24, n_points = around * across
    real(real64), parameter :: radius = 1, tube = 0.4_real64 ! from the axis to the middle of the tube; its radius
    type(amst_context) :: context
    type(amst_mesh) :: mesh
    type(amst_report) :: report
    real(real64) :: points(3, n_points), alpha, farthest
    real(real64), allocatable :: now(:, :)
    integer(int32) :: triangles(3, 2 * n_points)
    integer(int64) :: n_sharp, i
    character(len=1024) :: argument

    if (command_argument_count() < 1) error stop 'usage: surface ALPHA [PICTURE]'
    call get_command_argument(1, argument)
    read (argument, *) alpha
    call make_torus(points, triangles)
    call context%create()
    call mesh%create(context, points, triangles)
    call mesh%detect_features(60.0_real64, n_sharp)
    call mesh%set_surface(points, triangles)
    call alphamst_adapt(mesh, alpha=alpha, report=report)

    now = mesh%points()
    farthest = 0
    do i = 1, size(now, 2, int64)
        farthest = max(farthest, distance(now(:, i)))
    end do
    print '(i0, a, i0, a)', size(triangles, 2), ' triangles, ', n_sharp, ' sharp edges'
    print '(a24, a7, a7)', '', 'before', 'after'
    print '(a24, i7, i7)', 'faces                   ', report%get_int(AMST_RESULT_FACES_BEFORE), &
        report%get_int(AMST_RESULT_FACES_AFTER)
    print '(a24, i7, i7)', 'singular vertices       ', report%get_int(AMST_RESULT_SINGULAR_BEFORE), &
        report%get_int(AMST_RESULT_SINGULAR_AFTER)
    print '(a24, f7.3, f7.3)', 'smallest scaled Jacobian', report%get_real(AMST_RESULT_QUALITY_BEFORE), &
        report%get_real(AMST_RESULT_QUALITY_AFTER)
    print '(f6.4, a)', farthest, ' from the torus at most'
    if (command_argument_count() > 1) then
        call get_command_argument(2, argument)
        call mesh%write(argument)
    end if

contains

    ! A number of -0.5 to 0.5 at random, the same in every language.
    function noise(state)
        integer(int64), intent(inout) :: state
        real(real64) :: noise
        state = mod(1103515245_int64 * state + 12345, 2147483648_int64)
        noise = real(state, real64) / 2147483648.0_real64 - 0.5_real64
    end function noise

    function distance(p)
        real(real64), intent(in) :: p(3)
        real(real64) :: distance, off
        off = sqrt(p(1) * p(1) + p(2) * p(2)) - radius
        distance = abs(sqrt(off * off + p(3) * p(3)) - tube)
    end function distance

    ! The point of the torus that is nearest to p.
    subroutine project(p)
        real(real64), intent(inout) :: p(3)
        real(real64) :: away, off, height, wide
        away = sqrt(p(1) * p(1) + p(2) * p(2))
        off = away - radius
        height = sqrt(off * off + p(3) * p(3))
        wide = (radius + off / height * tube) / away
        p = [p(1) * wide, p(2) * wide, p(3) / height * tube]
    end subroutine project

    ! Of a circle in parts, by turning from each to the next: sine and cosine are not the same to the last
    ! digit in every language.
    subroutine divide(cosine, sine, circle)
        real(real64), intent(in) :: cosine, sine
        real(real64), intent(out) :: circle(:, 0:)
        integer :: i
        circle(:, 0) = [1, 0]
        do i = 1, ubound(circle, 2)
            circle(1, i) = cosine * circle(1, i - 1) - sine * circle(2, i - 1)
            circle(2, i) = sine * circle(1, i - 1) + cosine * circle(2, i - 1)
        end do
    end subroutine divide

    subroutine make_torus(points, triangles)
        real(real64), intent(out) :: points(3, n_points)
        integer(int32), intent(out) :: triangles(3, 2 * n_points)
        real(real64) :: long_way(2, 0:around - 1), short_way(2, 0:2 * across - 1), at(2), wide, thrown(3)
        integer(int64) :: state
        integer(int32) :: i, j, k, a, b, c, d
        state = 1
        call divide(0.9951847266721969_real64, 0.0980171403295606_real64, long_way)
        call divide(0.9914448613738104_real64, 0.13052619222005157_real64, short_way)
        do i = 0, around - 1
            do j = 0, across - 1
                a = i * across + j + 1
                b = mod(i + 1, around) * across + j + 1
                c = mod(i + 1, around) * across + mod(j + 1, across) + 1
                d = i * across + mod(j + 1, across) + 1
                at = short_way(:, 2 * j + mod(i, 2)) ! every other row by half a cell
                wide = radius + tube * at(1)
                do k = 1, 3
                    thrown(k) = 0.04_real64 * noise(state)
                end do
                points(:, a) = [wide * long_way(1, i), wide * long_way(2, i), tube * at(2)] + thrown
                call project(points(:, a))
                if (mod(i, 2) == 0) then ! the short diagonals are those from b to d
                    triangles(:, 2 * a - 1) = [a, b, d]
                    triangles(:, 2 * a) = [b, c, d]
                else
                    triangles(:, 2 * a - 1) = [a, b, c]
                    triangles(:, 2 * a) = [a, c, d]
                end if
            end do
        end do
    end subroutine make_torus
end program surface
