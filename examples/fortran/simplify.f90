! Simplify: three faces where there were four, patch by patch over the whole mesh. A patch that
! cannot have its wanted faces is left as it was.
!
!   build/release/examples/fortran/simplify examples/data/coast_small.msh [after.svg]
program simplify
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    implicit none
    type(amst_context) :: context
    type(amst_options) :: options
    type(amst_mesh) :: mesh
    type(amst_patches) :: patches
    type(amst_report) :: report
    integer(int64) :: n_patches, left
    integer(int32) :: patch
    logical :: is_left
    character(len=1024) :: path

    if (command_argument_count() < 1) error stop 'usage: simplify MESH [PICTURE]'
    call get_command_argument(1, path)
    call options%create()
    call options%set(AMST_OPT_PATCH_FACES, 80.0_real64)
    call options%set(AMST_OPT_SEED, 7)
    call context%create()
    call mesh%read(context, path, options)
    call patches%create(mesh, options)
    call patches%decompose(AMST_DECOMPOSE_CLUSTERS, n_patches)
    call alphamst_adapt(mesh, patches, 0.75_real64, options, report)

    left = 0
    print '(a5, a7, a7, a7, a10)', 'patch', 'before', 'wanted', 'after', 'singular'
    do patch = 1, int(n_patches, int32)
        is_left = report%get_int(AMST_RESULT_STATUS, patch) < 0
        if (is_left) left = left + 1
        print '(i5, i7, i7, i7, i10, a)', patch, report%get_int(AMST_RESULT_FACES_BEFORE, patch), &
            report%get_int(AMST_RESULT_FACES_WANTED, patch), report%get_int(AMST_RESULT_FACES_AFTER, patch), &
            report%get_int(AMST_RESULT_SINGULAR_AFTER, patch), trim(merge('  left', '      ', is_left))
    end do
    print '(i0, a, i0, a)', left, ' of ', n_patches, ' patches left'
    if (command_argument_count() > 1) then
        call get_command_argument(2, path)
        call patches%write(path)
    end if
end program simplify
