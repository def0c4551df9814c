! Wall: a shock runs around a bend between two circles. Under its foot on the outer wall the mesh is
! refined, wall and all, and behind it made coarser again; all vertices of the wall stay on the circle.
!
!   build/release/examples/fortran/wall 4 [wall_]
program wall
    use, intrinsic :: iso_fortran_env, only: int32, real64
    use alphamst
    implicit none
    integer(int32), parameter :: along = 64, across = 16
    real(real64), parameter :: inner = 1, outer = 2
    type(amst_context) :: context
    type(amst_options) :: options
    type(amst_mesh) :: mesh
    real(real64) :: circle(2, 0:along), alpha
    character(len=1024) :: argument, prefix
    integer :: steps, step

    if (command_argument_count() < 1) error stop 'usage: wall STEPS [PICTURE_PREFIX]'
    call get_command_argument(1, argument)
    read (argument, *) steps
    call get_command_argument(2, prefix)
    call divide()
    call context%create()
    call make_bend()
    call options%create()
    call options%set(AMST_OPT_EDIT_BOUNDARY, 1)
    call mesh%set_projection(project)

    print '(a4, a7, a7, a16, a13)', 'step', 'faces', 'edges', 'from the wall', 'smallest SJ'
    do step = 0, steps
        if (step > 0) then ! 0: as it was made
            call want_sizes(outer * circle(:, step * along / (steps + 1)), alpha)
            call alphamst_adapt(mesh, alpha=alpha, options=options)
        end if
        call print_row()
        if (command_argument_count() > 1) then
            write (argument, '(a, i0, a)') trim(prefix), step, '.svg'
            call mesh%write(argument)
        end if
    end do

contains

    pure function length(p)
        real(real64), intent(in) :: p(2)
        real(real64) :: length
        length = sqrt(p(1) * p(1) + p(2) * p(2))
    end function length

    ! Of the bend in parts, by turning from each to the next: sine and cosine are not the same to the last
    ! digit in every language.
    subroutine divide()
        real(real64), parameter :: cosine = 0.9987954562051724_real64, sine = 0.04906767432741801_real64
        integer :: i
        circle(:, 0) = [1, 0]
        do i = 1, along
            circle(1, i) = cosine * circle(1, i - 1) - sine * circle(2, i - 1)
            circle(2, i) = sine * circle(1, i - 1) + cosine * circle(2, i - 1)
        end do
        circle(2, along) = 0
    end subroutine divide

    subroutine make_bend()
        real(real64) :: points(2, (along + 1) * (across + 1))
        integer(int32) :: faces(4, along * across), i, j, v
        do i = 0, along
            do j = 0, across
                points(:, 1 + i * (across + 1) + j) = (inner + (outer - inner) * j / across) * circle(:, i)
            end do
        end do
        do i = 0, along * across - 1
            v = 1 + i + i / across
            faces(:, 1 + i) = [v, v + 1, v + across + 2, v + across + 1]
        end do
        call mesh%create(context, points, faces)
    end subroutine make_bend

    ! The two ends of the bend are on y = 0, the rest of its boundary on the two circles.
    subroutine project(markers, points, projected, failed, user)
        integer(int32), intent(in) :: markers(:)
        real(real64), intent(in) :: points(:, :)
        real(real64), intent(inout) :: projected(:, :)
        logical, intent(inout) :: failed
        class(*), pointer, intent(in) :: user
        real(real64) :: radius
        integer :: i
        do i = 1, size(points, 2)
            radius = length(points(:, i))
            projected(:, i) = points(:, i)
            if (points(2, i) > 0) &
                projected(:, i) = merge(inner, outer, radius < (inner + outer) / 2) / radius * points(:, i)
        end do
        failed = size(markers) < size(points, 2) .or. associated(user) ! never
    end subroutine project

    ! The field "size" around the foot of the shock, and the alpha that it asks for.
    subroutine want_sizes(foot, alpha)
        real(real64), intent(in) :: foot(2)
        real(real64), intent(out) :: alpha
        real(real64), allocatable :: sizes(:)
        real(real64) :: wanted, side
        integer :: i
        wanted = 0
        associate (points => mesh%points(), faces => mesh%faces(), area => mesh%quality(AMST_METRIC_AREA))
            allocate (sizes(size(points, 2)))
            do i = 1, size(points, 2)
                sizes(i) = min(0.02_real64 + 0.2_real64 * length(points(:, i) - foot), 0.08_real64)
            end do
            do i = 1, size(faces, 2)
                side = (sizes(faces(1, i)) + sizes(faces(2, i)) + sizes(faces(3, i)) + sizes(faces(4, i))) / 4
                wanted = wanted + area(i) / (side * side)
            end do
            alpha = wanted / size(faces, 2)
        end associate
        call mesh%set_field(AMST_VERTEX, 'size', sizes, AMST_CARRY_LINEAR)
    end subroutine want_sizes

    subroutine print_row()
        type(amst_summary) :: quality
        real(real64) :: farthest, radius
        integer :: on_wall, i
        on_wall = 0
        farthest = 0
        associate (points => mesh%points(), edges => mesh%edges(), sides => mesh%edge_faces())
            do i = 1, size(edges, 2)
                radius = length(points(:, edges(1, i)))
                if (all(sides(:, i) /= 0) .or. sum(points(2, edges(:, i))) <= 0 &
                    .or. radius < (inner + outer) / 2) cycle
                on_wall = on_wall + 1
                farthest = max(farthest, abs(radius - outer), abs(length(points(:, edges(2, i))) - outer))
            end do
        end associate
        quality = mesh%summary(AMST_METRIC_SCALED_JACOBIAN)
        print '(i4, i7, i7, f16.12, f13.4)', step, mesh%count(AMST_FACE), on_wall, farthest, quality%min
    end subroutine print_row
end program wall
