!> Operations. Each changes the mesh or, on failure and on cancel, not at all. Patches with defects
!> are left and make stat AMST_PARTIAL. The patch set moves along. The report, if asked for, is new.
!> Errors: ARGUMENT (patches of another mesh), STALE, STATE, CANCELLED.
module alphamst_operations
    use, intrinsic :: iso_c_binding, only: c_null_ptr, c_ptr
    use, intrinsic :: iso_fortran_env, only: int32, real64
    use amst_c, only: AMST_ERR_NULL, AMST_OK, amst_adapt, amst_clean, amst_collapse_chord, &
        amst_insert_chords, amst_reduce_singularities, amst_smooth, amst_split_chord
    use alphamst_library, only: settle
    use alphamst_mesh, only: amst_mesh
    use alphamst_options, only: amst_options, handle_of_options
    use alphamst_patches, only: amst_patches
    use alphamst_report, only: amst_report
    implicit none
    private

    public :: alphamst_adapt, alphamst_reduce_singularities, alphamst_smooth, alphamst_clean
    public :: alphamst_collapse_chord, alphamst_split_chord, alphamst_insert_chords

contains

    !> Replace each patch by its alpha template. alpha > 0 is for the patches that have none of their
    !> own: the wanted number of faces over the present one. Without patches the whole mesh, plane or
    !> curved, with windows that the library chooses: round(alpha * faces) faces, as few singular vertices
    !> as it can, boundary and features kept; a vertex field "size" says where the faces go. A curved mesh
    !> keeps to its surface; features of one lose and get vertices only where they are straight.
    !>
    !> With AMST_OPT_EDIT_BOUNDARY 1 vertices come and go on the boundary of plane meshes and patches where
    !> edges would be far from the wanted length, and where that saves singular vertices. Flagged ones,
    !> corners and ends of markers stay; new ones lie on the boundary as it was, or see set_projection of
    !> amst_mesh. On a curved mesh and with AMST_OPT_STRATEGY 1 it lets chords take vertices from features and
    !> boundary where these turn by less than 30 degrees.
    !>
    !> Errors: ARGUMENT (alpha), NOT_FINITE.
    subroutine alphamst_adapt(mesh, patches, alpha, options, report, stat, errmsg)
        type(amst_mesh), intent(inout) :: mesh
        type(amst_patches), intent(inout), optional :: patches
        real(real64), intent(in) :: alpha
        type(amst_options), intent(in), optional :: options
        type(amst_report), intent(inout), optional :: report
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr), allocatable :: told
        type(c_ptr) :: set
        integer(int32) :: status

        call choose(set, patches, stat, errmsg, status)
        if (status < 0) return
        call ask(told, report)
        status = amst_adapt(mesh%c_handle(), set, alpha, handle_of_options(options), told)
        call finish(status, told, report, stat, errmsg)
    end subroutine alphamst_adapt

    !> Replace each patch by its minimum singularity template, boundary kept but for
    !> AMST_OPT_EDIT_BOUNDARY, see alphamst_adapt. Without patches the whole mesh; its number of faces stays within a few percent.
    subroutine alphamst_reduce_singularities(mesh, patches, options, report, stat, errmsg)
        type(amst_mesh), intent(inout) :: mesh
        type(amst_patches), intent(inout), optional :: patches
        type(amst_options), intent(in), optional :: options
        type(amst_report), intent(inout), optional :: report
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr), allocatable :: told
        type(c_ptr) :: set
        integer(int32) :: status

        call choose(set, patches, stat, errmsg, status)
        if (status < 0) return
        call ask(told, report)
        status = amst_reduce_singularities(mesh%c_handle(), set, handle_of_options(options), told)
        call finish(status, told, report, stat, errmsg)
    end subroutine alphamst_reduce_singularities

    !> Move interior vertices of the patches, or of the mesh without them; flagged ones stay,
    !> but for those on straight features of a curved mesh, which slide along them.
    subroutine alphamst_smooth(mesh, patches, options, report, stat, errmsg)
        type(amst_mesh), intent(inout) :: mesh
        type(amst_patches), intent(in), optional :: patches
        type(amst_options), intent(in), optional :: options
        type(amst_report), intent(inout), optional :: report
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr), allocatable :: told
        type(c_ptr) :: set
        integer(int32) :: status

        call choose(set, patches, stat, errmsg, status)
        if (status < 0) return
        call ask(told, report)
        status = amst_smooth(mesh%c_handle(), set, handle_of_options(options), told)
        call finish(status, told, report, stat, errmsg)
    end subroutine alphamst_smooth

    !> Remove doublets and split valences above 5.
    subroutine alphamst_clean(mesh, options, report, stat, errmsg)
        type(amst_mesh), intent(inout) :: mesh
        type(amst_options), intent(in), optional :: options
        type(amst_report), intent(inout), optional :: report
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr), allocatable :: told
        integer(int32) :: status

        call ask(told, report)
        status = amst_clean(mesh%c_handle(), handle_of_options(options), told)
        call finish(status, told, report, stat, errmsg)
    end subroutine alphamst_clean

    !> Remove the chord through edge: the two ends of each of its edges become one vertex. Errors: RANGE
    !> (edge), CHORD (the reason is in errmsg), GEOMETRY.
    subroutine alphamst_collapse_chord(mesh, edge, options, report, stat, errmsg)
        type(amst_mesh), intent(inout) :: mesh
        integer(int32), intent(in) :: edge
        type(amst_options), intent(in), optional :: options
        type(amst_report), intent(inout), optional :: report
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr), allocatable :: told
        integer(int32) :: status

        call ask(told, report)
        status = amst_collapse_chord(mesh%c_handle(), edge, handle_of_options(options), told)
        call finish(status, told, report, stat, errmsg)
    end subroutine alphamst_collapse_chord

    !> Cut the chord through edge into n + 1 parallel ones; no vertex becomes singular. A chord that ends on
    !> the boundary needs the option AMST_OPT_EDIT_BOUNDARY. Errors: RANGE (edge, n), CHORD, GEOMETRY.
    subroutine alphamst_split_chord(mesh, edge, n, options, report, stat, errmsg)
        type(amst_mesh), intent(inout) :: mesh
        integer(int32), intent(in) :: edge, n
        type(amst_options), intent(in), optional :: options
        type(amst_report), intent(inout), optional :: report
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr), allocatable :: told
        integer(int32) :: status

        call ask(told, report)
        status = amst_split_chord(mesh%c_handle(), edge, n, handle_of_options(options), told)
        call finish(status, told, report, stat, errmsg)
    end subroutine alphamst_split_chord

    !> Lay n rings of faces between the boundary of each patch, which needs 3 to 6 corners or none, and its
    !> faces. Errors: NULL (patches), RANGE (n).
    subroutine alphamst_insert_chords(mesh, patches, n, options, report, stat, errmsg)
        type(amst_mesh), intent(inout) :: mesh
        type(amst_patches), intent(inout) :: patches
        integer(int32), intent(in) :: n
        type(amst_options), intent(in), optional :: options
        type(amst_report), intent(inout), optional :: report
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr), allocatable :: told
        integer(int32) :: status

        call ask(told, report)
        status = amst_insert_chords(mesh%c_handle(), patches%c_handle(), n, handle_of_options(options), told)
        call finish(status, told, report, stat, errmsg)
    end subroutine alphamst_insert_chords

    !> The handle of the patches; NULL, which means the whole mesh, only where there are none.
    subroutine choose(set, patches, stat, errmsg, status)
        type(c_ptr), intent(out) :: set
        type(amst_patches), intent(in), optional :: patches
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), intent(out) :: status

        set = c_null_ptr
        status = AMST_OK
        if (.not. present(patches)) return
        if (patches%exists()) then
            set = patches%c_handle()
        else
            status = AMST_ERR_NULL
            call settle(status, stat, errmsg, 'patches is NULL')
        end if
    end subroutine choose

    !> told not allocated is an absent argument of the C interface: no report is made.
    subroutine ask(told, report)
        type(c_ptr), allocatable, intent(out) :: told
        type(amst_report), intent(in), optional :: report

        if (present(report)) told = c_null_ptr
    end subroutine ask

    subroutine finish(status, told, report, stat, errmsg)
        integer(int32), intent(in) :: status
        type(c_ptr), allocatable, intent(in) :: told
        type(amst_report), intent(inout), optional :: report
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        if (present(report) .and. status >= 0) call report%adopt(told)
        call settle(status, stat, errmsg)
    end subroutine finish

end module alphamst_operations
