! An outside program in Fortran, with the binding.
program finer
    use, intrinsic :: iso_fortran_env, only: int32, real64
    use alphamst
    implicit none
    integer, parameter :: n = 8
    type(amst_context) :: context
    type(amst_mesh) :: mesh
    type(amst_patches) :: patches
    real(real64) :: points(2, (n + 1)**2)
    integer(int32) :: faces(4, n**2)
    integer :: i, j, v

    do j = 0, n
        do i = 0, n
            points(:, j*(n + 1) + i + 1) = real([i, j], real64)
        end do
    end do
    do j = 0, n - 1
        do i = 0, n - 1
            v = j*(n + 1) + i + 1
            faces(:, j*n + i + 1) = [v, v + 1, v + n + 2, v + n + 1]
        end do
    end do
    call context%create()
    call mesh%create(context, points, faces)
    call patches%create(mesh)
    call patches%add_ball([4.0_real64, 4.0_real64, 0.0_real64], 2.5_real64)
    call alphamst_adapt(mesh, patches, 2.0_real64)
    call mesh%check()
    print '(a, " ", i0, " faces")', alphamst_version_string(), mesh%count(AMST_FACE)
    if (mesh%count(AMST_FACE) <= n**2) error stop 'the mesh is no finer'
end program finer
