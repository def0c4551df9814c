program cross_field_test
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    type(amst_context) :: context

    call context%create()
    call it_follows_the_boundary()
    call it_can_be_given()
    call finish()

contains

    subroutine it_follows_the_boundary()
        type(amst_mesh) :: mesh
        type(amst_options) :: options
        real(real64) :: angle
        integer(int32) :: stat
        character(len=200) :: errmsg

        call new_grid(mesh, context, 4, 3)
        angle = mesh%alignment(stat, errmsg)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'alignment without a field')
        call mesh%compute_cross_field()
        call claim(mesh%alignment() < 1e-9_real64, 'edges follow the field')
        associate (cross => mesh%field(AMST_FACE, 'cross'))
            call claim(all(shape(cross) == [3, 12]), 'three numbers for each face')
            call claim(all(abs(maxval(abs(cross), 1) - 1) < 1e-12_real64), 'along x or y')
        end associate
        call options%create()
        call options%set(AMST_OPT_SMOOTH_STEPS, 0)
        call mesh%compute_cross_field(options)
        call claim(mesh%alignment() < 1e-9_real64, 'without sweeps, too')
        call claim(mesh%revision() == 0, 'the same revision')
        call mesh%destroy()
        call mesh%compute_cross_field(stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'a mesh destroyed')
    end subroutine it_follows_the_boundary

    subroutine it_can_be_given()
        type(amst_mesh) :: mesh
        real(real64), parameter :: angle = acos(-1.0_real64)/6
        real(real64) :: cross(3, 12)
        integer(int32) :: stat
        character(len=200) :: errmsg

        call new_grid(mesh, context, 2, 2)
        cross = spread([cos(angle), sin(angle), 0.0_real64], 2, 12)
        call mesh%set_field(AMST_FACE, 'cross', cross(:, :4), AMST_CARRY_INHERIT)
        call claim(abs(mesh%alignment() - 30) < 1e-9_real64, '30 degrees')
        call mesh%set_field(AMST_FACE, 'cross', cross(1, :4), AMST_CARRY_INHERIT, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'one number')
        call mesh%set_field(AMST_EDGE, 'cross', cross, AMST_CARRY_INHERIT, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'edges')
        call claim(abs(mesh%alignment() - 30) < 1e-9_real64, 'still 30 degrees')
    end subroutine it_can_be_given

end program cross_field_test
