program surface_test
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    type(amst_context) :: context
    real(real64), parameter :: corners(2, 4) = real(reshape([0, 0, 3, 0, 3, 3, 0, 3], [2, 4]), real64)

    call context%create()
    call a_surface_is_no_change_of_the_mesh()
    call bad_triangles_are_named()
    call finish()

contains

    subroutine a_surface_is_no_change_of_the_mesh()
        type(amst_mesh) :: mesh
        integer(int64) :: digest

        call new_grid(mesh, context, 3, 3)
        digest = mesh%checksum()
        call mesh%set_surface()
        call mesh%set_surface(corners, reshape([1, 2, 3, 1, 3, 4], [3, 2]))
        call claim(mesh%checksum() == digest, 'the same checksum')
        call claim(mesh%revision() == 0, 'the same revision')
    end subroutine a_surface_is_no_change_of_the_mesh

    subroutine bad_triangles_are_named()
        type(amst_mesh) :: mesh
        real(real64) :: points(2, 4)
        integer(int32), parameter :: first(3, 1) = reshape([1, 2, 3], [3, 1])
        integer(int32) :: stat
        character(len=200) :: errmsg

        call new_grid(mesh, context, 3, 3)
        call mesh%set_surface(corners, reshape([1, 2, 3, 1, 3, 5], [3, 2]), stat, errmsg)
        call claim(index(errmsg, 'triangle 2 of the surface has corner 5') > 0, 'the triangle is named')
        call refused(stat, AMST_ERR_RANGE, errmsg, 'corner 5')
        call mesh%set_surface(corners, reshape([0, 1, 2], [3, 1]), stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'corner 0')
        call mesh%set_surface(corners, first(:, :0), stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'no triangle')
        call mesh%set_surface(corners(:, :0), first, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'no points, which is not the mesh')
        points = corners
        points(2, 3) = ieee_value(0.0_real64, ieee_quiet_nan)
        call mesh%set_surface(points, first, stat, errmsg)
        call refused(stat, AMST_ERR_NOT_FINITE, errmsg, 'a coordinate that is no number')
        call mesh%set_surface(points(:1, :), first, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'points of one coordinate')
        call mesh%set_surface(corners, first(:2, :), stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'triangles of two corners')
        call mesh%destroy()
        call mesh%set_surface(corners, first, stat, errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'a mesh destroyed')
    end subroutine bad_triangles_are_named

end program surface_test
