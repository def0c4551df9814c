program boundary_test
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    integer, parameter :: far_off = 3, unset = 4 ! below: the call that fails
    type(amst_context) :: context
    type(amst_options) :: options

    ! What the projection is told.
    type :: circle
        real(real64) :: radius = 1
        integer :: fault = 0, calls = 0
    end type circle

    call context%create()
    call options%create()
    call options%set(AMST_OPT_EDIT_BOUNDARY, 1)
    call new_vertices_lie_on_the_circle()
    call without_the_option_nobody_asks()
    call copies_keep_the_projection()
    call a_failing_projection_changes_nothing()
    call it_may_ask_and_destroy_but_not_change()
    call a_mesh_destroyed_has_none()
    call finish()

contains

    !> A square of 8 x 8 faces, bent to the disk of radius 1: 32 edges on its rim, and no corner.
    subroutine new_disk(mesh)
        type(amst_mesh), intent(inout) :: mesh
        real(real64) :: points(2, 81), most
        integer :: v

        points = grid_points(8, 8)/4 - 1
        do v = 1, 81
            most = maxval(abs(points(:, v)))
            points(:, v) = points(:, v)*(most**2/max(norm2(points(:, v)), tiny(most)) + (1 - most)*0.7_real64)
        end do
        call mesh%create(context, points, grid_faces(8, 8))
    end subroutine new_disk

    subroutine to_circle(markers, points, projected, failed, user)
        integer(int32), intent(in) :: markers(:)
        real(real64), intent(in) :: points(:, :)
        real(real64), intent(inout) :: projected(:, :)
        logical, intent(inout) :: failed
        class(*), pointer, intent(in) :: user
        integer :: i

        call claim(all(markers == 0) .and. size(markers) == size(points, 2), 'a marker for each point')
        call claim(all(shape(points) == shape(projected)) .and. size(points, 1) == 2, 'points of the plane')
        select type (user)
        type is (circle)
            user%calls = user%calls + 1
            failed = user%fault == user%calls
            if (user%fault == unset) return
            do i = 1, size(points, 2)
                projected(:, i) = user%radius*points(:, i)/norm2(points(:, i))
            end do
            if (user%fault == far_off) projected(:, 1) = 3
        end select
    end subroutine to_circle

    function radii(mesh) result(found)
        type(amst_mesh), intent(in) :: mesh
        real(real64), allocatable :: found(:)

        associate (points => mesh%points(), edges => mesh%edges(), sides => mesh%edge_faces())
            found = pack(norm2(points(:, edges(1, :)), dim=1), any(sides == 0, dim=1))
        end associate
    end function radii

    subroutine new_vertices_lie_on_the_circle()
        type(amst_mesh) :: mesh
        type(amst_report) :: report
        type(circle), target :: unit

        call new_disk(mesh)
        call mesh%set_projection(to_circle, unit)
        call alphamst_adapt(mesh, alpha=4.0_real64, options=options, report=report)
        ! What the chords had cut off the disk.
        call claim(report%get_real(AMST_RESULT_AREA_GAINED) > 0.01_real64, 'the domain grew')
        call mesh%check()
        call claim(mesh%count(AMST_FACE) == 256, 'four times the faces')
        call claim(size(radii(mesh)) > 48, 'vertices came')
        call claim(all(abs(radii(mesh) - 1) <= 1e-12_real64), 'all lie on the circle')
        call claim(unit%calls == 2, 'called twice')
        call mesh%set_projection()
        call alphamst_adapt(mesh, alpha=1.0_real64, options=options)
        call claim(unit%calls == 2, 'called no more')
    end subroutine new_vertices_lie_on_the_circle

    subroutine without_the_option_nobody_asks()
        type(amst_mesh) :: mesh
        type(circle), target :: unit

        call new_disk(mesh)
        call mesh%set_projection(to_circle, unit)
        call alphamst_adapt(mesh, alpha=4.0_real64)
        call claim(size(radii(mesh)) == 32 .and. unit%calls == 0, 'the boundary stays')
    end subroutine without_the_option_nobody_asks

    subroutine copies_keep_the_projection()
        type(amst_mesh) :: mesh, copy, clone
        type(circle), target :: unit, other

        call new_disk(mesh)
        call mesh%set_projection(to_circle, unit)
        copy = mesh
        call copy%clone(clone)
        copy = copy
        call mesh%set_projection(to_circle, other) ! of this one alone
        call alphamst_adapt(mesh, alpha=4.0_real64, options=options)
        call mesh%destroy()
        call alphamst_adapt(copy, alpha=4.0_real64, options=options)
        call copy%destroy()
        call alphamst_adapt(clone, alpha=4.0_real64, options=options)
        call claim(all(abs(radii(clone) - 1) <= 1e-12_real64), 'a copy of a copy is on the circle')
        call claim(unit%calls == 4 .and. other%calls == 2, 'each asks its own')
    end subroutine copies_keep_the_projection

    subroutine a_failing_projection_changes_nothing()
        type(amst_mesh) :: mesh
        type(circle), target :: unit
        integer(int64) :: digest
        integer(int32) :: stat
        character(len=300) :: errmsg
        integer :: fault

        call new_disk(mesh)
        digest = mesh%checksum()
        do fault = 1, unset
            unit = circle(fault=fault)
            call mesh%set_projection(to_circle, unit)
            call alphamst_adapt(mesh, alpha=4.0_real64, options=options, stat=stat, errmsg=errmsg)
            call claim(index(errmsg, 'projection') > 0, 'the sentence speaks of the projection')
            call refused(stat, AMST_ERR_PROJECTION, errmsg, 'a faulty projection')
            call claim(mesh%checksum() == digest, 'nothing has changed')
            call claim(mesh%revision() == 0, 'the same revision')
        end do
        unit = circle()
        call alphamst_adapt(mesh, alpha=4.0_real64, options=options)
        call claim(mesh%count(AMST_FACE) == 256, 'then it goes on')
    end subroutine a_failing_projection_changes_nothing

    subroutine it_may_ask_and_destroy_but_not_change()
        type(amst_mesh) :: mesh
        type(amst_mesh), target :: other
        integer(int32) :: stat

        call new_disk(mesh)
        call new_disk(other)
        call mesh%set_projection(meddle, other)
        call other%set_projection(meddle, other)
        call alphamst_adapt(mesh, alpha=4.0_real64, options=options)
        call claim(.not. other%exists(), 'the other mesh is gone')
        call new_disk(other)
        call other%set_projection(meddle, other)
        call alphamst_adapt(other, alpha=4.0_real64, options=options, stat=stat)
        call claim(.not. other%exists(), 'so is one whose operation ran')
    end subroutine it_may_ask_and_destroy_but_not_change

    recursive subroutine meddle(markers, points, projected, failed, user)
        integer(int32), intent(in) :: markers(:)
        real(real64), intent(in) :: points(:, :)
        real(real64), intent(inout) :: projected(:, :)
        logical, intent(inout) :: failed
        class(*), pointer, intent(in) :: user
        type(amst_mesh) :: copy
        integer(int32) :: stat
        integer :: i

        failed = size(markers) == 0
        do i = 1, size(points, 2)
            projected(:, i) = points(:, i)/norm2(points(:, i))
        end do
        select type (user)
        type is (amst_mesh)
            if (.not. user%exists()) return
            copy = user
            call claim(copy%count(AMST_FACE) == 64, 'it may ask')
            call user%set_projection(stat=stat)
            call claim(stat == AMST_ERR_STATE, 'not clear')
            call user%set_projection(meddle, stat=stat)
            call claim(stat == AMST_ERR_STATE, 'not set')
            call user%destroy()
        end select
    end subroutine meddle

    subroutine a_mesh_destroyed_has_none()
        type(amst_mesh) :: mesh
        integer(int32) :: stat
        character(len=200) :: errmsg

        call mesh%set_projection(to_circle, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'a mesh that is none')
        call mesh%set_projection(stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'nor has it one to clear')
    end subroutine a_mesh_destroyed_has_none

end program boundary_test
