program indicator_test
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    type(amst_context) :: context
    type(amst_mesh) :: mesh
    type(amst_options) :: options
    real(real64) :: ones(16), asked
    integer(int32) :: stat
    character(len=200) :: errmsg

    ones = 1
    call context%create()
    call new_grid(mesh, context, 4, 4)
    call mesh%size_from_indicator(ones, faces=64_int64, asked_faces=asked)
    call claim(abs(asked - 64) < 0.1_real64, 'as many faces')
    call claim(maxval(abs(mesh%field(AMST_VERTEX, 'size') - 0.5_real64)) < 1e-3_real64, 'half as long')
    call options%create()
    call options%set(AMST_OPT_ERROR_ORDER, 2.0_real64)
    call options%set(AMST_OPT_MIN_EDGE, 1.0_real64)
    call mesh%size_from_indicator(ones, 0.25_real64, options=options, asked_faces=asked)
    call claim(abs(asked - 16) < 1e-12_real64, 'no shorter than allowed')
    call mesh%size_from_indicator(ones, 0.25_real64, 32_int64, asked_faces=asked)
    call claim(abs(asked - 32) < 0.1_real64, 'no more faces than allowed')
    call mesh%size_from_indicator(ones, stat=stat, errmsg=errmsg)
    call refused(stat, AMST_ERR_RANGE, errmsg, 'neither tolerance nor faces')
    call finish()
end program indicator_test
