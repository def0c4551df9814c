!> A NACA 0012 with a sharp trailing edge: vertices come and go on the profile and on the circle around.
program airfoil_test
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    integer, parameter :: around = 64, across = 10
    real(real64), parameter :: pi = acos(-1.0_real64), far = 4 ! radius of the circle, from the middle of the chord
    type(amst_context) :: context
    type(amst_options) :: options

    call context%create()
    call options%create()
    call options%set(AMST_OPT_EDIT_BOUNDARY, 1)
    call adapt(0.5_real64)
    call adapt(2.0_real64)
    call finish()

contains

    !> Half the thickness at the root of x, which is smooth at the leading edge; 0 at the trailing edge.
    pure function thickness(root) result(y)
        real(real64), intent(in) :: root
        real(real64) :: y

        y = 0.6_real64*(0.2969_real64*root - 0.1260_real64*root**2 - 0.3516_real64*root**4 + &
            0.2843_real64*root**6 - 0.1036_real64*root**8)
        if (root >= 1) y = 0
    end function thickness

    !> How fast the distance from p, above the chord, grows along the root; squared, and half of it.
    pure function slope(root, p)
        real(real64), intent(in) :: root, p(2)
        real(real64) :: slope

        slope = 2*root*(root**2 - p(1)) + (thickness(root) - p(2))*0.6_real64*(0.2969_real64 - &
            0.2520_real64*root - 1.4064_real64*root**3 + 1.7058_real64*root**5 - 0.8288_real64*root**7)
    end function slope

    !> The point of the profile that is nearest to p.
    pure function nearest_to(p) result(found)
        real(real64), intent(in) :: p(2)
        real(real64) :: found(2), above(2), low, high, root
        integer :: i, best

        above = [p(1), abs(p(2))]
        associate (distances => [(hypot((i/200.0_real64)**2 - above(1), &
                                        thickness(i/200.0_real64) - above(2)), i=0, 200)])
            best = minloc(distances, 1) - 1
        end associate
        low = max(best - 1, 0)/200.0_real64
        high = min(best + 1, 200)/200.0_real64
        do i = 1, 60
            root = (low + high)/2
            if (slope(root, above) < 0) then
                low = root
            else
                high = root
            end if
        end do
        found = [root**2, sign(thickness(root), p(2))]
    end function nearest_to

    subroutine project(markers, points, projected, failed, user)
        integer(int32), intent(in) :: markers(:)
        real(real64), intent(in) :: points(:, :)
        real(real64), intent(inout) :: projected(:, :)
        logical, intent(inout) :: failed
        class(*), pointer, intent(in) :: user
        real(real64) :: arm(2)
        integer :: i

        do i = 1, size(points, 2)
            arm = points(:, i) - [0.5_real64, 0.0_real64]
            if (norm2(arm) < far/2) then
                projected(:, i) = nearest_to(points(:, i))
            else
                projected(:, i) = far/norm2(arm)*arm + [0.5_real64, 0.0_real64]
            end if
        end do
        failed = size(markers) /= size(points, 2) .or. associated(user)
    end subroutine project

    !> Rings around the profile; vertex 1 is its trailing edge.
    subroutine new_grid_around(mesh)
        type(amst_mesh), intent(inout) :: mesh
        real(real64) :: points(2, around*(across + 1)), angle, part, profile(2), circle(2)
        integer(int32) :: faces(4, around*across), i, j, v, w

        do i = 0, around - 1
            angle = 2*pi*i/around
            profile = [(1 + cos(angle))/2, sign(thickness(sqrt((1 + cos(angle))/2)), sin(angle))]
            circle = [0.5_real64 + far*cos(angle), far*sin(angle)]
            v = 1 + i
            w = 1 + mod(i + 1, around)
            do j = 0, across
                part = (1.5_real64**j - 1)/(1.5_real64**across - 1)
                points(:, v + j*around) = (1 - part)*profile + part*circle
                if (j < across) faces(:, v + j*around) = [v + j*around, v + (j + 1)*around, w + (j + 1)*around, w + j*around]
            end do
        end do
        call mesh%create(context, points, faces)
    end subroutine new_grid_around

    subroutine adapt(alpha)
        real(real64), intent(in) :: alpha
        type(amst_mesh) :: mesh
        type(amst_summary) :: quality
        character(len=20) :: name
        integer(int64) :: n_faces

        write (name, '(a, f3.1, a)') 'alpha ', alpha, ': '
        call new_grid_around(mesh)
        call mesh%check()
        call mesh%set_flags(AMST_VERTEX, [1], AMST_FLAG_CORNER, AMST_FLAG_CORNER)
        call mesh%set_projection(project)
        call alphamst_adapt(mesh, alpha=alpha, options=options)
        n_faces = mesh%count(AMST_FACE)
        call claim(n_faces == nint(alpha*around*across), trim(name)//' as many faces as wanted')
        call mesh%check() ! stops at an inverted face
        quality = mesh%summary(AMST_METRIC_SCALED_JACOBIAN)
        call claim(quality%min > 0, trim(name)//' no inverted face')
        call boundary_is_where_it_was(mesh, alpha, trim(name))
    end subroutine adapt

    subroutine boundary_is_where_it_was(mesh, alpha, name)
        type(amst_mesh), intent(in) :: mesh
        real(real64), intent(in) :: alpha
        character(len=*), intent(in) :: name
        real(real64) :: off, p(2)
        logical :: has_trailing_edge
        integer :: e, on_profile

        off = 0
        on_profile = 0
        has_trailing_edge = .false.
        associate (points => mesh%points(), edges => mesh%edges(), sides => mesh%edge_faces())
            do e = 1, size(edges, 2)
                if (all(sides(:, e) /= 0)) cycle
                p = points(:, edges(1, e))
                if (norm2(p) < far/2) then
                    on_profile = on_profile + 1
                    off = max(off, abs(abs(p(2)) - thickness(sqrt(max(p(1), 0.0_real64)))))
                    has_trailing_edge = has_trailing_edge .or. norm2(p - [1, 0]) <= 0
                    p = points(:, edges(2, e))
                    off = max(off, abs(abs(p(2)) - thickness(sqrt(max(p(1), 0.0_real64)))))
                    has_trailing_edge = has_trailing_edge .or. norm2(p - [1, 0]) <= 0
                else
                    off = max(off, abs(norm2(p - [0.5_real64, 0.0_real64]) - far))
                end if
            end do
        end associate
        call claim(off <= 1e-12_real64, name//' all vertices are on the profile or the circle')
        call claim(has_trailing_edge, name//' the trailing edge stays')
        if (alpha > 1) call claim(on_profile > around, name//' vertices came')
        if (alpha < 1) call claim(on_profile < around, name//' vertices went')
    end subroutine boundary_is_where_it_was

end program airfoil_test
