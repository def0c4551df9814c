!> Threads of OpenMP: each with a context and a clone of its own; and a mesh with threads of its own before.
program openmp_test
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    integer, parameter :: n = 12, n_clones = 8
    type(amst_context) :: context, own
    type(amst_mesh) :: mesh, serial, clone
    integer(int64) :: digests(n_clones)
    integer :: i

    call context%create()
    call context%set_threads(2)
    call new_grid(mesh, context, n, n)
    call mesh%clone(serial)
    call alphamst_adapt(serial, alpha=2.0_real64)

    !$omp parallel do private(own, clone)
    do i = 1, n_clones
        call own%create()
        call mesh%clone(clone, context=own)
        call alphamst_adapt(clone, alpha=2.0_real64)
        digests(i) = clone%checksum()
        call clone%destroy()
        call own%destroy()
    end do
    !$omp end parallel do

    call claim(all(digests == serial%checksum()), 'every thread comes to the same mesh')
    call finish()
end program openmp_test
