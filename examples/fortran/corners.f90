! Choose the faces of a patch by hand and ask what would come with corners set by hand and with
! those of the library; then take the latter.
!
!   build/release/examples/fortran/corners examples/data/coast_small.msh [after.svg]
program corners
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    implicit none
    real(real64), parameter :: alphas(4) = [0.75_real64, 1.0_real64, 1.5_real64, 2.0_real64]
    type(amst_context) :: context
    type(amst_mesh) :: mesh
    type(amst_patches) :: patches
    type(amst_report) :: report
    integer(int32), allocatable :: chosen(:)
    integer(int32) :: patch, defects
    integer(int64) :: after, singular, by_hand
    real(real64) :: convexity
    character(len=1024) :: path
    integer :: k

    if (command_argument_count() < 1) error stop 'usage: corners MESH [PICTURE]'
    call get_command_argument(1, path)
    call context%create()
    call mesh%read(context, path)
    chosen = faces_in_ellipse()
    call patches%create(mesh)
    call patches%add_faces(chosen, patch)
    call patches%check(patch, defects, convexity)
    print '(i0, a, i0, a, f5.3)', size(chosen), ' faces chosen, defects ', defects, ', convexity ', convexity

    print '(a5, a7, a19, a19)', 'alpha', 'faces', 'singular, by hand', 'by the library'
    do k = 1, size(alphas)
        call patches%set_corners(patch, quarters(patches%boundary(patch)))
        call patches%predict(patch, alphas(k), singularities=by_hand)
        call patches%set_corners(patch, [integer(int32) ::])
        call patches%predict(patch, alphas(k), faces=after, singularities=singular)
        print '(f5.2, i7, i19, i19)', alphas(k), after, by_hand, singular
    end do
    call alphamst_adapt(mesh, patches, 1.5_real64, report=report)
    print '(a5, i7, a19, i19)', 'done', report%get_int(AMST_RESULT_FACES_AFTER, patch), '', &
        report%get_int(AMST_RESULT_SINGULAR_AFTER, patch)
    if (command_argument_count() > 1) then
        call get_command_argument(2, path)
        call patches%write(path)
    end if

contains

    !> Faces whose centroid is in the ellipse around (4.9, 5.3).
    function faces_in_ellipse() result(inside)
        integer(int32), allocatable :: inside(:)
        real(real64) :: x, y
        integer :: f

        allocate (inside(0))
        associate (points => mesh%points(), faces => mesh%faces())
            do f = 1, size(faces, 2)
                x = sum(points(1, faces(:, f)))/4
                y = sum(points(2, faces(:, f)))/4
                if ((x - 4.9_real64)**2/1.2_real64 + (y - 5.3_real64)**2/0.7_real64 < 1) inside = [inside, f]
            end do
        end associate
    end function faces_in_ellipse

    !> Four boundary vertices, a quarter of the boundary from one to the next.
    function quarters(boundary) result(four)
        integer(int32), intent(in) :: boundary(:)
        integer(int32) :: four(4)
        integer :: k

        four = [(boundary(1 + k*size(boundary)/4), k=0, 3)]
    end function quarters

end program corners
