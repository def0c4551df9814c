program mesh_test
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    type(amst_context) :: context

    call context%create()
    call layouts_agree()
    call triangles_become_quads()
    call bad_input_is_refused()
    call queries_differ()
    call arrays_of_the_caller()
    call edges_are_found()
    call points_may_change()
    call a_cube_is_all_singular()
    call flags_are_kept()
    call markers_have_names()
    call features_are_flagged()
    call metrics_have_their_values()
    call savepoints_nest()
    call files_come_back()
    call finish()

contains

    subroutine layouts_agree()
        integer, parameter :: nx = 4, ny = 3, nv = 20, nf = 12
        type(amst_mesh) :: packed, mesh
        real(real64) :: points(2, nv), wide(3, 2*nv)
        integer(int32) :: faces(4, nf)
        integer(int64) :: digest

        points = grid_points(nx, ny)
        faces = grid_faces(nx, ny)
        call packed%create(context, points, faces)
        digest = packed%checksum()
        call mesh%create(context, points, int(faces, int64))
        call claim(mesh%checksum() == digest, 'faces of 64 bits')
        ! sections: every other column, without the last row, and backwards in both extents
        wide = ieee_value(0.0_real64, ieee_quiet_nan)
        wide(1:2, 1:2*nv:2) = points
        call mesh%create(context, wide(1:2, 1::2), faces)
        call claim(mesh%checksum() == digest, 'a section of points')
        wide(2:1:-1, 2*nv:1:-2) = points
        call mesh%create(context, wide(2:1:-1, 2*nv:1:-2), faces(:, :))
        call claim(mesh%checksum() == digest, 'a section with strides below 0')
        ! one vertex a row, one face a row
        call mesh%create_strided(context, 2, transpose(points), 20_int64, 1_int64, 20_int64, &
            transpose(faces), 12_int64, 1_int64, 12_int64)
        call claim(mesh%checksum() == digest, 'points(n, dim)')
        wide = ieee_value(0.0_real64, ieee_quiet_nan)
        wide(1:2, 1:2*nv:2) = points
        call mesh%create_strided_int64(context, 2, wide, 20_int64, 6_int64, 1_int64, &
            int(faces, int64), 12_int64, 0_int64, 0_int64)
        call claim(mesh%checksum() == digest, 'padded points, packed faces of 64 bits')
    end subroutine layouts_agree

    subroutine triangles_become_quads()
        type(amst_options) :: options
        type(amst_mesh) :: mesh

        call mesh%create(context, grid_points(1, 1), reshape([1, 2, 4, 1, 4, 3], [3, 2]))
        call claim(mesh%count(AMST_FACE) == 1, 'two triangles are a quad')
        call claim(mesh%count(AMST_VERTEX) == 4, 'of their vertices')
        call mesh%create(context, grid_points(1, 1), reshape([1_int64, 2_int64, 4_int64, 0_int64, &
            1_int64, 4_int64, 3_int64, 0_int64], [4, 2]))
        call claim(mesh%count(AMST_FACE) == 1, 'triangles as four corners')
        call options%create()
        call options%set(AMST_OPT_QUADRANGULATE, 1)
        call mesh%create(context, grid_points(1, 1), reshape([1, 2, 4, 1, 4, 3], [3, 2]), options)
        call claim(mesh%count(AMST_FACE) == 6, 'split triangles')
        call claim(mesh%count(AMST_VERTEX) == 11, 'vertices of split triangles')
    end subroutine triangles_become_quads

    subroutine bad_input_is_refused()
        type(amst_mesh) :: mesh
        real(real64) :: points(2, 4)
        integer(int32) :: stat, entity, id
        character(len=200) :: errmsg

        points = grid_points(1, 1)
        call mesh%create(context, points, reshape([1, 2, 4, 3], [4, 1]))
        call mesh%create(context, points, reshape([1, 2, 4, 5], [4, 1]), stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'corner 5')
        call alphamst_last_error_where(entity, id)
        call claim(entity == AMST_FACE .and. id == 1, 'place of a corner')
        call claim(mesh%exists(), 'a failed create leaves the mesh there was')
        call mesh%create(context, points, reshape([0, 1, 2, 3], [4, 1]), stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'corner 0')
        call mesh%create(context, points, reshape([1_int64, 2_int64, 4_int64, 2_int64**32 + 3], [4, 1]), &
            stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'corner 2^32 + 3')
        call mesh%create(context, points, reshape([1, 2, 4, 1], [4, 1]), stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NOT_QUAD, errmsg, 'a corner twice')
        call mesh%create(context, points, reshape([1, 2], [2, 1]), stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'two corners')
        call mesh%create(context, points(1:1, :), reshape([1, 2, 4, 3], [4, 1]), stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'one coordinate')
        call mesh%create(context, points, reshape([integer(int32) ::], [4, 0]), stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'no face')
        points(2, 3) = ieee_value(0.0_real64, ieee_quiet_nan)
        call mesh%create(context, points, reshape([1, 2, 4, 3], [4, 1]), stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NOT_FINITE, errmsg, 'a NaN')
        call alphamst_last_error_where(entity, id)
        call claim(entity == AMST_VERTEX .and. id == 3, 'place of a NaN')
    end subroutine bad_input_is_refused

    subroutine queries_differ()
        type(amst_mesh) :: mesh
        integer(int32) :: stat
        integer(int64) :: count
        character(len=200) :: errmsg

        call new_grid(mesh, context, 4, 3)
        call claim(mesh%dim() == 2, 'dim')
        call claim(mesh%count(AMST_VERTEX) == 20, 'vertices')
        call claim(mesh%count(AMST_EDGE) == 31, 'edges')
        call claim(mesh%count(AMST_FACE) == 12, 'faces')
        call claim(mesh%revision() == 0, 'revision')
        call mesh%check()
        count = mesh%count(7, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'entity 7')
        call claim(count == 0, 'a failed count')
        call claim(all(shape(mesh%points()) == [2, 20]), 'shape of points')
        call claim(maxval(abs(mesh%points() - grid_points(4, 3))) <= 0, 'points')
        call claim(all(shape(mesh%faces()) == [4, 12]), 'shape of faces')
        call claim(all(mesh%faces() == grid_faces(4, 3)), 'faces')
        associate (edges => mesh%edges(), sides => mesh%edge_faces(), faces => mesh%faces())
            call claim(all(shape(edges) == [2, 31]), 'shape of edges')
            call claim(all(shape(sides) == [2, 31]), 'shape of edge_faces')
            call claim(all(edges(1, :) < edges(2, :)), 'smaller vertex first')
            call claim(minval(edges) == 1 .and. maxval(edges) == 20, 'edges from 1')
            call claim(minval(sides) == 0 .and. maxval(sides) == 12, 'faces of edges from 1')
            call claim(count_sides(edges, sides, faces) == 48, 'left and right')
            call claim(all(mesh%find_edges(edges) == [(stat, stat=1, 31)]), 'every edge is found')
        end associate
        call claim(all(mesh%valences() == [2, 3, 3, 3, 2, 3, 4, 4, 4, 3, 3, 4, 4, 4, 3, 2, 3, 3, 3, 2]), 'valences')
        call claim(size(mesh%singularities()) == 0, 'singularities')
    end subroutine queries_differ

    !> How often the left face runs along an edge and the right one back; one alone is the first.
    function count_sides(edges, sides, faces) result(n)
        integer(int32), intent(in) :: edges(:, :), sides(:, :), faces(:, :)
        integer :: n, e, side

        n = 0
        do e = 1, size(edges, 2)
            do side = 1, 2
                if (sides(side, e) == 0) cycle
                associate (corners => faces(:, sides(side, e)), v => edges(side, e), w => edges(3 - side, e))
                    n = n + count(corners == v .and. cshift(corners, 1) == w)
                    if (sides(2, e) == 0) n = n + count(corners == w .and. cshift(corners, 1) == v)
                end associate
            end do
        end do
    end function count_sides

    subroutine arrays_of_the_caller()
        type(amst_mesh) :: mesh
        real(real64) :: points(2, 20), more_points(2, 25), solid(3, 20), quality(12)
        integer(int32) :: faces(4, 12), pairs(2, 31), row(31), wide(8, 12), stat
        integer(int64) :: n
        character(len=200) :: errmsg

        call new_grid(mesh, context, 4, 3)
        call mesh%get_points(points)
        call claim(maxval(abs(points - grid_points(4, 3))) <= 0, 'points in place')
        more_points = -7
        call mesh%get_points(more_points, n)
        call claim(n == 20 .and. all(abs(more_points(:, 21:) + 7) <= 0), 'points into a larger array')
        call claim(maxval(abs(more_points(:, :20) - points)) <= 0, 'the first columns')
        points = -7
        call mesh%get_points(points(:, :19), n, stat, errmsg)
        call refused(stat, AMST_ERR_BUFFER_TOO_SMALL, errmsg, 'room for 19 points')
        call claim(n == 20 .and. all(abs(points + 7) <= 0), 'nothing is written')
        call mesh%get_points(solid, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'three rows for two coordinates')
        call mesh%get_faces(faces)
        call claim(all(faces == grid_faces(4, 3)), 'faces in place')
        wide = 0
        call mesh%get_faces(wide(1::2, :))
        call claim(all(wide(1::2, :) == faces), 'faces into a section')
        call mesh%get_faces(wide, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'eight rows for four corners')
        call mesh%get_faces(faces(:, 2:), stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_BUFFER_TOO_SMALL, errmsg, 'room for 11 faces')
        call mesh%get_edges(pairs, n)
        call claim(all(pairs == mesh%edges()) .and. n == 31, 'edges in place')
        call mesh%get_edge_faces(pairs, n)
        call claim(all(pairs == mesh%edge_faces()) .and. n == 31, 'faces of edges in place')
        call mesh%get_valences(row, n)
        call claim(all(row(:20) == mesh%valences()) .and. n == 20, 'valences in place')
        call mesh%get_valences(row(:19), stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_BUFFER_TOO_SMALL, errmsg, 'room for 19 valences')
        call mesh%get_singularities(row, n)
        call claim(n == 0, 'no singularities in place')
        call mesh%get_flags(AMST_EDGE, row, n)
        call claim(n == 31 .and. all(row == 0), 'flags in place')
        call mesh%get_quality(AMST_METRIC_MAX_ANGLE, quality)
        call claim(all(abs(quality - 90) < 1e-12_real64), 'quality in place')
        call mesh%get_quality(AMST_METRIC_AREA, quality(:3), n, stat, errmsg)
        call refused(stat, AMST_ERR_BUFFER_TOO_SMALL, errmsg, 'room for 3 areas')
        call claim(n == 12, 'room that is needed')
        call mesh%destroy()
        call claim(size(mesh%faces(stat, errmsg)) == 0, 'an array of no mesh')
        call refused(stat, AMST_ERR_NULL, errmsg, 'a mesh destroyed')
    end subroutine arrays_of_the_caller

    subroutine edges_are_found()
        type(amst_mesh) :: mesh
        integer(int32) :: found(3), stat, id
        character(len=200) :: errmsg

        call new_grid(mesh, context, 4, 3)
        found = mesh%find_edges(reshape([2, 1, 1, 7, 4, 4], [2, 3])) ! turned round, diagonal, no pair
        call claim(found(1) > 0 .and. all(found(2:) == 0), 'edges, and none')
        associate (edges => mesh%edges())
            call claim(all(edges(:, found(1)) == [1, 2]), 'the edge that was asked for')
        end associate
        call claim(size(mesh%find_edges(reshape([integer(int32) ::], [2, 0]))) == 0, 'no pairs')
        found = 77
        call mesh%get_found_edges(reshape([1, 2, 1, 21, 1, 6], [2, 3]), found, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'vertex 21')
        call alphamst_last_error_where(id=id)
        call claim(id == 21 .and. all(found == 77), 'nothing is written')
        call mesh%get_found_edges(reshape([1, 2, 1, 2], [2, 2]), found, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'two pairs, three results')
        call claim(size(mesh%find_edges(reshape([1, 2, 3], [3, 1]), stat, errmsg)) == 1, 'size')
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'pairs of three')
    end subroutine edges_are_found

    subroutine points_may_change()
        type(amst_mesh) :: mesh
        real(real64) :: points(2, 20)
        integer(int64) :: digest
        integer(int32) :: stat, entity, id
        character(len=200) :: errmsg

        call new_grid(mesh, context, 4, 3)
        digest = mesh%checksum()
        points = grid_points(4, 3)
        points(1, 7) = 1.25_real64
        call mesh%set_points(points)
        call claim(maxval(abs(mesh%points() - points)) <= 0, 'new points')
        call claim(mesh%checksum() /= digest, 'another checksum')
        call claim(mesh%revision() == 0, 'the same revision')
        points(1, 7) = 40
        call mesh%set_points(points)
        call mesh%check(stat, errmsg)
        call claim(stat < 0 .and. errmsg /= '', 'a face turned over is a fault')
        call alphamst_last_error_where(entity, id)
        call claim(entity == AMST_FACE .and. id >= 1 .and. id <= 6, 'place of the fault')
        call mesh%set_points(points(:, :19), stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, '19 points')
        call mesh%set_points(points(:1, :), stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'points of one coordinate')
    end subroutine points_may_change

    subroutine a_cube_is_all_singular()
        type(amst_mesh) :: mesh
        real(real64) :: points(3, 8)
        integer(int32) :: k, row(8), stat
        integer(int64) :: n
        character(len=200) :: errmsg

        points = reshape(real([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1], real64), [3, 8])
        call mesh%create(context, points, 1 + reshape([0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, &
            0, 4, 6, 2, 1, 3, 7, 5], [4, 6]))
        call claim(mesh%dim() == 3, 'dim 3')
        call claim(maxval(abs(mesh%points() - points)) <= 0, 'three coordinates')
        call claim(all(mesh%singularities() == [(k, k=1, 8)]), 'all corners are singular')
        call claim(all(mesh%valences() == 3), 'all valences are 3')
        call mesh%get_singularities(row, n)
        call claim(n == 8 .and. all(row == [(k, k=1, 8)]), 'singularities in place')
        call mesh%get_singularities(row(:7), n, stat, errmsg)
        call refused(stat, AMST_ERR_BUFFER_TOO_SMALL, errmsg, 'room for 7 of 8')
    end subroutine a_cube_is_all_singular

    subroutine markers_have_names()
        type(amst_mesh) :: mesh, back
        integer(int32) :: stat, row(31)
        integer(int64) :: n
        character(len=200) :: errmsg
        character(len=*), parameter :: path = 'fortran_markers.msh'

        call new_grid(mesh, context, 4, 3)
        call mesh%set_markers(AMST_EDGE, [1, 2], 7)
        call mesh%set_markers(AMST_EDGE, [integer(int32) ::], 9)
        call mesh%set_markers(AMST_FACE, 20)
        call mesh%set_markers(AMST_FACE, [12], -1)
        call mesh%set_markers(AMST_VERTEX, [8], 77)
        call mesh%get_markers(AMST_EDGE, row, n)
        call claim(n == 31 .and. all(row(:2) == 7) .and. all(row(3:) == 0), 'markers of edges')
        associate (regions => mesh%markers(AMST_FACE))
            call claim(size(regions) == 12 .and. all(regions(:11) == 20) .and. regions(12) == -1, 'regions')
        end associate
        call claim(all(mesh%marker_list(AMST_FACE) == [-1, 20]), 'regions in use')
        call claim(size(mesh%marker_list(AMST_VERTEX)) == 1, 'points in use')
        associate (flags => mesh%flags(AMST_VERTEX))
            call claim(flags(8) == AMST_FLAG_CORNER, 'a point is a corner')
        end associate
        call mesh%set_marker_name(AMST_EDGE, 7, 'wall to the left  ')
        call mesh%set_marker_name(AMST_VERTEX, 77, 'well')
        call mesh%write(path)
        call back%read(context, path)
        call claim(back%checksum() == mesh%checksum(), 'markers come back from a file')
        call claim(back%marker_name(AMST_EDGE, 7) == 'wall to the left', 'and so do names')
        call claim(len(back%marker_name(AMST_EDGE, 7)) == 16, 'without blanks behind them')
        call claim(back%marker_name(AMST_EDGE, 8) == '', 'no name')
        call back%set_marker_name(AMST_EDGE, 7, '')
        call claim(len(back%marker_name(AMST_EDGE, 7)) == 0, 'a name is taken away')
        call mesh%set_markers(AMST_VERTEX, [21], 1, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'a vertex beyond the last')
        call mesh%set_marker_name(AMST_EDGE, 0, 'none', stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'the name of no marker')
        call claim(mesh%marker_name(9, 1, stat, errmsg) == '', 'a name of no entity')
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'no entity')
        open (newunit=row(1), file=path)
        close (row(1), status='delete')
    end subroutine markers_have_names

    subroutine flags_are_kept()
        type(amst_mesh) :: mesh
        integer(int32) :: stat
        character(len=200) :: errmsg

        call new_grid(mesh, context, 4, 3)
        call mesh%set_flags(AMST_VERTEX, [1, 5], AMST_FLAG_CORNER, AMST_FLAG_CORNER)
        call mesh%set_flags(AMST_FACE, AMST_FLAG_FIXED + AMST_FLAG_FEATURE, AMST_FLAG_FEATURE)
        call claim(all(mesh%flags(AMST_VERTEX) == [4, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]), &
            'flags of vertices')
        associate (faces => mesh%flags(AMST_FACE))
            call claim(size(faces) == 12 .and. all(faces == AMST_FLAG_FEATURE), 'flags of all faces')
        end associate
        call mesh%set_flags(AMST_VERTEX, [integer(int32) ::], AMST_FLAG_FIXED, AMST_FLAG_FIXED)
        call claim(count(mesh%flags(AMST_VERTEX) /= 0) == 2, 'no ids are not all ids')
        call mesh%set_flags(AMST_VERTEX, [21], AMST_FLAG_FIXED, AMST_FLAG_FIXED, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'vertex 21')
        call mesh%set_flags(AMST_VERTEX, 64, 64, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'bits that are no flag')
        call claim(size(mesh%flags(9, stat, errmsg)) == 0, 'flags of no entity')
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'entity 9')
    end subroutine flags_are_kept

    ! Folded upwards by 45 degrees from the third column of vertices on.
    subroutine features_are_flagged()
        type(amst_mesh) :: mesh
        real(real64) :: points(3, 20)
        integer(int32) :: stat, e
        integer(int64) :: found
        character(len=200) :: errmsg

        points(:2, :) = grid_points(4, 3)
        points(3, :) = max(points(1, :) - 2, 0.0_real64)
        call mesh%create(context, points, grid_faces(4, 3))
        found = -1
        call mesh%detect_features(46.0_real64, found)
        call claim(found == 0, 'no edge at more than 46 degrees')
        call claim(all(mesh%flags(AMST_EDGE) == 0), 'so none is flagged')
        call mesh%detect_features(44.0_real64)
        call mesh%detect_features(44.0_real64, found)
        call claim(found == 3, 'three edges at more than 44 degrees')
        associate (flags => mesh%flags(AMST_EDGE), edges => mesh%edges())
            do e = 1, 31
                call claim((flags(e) == AMST_FLAG_FEATURE) .eqv. all(mod(edges(:, e), 5) == 3), 'those of the fold')
            end do
        end associate
        associate (flags => mesh%flags(AMST_VERTEX))
            call claim(count(flags /= 0) == 2 .and. all(flags([3, 18]) == AMST_FLAG_CORNER), 'ends of the fold')
        end associate
        call mesh%detect_features(181.0_real64, found, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, '181 degrees')
        call mesh%detect_features(ieee_value(0.0_real64, ieee_quiet_nan), stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NOT_FINITE, errmsg, 'an angle that is no number')
    end subroutine features_are_flagged

    subroutine metrics_have_their_values()
        type(amst_mesh) :: mesh
        type(amst_summary) :: summary
        real(real64), parameter :: ideal(0:19) = &
            real([1, 1, 1, 1, 1, 1, 90, 90, 0, 1, 1, 1, 1, 1, 1, 1, 0, 1, 0, 1], real64)
        real(real64) :: points(2, 10)
        integer(int32) :: stat, metric
        character(len=200) :: errmsg

        call new_grid(mesh, context, 3, 2)
        do metric = 0, 19
            summary = mesh%summary(metric)
            call claim(abs(summary%min - ideal(metric)) < 1e-12_real64, 'metric of squares')
            call claim(abs(summary%max - ideal(metric)) < 1e-12_real64, 'largest metric of squares')
            call claim(maxval(abs(mesh%quality(metric) - ideal(metric))) < 1e-12_real64, 'metric of each square')
        end do
        points = grid_points(4, 1)
        points(1, :) = points(1, :)**2
        call mesh%create(context, points, grid_faces(4, 1))
        call claim(maxval(abs(mesh%quality(AMST_METRIC_AREA) - [1, 3, 5, 7])) < 1e-12_real64, 'areas')
        call claim(maxval(abs(mesh%quality(AMST_METRIC_EDGE_RATIO) - [1, 3, 5, 7])) < 1e-12_real64, 'edge ratios')
        summary = mesh%summary(AMST_METRIC_AREA)
        call claim(summary%count == 4 .and. summary%acceptable == 4, 'counts of a summary')
        call claim(abs(summary%min - 1) + abs(summary%max - 7) < 1e-12_real64, 'extremes of a summary')
        call claim(abs(summary%mean - 4) + abs(summary%stddev - sqrt(5.0_real64)) < 1e-12_real64, 'mean and stddev')
        summary = mesh%summary(20, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'summary of metric 20')
        call claim(size(mesh%quality(20, stat, errmsg)) == 0, 'values of metric 20')
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'metric 20')
    end subroutine metrics_have_their_values

    subroutine savepoints_nest()
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        integer(int64) :: first, second, before, between
        integer(int32) :: stat
        character(len=200) :: errmsg

        call new_grid(mesh, context, 8, 8)
        before = mesh%checksum()
        call mesh%mark(first)
        call claim(first == mesh%revision(), 'a savepoint is named by the revision')
        call patches%create(mesh)
        call patches%add_faces(square(8, 2, 6))
        call alphamst_adapt(mesh, patches, 2.0_real64)
        between = mesh%checksum()
        call mesh%mark(second)
        call claim(second > first, 'the revision rises')
        call alphamst_reduce_singularities(mesh, patches)
        call mesh%rollback(second)
        call claim(mesh%checksum() == between, 'back to the second savepoint')
        call mesh%rollback(first)
        call claim(mesh%checksum() == before, 'back to the first savepoint')
        call claim(mesh%revision() == first, 'and to its revision')
        call mesh%rollback(second, stat, errmsg)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'a later savepoint')
        call mesh%forget(first)
        call mesh%forget(first, stat, errmsg)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'a savepoint given up')
    end subroutine savepoints_nest

    subroutine files_come_back()
        type(amst_mesh) :: mesh, copy
        type(amst_options) :: options
        integer(int32) :: stat
        integer :: unit
        character(len=200) :: errmsg

        call new_grid(mesh, context, 4, 3)
        call options%create()
        call mesh%write('mesh_test.vtk')
        call copy%read(context, 'mesh_test.vtk   ', options)
        call claim(copy%checksum() == mesh%checksum(), 'a file comes back')
        call copy%read(context, 'no such file.vtk', stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_IO, errmsg, 'a file that is not there')
        call mesh%write('mesh_test.xyz', stat, errmsg)
        call refused(stat, AMST_ERR_UNSUPPORTED, errmsg, 'a format that is unknown')
        open (newunit=unit, file='mesh_test.vtk')
        close (unit, status='delete')
    end subroutine files_come_back

end program mesh_test
