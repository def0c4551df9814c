program operations_test
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    type(amst_context) :: context

    call context%create()
    call adapt_reports_what_it_did()
    call origins_fit()
    call reduce_makes_a_grid_again()
    call without_patches_the_whole_mesh()
    call smooth_moves_the_inside()
    call clean_removes_a_doublet()
    call partial_is_a_success()
    call errors()
    call finish()

contains

    subroutine adapt_reports_what_it_did()
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        type(amst_report) :: report
        type(amst_options) :: options
        integer(int32) :: stat
        integer(int64) :: singular, value
        character(len=200) :: errmsg

        call options%create()
        call new_grid(mesh, context, 10, 10)
        call patches%create(mesh)
        call patches%add_faces(square(10, 2, 8))
        call alphamst_adapt(mesh, patches, 1.5_real64, options, report, stat, errmsg)
        call claim(stat == AMST_OK, 'adapt')
        call mesh%check()
        singular = size(mesh%singularities())
        call claim(mesh%count(AMST_FACE) == 118, 'faces of the mesh')
        call claim(size(patches%faces(1)) == 54, 'the set moves along')
        call claim(report%get_int(AMST_RESULT_STATUS, 1) == AMST_OK, 'status')
        call claim(report%get_int(AMST_RESULT_FACES_BEFORE, 1) == 36, 'before')
        call claim(report%get_int(AMST_RESULT_FACES_AFTER, 1) == 54, 'after')
        call claim(report%get_int(AMST_RESULT_FACES_WANTED) == 54, 'wanted, of all')
        call claim(report%get_int(AMST_RESULT_SINGULAR_BEFORE) == 0, 'singular before')
        call claim(report%get_int(AMST_RESULT_SINGULAR_AFTER) == singular .and. singular > 0, 'singular after')
        call claim(report%get_int(AMST_RESULT_SINGULAR_BOUND, 1) == 0, 'bound')
        call claim(report%get_int(AMST_RESULT_CANDIDATE, 1) >= 0, 'candidate')
        call claim(report%get_int(AMST_RESULT_UNUSED_OPTION) == -1, 'no option without effect')
        call claim(abs(report%get_real(AMST_RESULT_ALPHA) - 1.5_real64) <= 0, 'alpha')
        call claim(abs(report%get_real(AMST_RESULT_QUALITY_BEFORE, 1) - 1) < 1e-12_real64, 'quality before')
        call claim(report%get_real(AMST_RESULT_QUALITY_AFTER, 1) < 1, 'quality after')
        call claim(report%get_real(AMST_RESULT_SECONDS) >= 0, 'seconds')
        call claim(report%get_real(AMST_RESULT_SIZE_ERROR_AFTER) < report%get_real(AMST_RESULT_SIZE_ERROR_BEFORE), &
            'size error')
        call claim(report%get_real(AMST_RESULT_LEAST_AREA_AFTER, 1) > 0.125_real64, 'least area after')
        call claim(report%get_real(AMST_RESULT_LEAST_AREA_BEFORE, 1) > 0.9_real64, 'least area before')
        call claim(report%get_real(AMST_RESULT_TIME_STEP) < 1, 'time step')
        call claim(report%get_real(AMST_RESULT_SHORTEST_EDGE_AFTER, 1) > 0.2_real64, 'shortest edge after')
        call claim(report%get_real(AMST_RESULT_SHORTEST_EDGE_BEFORE, 1) > 0.9_real64, 'shortest edge before')
        call claim(abs(report%get_real(AMST_RESULT_ASPECT_RATIO_BEFORE) - 1) < 1e-12_real64, &
            'aspect ratio before')
        call claim(report%get_real(AMST_RESULT_ASPECT_RATIO_AFTER) > 1, 'aspect ratio after')
        call claim(report%valence(4, .false.) == 81, 'valence 4 before')
        call claim(report%valence(3, .true.) + report%valence(5, .true.) == singular, 'valences 3 and 5 after')
        call claim(report%valence(3, .false., 1) == 0, 'valence 3 before')
        value = report%get_int(AMST_RESULT_ALPHA, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'alpha as an integer')
        value = report%get_int(AMST_RESULT_STATUS, 2, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'patch 2')
        call claim(value == 0, 'a failed function is 0')
        value = int(report%get_real(AMST_RESULT_STATUS, 1, stat, errmsg), int64)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'the status as a real number')
        value = report%valence(4, .true., 2, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'valence in patch 2')
    end subroutine adapt_reports_what_it_did

    subroutine origins_fit()
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        type(amst_report) :: report
        integer(int32), allocatable :: row(:)
        integer(int64) :: n
        integer(int32) :: stat
        character(len=200) :: errmsg

        call new_grid(mesh, context, 8, 8)
        call patches%create(mesh)
        call patches%add_faces(square(8, 2, 6))
        call alphamst_adapt(mesh, patches, 2.0_real64, report=report)
        associate (vertices => report%origin(AMST_VERTEX), edges => report%origin(AMST_EDGE), &
                faces => report%origin(AMST_FACE))
            call claim(size(vertices) == mesh%count(AMST_VERTEX), 'an origin of each vertex')
            call claim(size(edges) == mesh%count(AMST_EDGE), 'an origin of each edge')
            call claim(size(faces) == mesh%count(AMST_FACE), 'an origin of each face')
            call claim(count(faces == 0) == 32 .and. maxval(faces) == 64, 'new faces have none')
            call claim(count(vertices /= 0) == 81 - 9, 'vertices inside are gone')
            call claim(count(edges /= 0) == 144 - 24, 'edges inside are gone')
            allocate (row(size(vertices)))
            call report%get_origin(AMST_VERTEX, row, n)
            call claim(n == size(row) .and. all(row == vertices), 'origin in place')
        end associate
        call report%get_origin(AMST_VERTEX, row(2:), n, stat, errmsg)
        call refused(stat, AMST_ERR_BUFFER_TOO_SMALL, errmsg, 'room for one less')
        call claim(size(report%origin(5, stat, errmsg)) == 0, 'origin of no entity')
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'entity 5')
    end subroutine origins_fit

    subroutine reduce_makes_a_grid_again()
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        type(amst_report) :: report

        call new_grid(mesh, context, 10, 10)
        call patches%create(mesh)
        call patches%add_faces(square(10, 2, 7))
        call alphamst_adapt(mesh, patches, 2.0_real64)
        call claim(size(mesh%singularities()) >= 4, 'singular after adapt')
        call alphamst_reduce_singularities(mesh, patches, report=report)
        call claim(size(mesh%singularities()) == 0, 'regular again')
        call claim(mesh%count(AMST_FACE) == 100, 'as many faces as at first')
        call claim(report%get_int(AMST_RESULT_FACES_BEFORE, 1) == 50, 'before')
        call claim(report%get_int(AMST_RESULT_FACES_AFTER, 1) == 25, 'after')
    end subroutine reduce_makes_a_grid_again

    subroutine without_patches_the_whole_mesh()
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches, none
        type(amst_report) :: report
        integer(int32) :: stat
        integer :: singular
        character(len=200) :: errmsg

        call new_grid(mesh, context, 10, 10)
        call patches%create(mesh)
        call patches%add_faces(square(10, 2, 7))
        call alphamst_adapt(mesh, patches, 2.0_real64)
        call alphamst_adapt(mesh, alpha=1.2_real64, report=report)
        call claim(report%get_int(AMST_RESULT_FACES_BEFORE) == 125, 'whole before')
        call claim(mesh%count(AMST_FACE) == 150, 'whole after')
        singular = size(mesh%singularities())
        call alphamst_reduce_singularities(mesh, report=report)
        call claim(size(mesh%singularities()) <= singular, 'no more singularities')
        call claim(report%get_int(AMST_RESULT_SINGULAR_BEFORE) == singular, 'singular before')
        call alphamst_adapt(mesh, none, 2.0_real64, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'adapt: patches never created are not the whole mesh')
        call alphamst_reduce_singularities(mesh, none, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'reduce: patches never created are not the whole mesh')
    end subroutine without_patches_the_whole_mesh

    subroutine smooth_moves_the_inside()
        type(amst_mesh) :: mesh, whole
        type(amst_patches) :: patches
        type(amst_report) :: report
        type(amst_options) :: options
        real(real64) :: points(2, 81), after(2, 81)
        type(amst_summary) :: before

        points = grid_points(8, 8)
        points(:, 41) = points(:, 41) + [0.35_real64, -0.3_real64]
        points(:, 21) = points(:, 21) + [0.35_real64, -0.3_real64]
        call mesh%create(context, points, grid_faces(8, 8))
        whole = mesh
        before = mesh%summary(AMST_METRIC_SCALED_JACOBIAN)
        call patches%create(mesh)
        call patches%add_faces(square(8, 3, 5)) ! only vertex 41 is inside
        call alphamst_smooth(mesh, patches, report=report)
        call mesh%get_points(after)
        call claim(any(abs(after(:, 41) - points(:, 41)) > 0), 'inside moves')
        call claim(all(abs(after(:, 21) - points(:, 21)) <= 0), 'outside stays')
        call claim(report%get_int(AMST_RESULT_FACES_AFTER, 1) == 4, 'report of a patch')

        call options%create()
        call options%set(AMST_OPT_SMOOTH_STEPS, 0)
        call alphamst_smooth(whole, options=options)
        call claim(maxval(abs(whole%points() - points)) <= 0, 'no steps, no moves')
        call alphamst_smooth(whole, report=report)
        call whole%get_points(after)
        call claim(any(abs(after(:, 21) - points(:, 21)) > 0), 'the whole mesh moves')
        associate (better => whole%summary(AMST_METRIC_SCALED_JACOBIAN))
            call claim(better%min > before%min, 'and is better')
        end associate
        call claim(report%get_int(AMST_RESULT_FACES_AFTER) == 64, 'report of the mesh')
        call claim(whole%revision() == 0, 'the revision stays')
    end subroutine smooth_moves_the_inside

    subroutine clean_removes_a_doublet()
        type(amst_mesh) :: mesh
        type(amst_report) :: report
        real(real64) :: points(2, 65)
        integer(int32) :: faces(4, 50)

        points(:, :64) = grid_points(7, 7)
        points(:, 65) = 3.5_real64
        faces(:, :49) = grid_faces(7, 7)
        associate (middle => faces(:, 25))
            faces(:, 50) = [middle(1), 65, middle(3), middle(4)]
        end associate
        faces(4, 25) = 65
        call mesh%create(context, points, faces)
        call alphamst_clean(mesh, report=report)
        call mesh%check()
        call claim(mesh%revision() > 0, 'the revision rises')
        call claim(report%valence(2, .false.) == 1, 'a doublet before')
        call claim(report%valence(2, .true.) == 0, 'none after')
        call claim(report%get_int(AMST_RESULT_FACES_BEFORE) == 50, 'faces before')
        call claim(report%get_int(AMST_RESULT_FACES_AFTER) == mesh%count(AMST_FACE), 'faces after')
    end subroutine clean_removes_a_doublet

    subroutine partial_is_a_success()
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        integer(int32) :: stat
        character(len=200) :: errmsg

        call new_grid(mesh, context, 10, 10)
        call patches%create(mesh)
        call patches%add_faces(square(10, 2, 6))
        call mesh%set_flags(AMST_VERTEX, [1 + 4 + 4*11], AMST_FLAG_FIXED, AMST_FLAG_FIXED) ! in the middle
        errmsg = 'untouched'
        call alphamst_adapt(mesh, patches, 2.0_real64, stat=stat, errmsg=errmsg)
        call claim(stat == AMST_PARTIAL .and. errmsg == 'untouched', 'a patch with defects is left')
        call alphamst_adapt(mesh, patches, 2.0_real64)
        call claim(mesh%count(AMST_FACE) == 100, 'and does not stop the program')
    end subroutine partial_is_a_success

    subroutine errors()
        type(amst_mesh) :: mesh, other
        type(amst_patches) :: patches, stale, none
        type(amst_report) :: report
        integer(int32) :: stat
        integer(int64) :: before
        character(len=200) :: errmsg

        call new_grid(mesh, context, 8, 8)
        other = mesh
        before = mesh%checksum()
        call patches%create(mesh)
        call stale%create(mesh)
        call patches%add_faces(square(8, 2, 6))
        call stale%add_faces(square(8, 2, 6))
        call alphamst_adapt(mesh, patches, 0.0_real64, report=report, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'alpha 0')
        call claim(.not. report%exists(), 'no report')
        call alphamst_adapt(other, patches, 2.0_real64, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'patches of another mesh')
        call alphamst_reduce_singularities(other, patches, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'reduce patches of another mesh')
        call alphamst_smooth(other, patches, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'smooth patches of another mesh')
        call alphamst_smooth(mesh, none, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'patches never created are not the whole mesh')
        call claim(mesh%checksum() == before, 'the mesh is as before')
        call alphamst_adapt(mesh, patches, 2.0_real64)
        call alphamst_adapt(mesh, stale, 2.0_real64, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_STALE, errmsg, 'patches of an older revision')
        call other%destroy()
        call alphamst_clean(other, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'clean no mesh')
    end subroutine errors

end program operations_test
