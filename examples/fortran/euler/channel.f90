!> A channel 1.6 long and 1 high, whose floor rises from x = 0.4 on by 1 in 2.
module channel
    use, intrinsic :: iso_fortran_env, only: int32, real64
    use alphamst
    use scheme, only: inflow, outflow, wall
    implicit none
    private

    public :: make_channel

    !> Of the floor before and on the ramp: where markers change a vertex stays, and it is in the corner.
    integer(int32), parameter :: floor_marker = wall, ramp_marker = 10

contains

    !> With n columns of faces a unit of length, a multiple of 5, and as many rows.
    subroutine make_channel(mesh, context, n)
        type(amst_mesh), intent(inout) :: mesh
        type(amst_context), intent(in) :: context
        integer, intent(in) :: n
        real(real64), allocatable :: points(:, :)
        integer(int32), allocatable :: faces(:, :)
        integer(int32) :: columns, corner, i, v
        real(real64) :: x, bottom
        columns = 8 * n / 5
        corner = 2 * n / 5
        allocate (points(2, (columns + 1) * (n + 1)), faces(4, columns * n))
        do i = 0, size(points, 2) - 1
            x = real(mod(i, columns + 1), real64) / n
            bottom = max(0.0_real64, real(mod(i, columns + 1) - corner, real64) / n) / 2
            points(:, 1 + i) = [x, bottom + (1 - bottom) * (i / (columns + 1)) / n]
        end do
        do i = 0, columns * n - 1
            v = 1 + i + i / columns
            faces(:, 1 + i) = [v, v + 1, v + columns + 2, v + columns + 1]
        end do
        call mesh%create(context, points, faces)
        call mark_boundary(mesh)
    end subroutine make_channel

    subroutine mark_boundary(mesh)
        type(amst_mesh), intent(inout) :: mesh
        integer(int32) :: e, marker
        real(real64) :: middle(2)
        associate (points => mesh%points(), edges => mesh%edges(), sides => mesh%edge_faces(), &
                normals => mesh%geometry(AMST_GEOMETRY_NORMALS))
            do e = 1, size(edges, 2)
                if (sides(2, e) > 0) cycle
                middle = sum(points(:, edges(:, e)), 2) / 2
                marker = floor_marker
                if (normals(2, e) < 0 .and. middle(1) > 0.4_real64) marker = ramp_marker
                if (normals(1, e) < -0.9_real64) marker = inflow
                if (normals(1, e) > 0.9_real64) marker = outflow
                call mesh%set_markers(AMST_EDGE, [e], marker)
            end do
        end associate
        call mesh%set_marker_name(AMST_EDGE, floor_marker, 'wall')
        call mesh%set_marker_name(AMST_EDGE, ramp_marker, 'ramp')
        call mesh%set_marker_name(AMST_EDGE, inflow, 'inflow')
        call mesh%set_marker_name(AMST_EDGE, outflow, 'outflow')
    end subroutine mark_boundary

end module channel
