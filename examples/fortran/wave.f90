! Wave: adapt while you solve. A ring around the middle of a square runs outwards; before each step the field
! "size" asks for small faces near it, and the mesh changes only where its faces are off that. An energy and a
! temperature come along: the sum of the one and the linear values of the other stay.
!
!   build/release/examples/fortran/wave 6 [wave_]
program wave
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    implicit none
    integer(int32), parameter :: side = 32
    integer, parameter :: first = 5 ! radius
    real(real64), parameter :: middle = side / 2
    type(amst_context) :: context
    type(amst_options) :: options
    type(amst_mesh) :: mesh
    type(amst_report) :: report
    character(len=1024) :: argument, prefix
    real(real64) :: energy
    integer(int64) :: before
    integer :: steps, last, radius

    if (command_argument_count() < 1) error stop 'usage: wave STEPS [PICTURE_PREFIX]'
    call get_command_argument(1, argument)
    read (argument, *) steps
    call get_command_argument(2, prefix)
    last = first + steps - 1
    call context%create()
    call make_square()
    energy = total_energy()
    call options%create()
    call options%set(AMST_OPT_SIZE_BAND, 0.7_real64)

    print '(a6, a7, a7, a7, a10, a13, a9, a13)', 'radius', 'before', 'wanted', 'after', 'singular', &
        'smallest SJ', 'energy', 'temperature'
    do radius = first, last
        call want_sizes(radius)
        call alphamst_adapt(mesh, alpha=1.0_real64, options=options, report=report)
        call print_row()
        if (command_argument_count() > 1) then
            write (argument, '(a, i0, a)') trim(prefix), radius, '.svg'
            call mesh%write(argument)
        end if
    end do
    call want_sizes(last) ! the last call again
    before = mesh%checksum()
    call alphamst_adapt(mesh, alpha=1.0_real64, options=options)
    print '(a, a)', 'again: ', trim(merge('nothing changed ', 'the mesh changed', mesh%checksum() == before))

contains

    ! A square of unit squares with the two fields.
    subroutine make_square()
        real(real64) :: points(2, (side + 1)**2), humps(side**2), x, y
        integer(int32) :: faces(4, side**2), i, v
        do i = 0, (side + 1)**2 - 1
            points(:, 1 + i) = [mod(i, side + 1), i / (side + 1)]
        end do
        do i = 0, side**2 - 1
            v = 1 + i + i / side
            faces(:, 1 + i) = [v, v + 1, v + side + 2, v + side + 1]
            x = mod(i, side) + 0.5_real64 - middle
            y = i / side + 0.5_real64 - middle
            humps(1 + i) = 1 / (1 + (x * x + y * y) / 32)
        end do
        call mesh%create(context, points, faces)
        call mesh%set_field(AMST_FACE, 'energy', humps, AMST_CARRY_CONSERVE)
        call mesh%set_field(AMST_VERTEX, 'temperature', points(1, :) + 2 * points(2, :), AMST_CARRY_LINEAR)
    end subroutine make_square

    ! The field "size" around the ring: half an edge within 1.5 of it, a whole one from 5 on.
    subroutine want_sizes(radius)
        integer, intent(in) :: radius
        real(real64), allocatable :: sizes(:)
        real(real64) :: x, y, away
        integer :: i
        associate (points => mesh%points())
            allocate (sizes(size(points, 2)))
            do i = 1, size(points, 2)
                x = points(1, i) - middle
                y = points(2, i) - middle
                away = abs(sqrt(x * x + y * y) - radius)
                sizes(i) = 0.5_real64 + 0.5_real64 * (away - 1.5_real64) / 3.5_real64
                sizes(i) = min(max(0.5_real64, sizes(i)), 1.0_real64)
            end do
        end associate
        call mesh%set_field(AMST_VERTEX, 'size', sizes, AMST_CARRY_LINEAR)
    end subroutine want_sizes

    function total_energy() result(total)
        real(real64) :: total
        associate (values => mesh%field(AMST_FACE, 'energy'))
            total = sum(values(1, :) * mesh%quality(AMST_METRIC_AREA))
        end associate
    end function total_energy

    function temperature_error() result(error)
        real(real64) :: error
        associate (points => mesh%points(), values => mesh%field(AMST_VERTEX, 'temperature'))
            error = maxval(abs(values(1, :) - points(1, :) - 2 * points(2, :)))
        end associate
    end function temperature_error

    ! The power of ten above a value: its digits are those of rounding, and differ between languages.
    function bound(value) result(text)
        real(real64), intent(in) :: value
        character(len=:), allocatable :: text
        character(len=16) :: whole
        real(real64) :: limit
        integer :: power
        limit = 1e-12_real64
        power = -12
        do while (power < 0 .and. .not. value < limit)
            limit = 10 * limit
            power = power + 1
        end do
        write (whole, '(a, i0)') '< 1e', power
        text = trim(whole)
    end function bound

    subroutine print_row()
        character(len=:), allocatable :: change, error
        change = bound(abs(total_energy() / energy - 1))
        error = bound(temperature_error())
        print '(i6, i7, i7, i7, i10, f13.4, a9, a13)', radius, report%get_int(AMST_RESULT_FACES_BEFORE), &
            report%get_int(AMST_RESULT_FACES_WANTED), report%get_int(AMST_RESULT_FACES_AFTER), &
            report%get_int(AMST_RESULT_SINGULAR_AFTER), report%get_real(AMST_RESULT_QUALITY_AFTER), &
            change, error
    end subroutine print_row
end program wave
