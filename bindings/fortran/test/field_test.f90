program field_test
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    type(amst_context) :: context

    call context%create()
    call each_entity_has_fields_of_its_own()
    call arrays_of_the_caller()
    call an_operation_carries_them()
    call means_keep_their_range()
    call meshes_share_areas()
    call bad_input_is_refused()
    call finish()

contains

    subroutine each_entity_has_fields_of_its_own()
        type(amst_mesh) :: mesh, copy
        integer(int32), parameter :: entities(3) = [AMST_VERTEX, AMST_EDGE, AMST_FACE]
        integer, parameter :: counts(3) = [20, 31, 12]
        integer(int32) :: k, stat
        integer :: i, n
        real(real64) :: one(31), two(2, 31)
        character(len=200) :: errmsg

        call new_grid(mesh, context, 4, 3)
        do k = 1, 3
            n = counts(k)
            one = [(i + 0.5_real64, i=1, 31)]
            two = reshape([one, -one], [2, 31])
            call mesh%set_field(entities(k), 'height', one(:n), AMST_CARRY_INHERIT)
            call mesh%set_field(entities(k), 'velocity', two(:, :n), AMST_CARRY_DROP)
            call claim(same(mesh%field(entities(k), 'height'), reshape(one(:n), [1, n])), 'one number each')
            call claim(same(mesh%field(entities(k), 'velocity'), two(:, :n)), 'two numbers each')
            call mesh%set_field(entities(k), 'velocity', 2*two(:, :n), AMST_CARRY_DROP)
            call claim(same(mesh%field(entities(k), 'velocity'), 2*two(:, :n)), 'replaced')
        end do
        copy = mesh
        call mesh%remove_field(AMST_EDGE, 'height')
        call claim(size(mesh%field(AMST_EDGE, 'height', stat, errmsg)) == 0, 'removed')
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'a field that was removed')
        call claim(size(mesh%field(AMST_FACE, 'height')) == 12, 'that of another entity stays')
        call claim(size(copy%field(AMST_EDGE, 'height')) == 31, 'that of a copy stays')
        call mesh%remove_field(AMST_EDGE, 'height', stat, errmsg)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'to remove it again')
        call claim(mesh%revision() == 0, 'the revision stays')
    end subroutine each_entity_has_fields_of_its_own

    subroutine arrays_of_the_caller()
        type(amst_mesh) :: mesh
        real(real64) :: room(2, 6), wide(3, 6)
        integer(int64) :: n
        integer(int32) :: stat
        integer :: i
        character(len=200) :: errmsg

        call new_grid(mesh, context, 2, 2)
        call mesh%set_field(AMST_FACE, 'velocity', reshape([(real(i, real64), i=1, 8)], [2, 4]), AMST_CARRY_INHERIT)
        room = -1
        call mesh%get_field(AMST_FACE, 'velocity', room, n)
        call claim(n == 4 .and. same(room(:, :4), reshape([(real(i, real64), i=1, 8)], [2, 4])), 'filled in place')
        call claim(all(room(:, 5:) < 0), 'nothing beyond')
        call mesh%get_field(AMST_FACE, 'velocity', room(:, :3), n, stat, errmsg)
        call refused(stat, AMST_ERR_BUFFER_TOO_SMALL, errmsg, 'room for 3 of 4')
        call claim(n == 4, 'what it should have had')
        call mesh%get_field(AMST_FACE, 'velocity', wide, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'three components of two')
        call mesh%get_field(AMST_FACE, 'pressure', room, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'no such field')
    end subroutine arrays_of_the_caller

    subroutine an_operation_carries_them()
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        type(amst_report) :: report
        integer(int64) :: start
        integer(int32) :: stat
        integer :: i
        real(real64) :: sum_before
        character(len=200) :: errmsg

        call new_grid(mesh, context, 10, 10)
        call mesh%set_field(AMST_VERTEX, 'linear', linear(mesh%points()), AMST_CARRY_LINEAR)
        call mesh%set_field(AMST_FACE, 'mass', [(sin(real(i, real64)), i=1, 100)], AMST_CARRY_CONSERVE)
        call mesh%set_field(AMST_FACE, 'number', [(real(i, real64), i=1, 100)], AMST_CARRY_INHERIT)
        call mesh%set_field(AMST_EDGE, 'gone', [(1.0_real64, i=1, 220)], AMST_CARRY_DROP)
        sum_before = mass(mesh)
        call mesh%mark(start)
        call patches%create(mesh)
        call patches%add_faces(square(10, 2, 8))
        call alphamst_adapt(mesh, patches, 2.0_real64, report=report)
        associate (points => mesh%points(), values => mesh%field(AMST_VERTEX, 'linear'))
            call claim(maxval(abs(values(1, :) - linear(points))) < 1e-12_real64, 'a linear function is reproduced')
        end associate
        call claim(abs(mass(mesh) - sum_before) < 1e-12_real64, 'the sum of value and area stays')
        associate (number => mesh%field(AMST_FACE, 'number'), origin => report%origin(AMST_FACE))
            call claim(size(number, 2) == size(origin) .and. any(origin == 0), 'a value for each face')
            call claim(all(origin == 0 .or. abs(number(1, :) - origin) <= 0), 'faces that were kept keep theirs')
        end associate
        call claim(size(mesh%field(AMST_EDGE, 'gone', stat, errmsg)) == 0, 'dropped')
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'a field that was dropped')
        call mesh%rollback(start)
        call claim(size(mesh%field(AMST_EDGE, 'gone')) == 220, 'undone')
    end subroutine an_operation_carries_them

    subroutine means_keep_their_range()
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        integer, parameter :: entities(2) = [AMST_FACE, AMST_VERTEX], sizes(2) = [100, 121]
        integer :: i, k

        call new_grid(mesh, context, 10, 10)
        do k = 1, 2
            associate (values => [(sin(real(i, real64)), i=1, sizes(k))])
                call mesh%set_field(entities(k), 'linear', values, AMST_CARRY_CONSERVE)
                call mesh%set_field(entities(k), 'constant', values, AMST_CARRY_AVERAGE)
            end associate
        end do
        call patches%create(mesh)
        call patches%add_faces(square(10, 2, 8))
        call alphamst_adapt(mesh, patches, 2.0_real64)
        do k = 1, 2
            associate (one => mesh%field(entities(k), 'linear'), other => mesh%field(entities(k), 'constant'))
                call claim(.not. same(one, other), 'two orders')
                call claim(maxval(abs(one)) <= 1 .and. maxval(abs(other)) <= 1, 'the range is kept')
            end associate
        end do
    end subroutine means_keep_their_range

    subroutine meshes_share_areas()
        type(amst_mesh) :: mesh, old, curved
        type(amst_patches) :: patches
        integer(int32), allocatable :: before(:), after(:)
        real(real64), allocatable :: areas(:), sums(:)
        real(real64), parameter :: space(3, 4) = reshape([real(real64) :: 0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 1, 1], [3, 4])
        integer(int32) :: stat
        integer :: i
        character(len=200) :: errmsg

        call new_grid(mesh, context, 10, 10)
        call mesh%clone(old)
        call patches%create(mesh)
        call patches%add_faces(square(10, 2, 8))
        call alphamst_adapt(mesh, patches, 2.0_real64)
        call old%overlap(mesh, before, after, areas)
        call claim(size(before) == size(areas) .and. size(after) == size(areas), 'three arrays of one length')
        allocate (sums(mesh%count(AMST_FACE)), source=0.0_real64)
        do i = 1, size(areas)
            sums(after(i)) = sums(after(i)) + areas(i)
        end do
        call claim(maxval(abs(sums - mesh%quality(AMST_METRIC_AREA))) < 1e-12_real64, 'the areas of faces')
        call claim(minval(before) == 1 .and. maxval(before) == 100, 'ids count from 1')
        call curved%create(context, space, reshape([1, 2, 3, 4], [4, 1]))
        call old%overlap(curved, before, after, areas, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'another dim')
        call claim(size(areas) == 0, 'nothing is shared')
    end subroutine meshes_share_areas

    subroutine bad_input_is_refused()
        type(amst_mesh) :: mesh
        real(real64) :: values(9), nothing(0, 9)
        integer(int32) :: stat
        character(len=200) :: errmsg

        call new_grid(mesh, context, 2, 2)
        values = 1
        call mesh%set_field(AMST_VERTEX, 'a', values(:8), AMST_CARRY_DROP, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, '8 values of 9')
        call mesh%set_field(AMST_VERTEX, 'a', nothing, AMST_CARRY_DROP, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'no component')
        call mesh%set_field(AMST_VERTEX, '', values, AMST_CARRY_DROP, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'no name')
        call mesh%set_field(AMST_EDGE, 'a', [values, values(:3)], AMST_CARRY_AVERAGE, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'areas of edges')
        call mesh%set_field(AMST_FACE, 'size', values(:4), AMST_CARRY_INHERIT, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'size of faces')
        values(7) = 0
        call mesh%set_field(AMST_VERTEX, 'size', values, AMST_CARRY_LINEAR, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'a size of 0')
        values(7) = ieee_value(0.0_real64, ieee_quiet_nan)
        call mesh%set_field(AMST_VERTEX, 'a', values, AMST_CARRY_LINEAR, stat, errmsg)
        call refused(stat, AMST_ERR_NOT_FINITE, errmsg, 'no number')
        call claim(size(mesh%field(AMST_VERTEX, 'a', stat, errmsg)) == 0, 'nothing was set')
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'what was refused')
    end subroutine bad_input_is_refused

    function same(found, wanted)
        real(real64), intent(in) :: found(:, :), wanted(:, :)
        logical :: same

        same = all(shape(found) == shape(wanted))
        if (same) same = all(abs(found - wanted) <= 0)
    end function same

    function linear(points) result(values)
        real(real64), intent(in) :: points(:, :)
        real(real64) :: values(size(points, 2))

        values = 2 + points(1, :) - 3*points(2, :)
    end function linear

    function mass(mesh) result(total)
        type(amst_mesh), intent(in) :: mesh
        real(real64) :: total

        associate (values => mesh%field(AMST_FACE, 'mass'), areas => mesh%quality(AMST_METRIC_AREA))
            total = sum(values(1, :)*areas)
        end associate
    end function mass

end program field_test
