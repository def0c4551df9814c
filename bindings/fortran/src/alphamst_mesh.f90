!> Meshes of quadrilaterals. Ids count from 1, 0 is "none"; angles are in degrees, lengths in the
!> unit of the coordinates. Arrays have one column for each vertex, edge or face.
!>
!> Calls that take a mesh as intent(in) may run at the same time; one that takes it as intent(inout)
!> needs it to itself. Meshes that have a projection in common, being copies, are copied and destroyed
!> on one thread at a time.
module alphamst_mesh
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_null_ptr, c_ptr
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use amst_c, only: AMST_ERR_BUFFER_TOO_SMALL, AMST_FACE, AMST_VERTEX, &
        amst_mesh_check, amst_mesh_clone, amst_mesh_clone_into, amst_mesh_compute_cross_field, amst_mesh_create, &
        amst_mesh_create_i64, &
        amst_mesh_destroy, amst_mesh_detect_features, amst_mesh_find_edges, amst_mesh_forget, &
        amst_mesh_get_alignment, amst_mesh_get_checksum, amst_mesh_get_chord, amst_mesh_get_chord_ids, amst_mesh_get_chords, &
        amst_mesh_get_count, amst_mesh_get_crossed_edges, amst_mesh_get_split_edges, &
        amst_mesh_get_dim, amst_mesh_get_edge_faces, amst_mesh_get_edges, &
        amst_mesh_get_faces, amst_mesh_get_field, amst_mesh_get_flags, amst_mesh_get_marker_list, &
        amst_mesh_get_marker_name, amst_mesh_get_markers, amst_mesh_get_points, amst_mesh_get_quality, &
        amst_mesh_get_geometry, amst_mesh_get_overlap, amst_mesh_get_vertex_faces, &
        amst_mesh_get_revision, amst_mesh_get_singularities, amst_mesh_get_summary, &
        amst_mesh_get_valences, amst_mesh_mark, amst_mesh_read, amst_mesh_remove_field, &
        amst_mesh_rollback, amst_mesh_set_field, amst_mesh_set_flags, amst_mesh_set_marker_name, &
        amst_mesh_set_markers, amst_mesh_set_points, amst_mesh_set_surface, &
        amst_mesh_size_from_indicator, amst_mesh_write, amst_summary, &
        AMST_GEOMETRY_LENGTHS
    use alphamst_arrays, only: check_rows, deliver, fetch_reals_of, fetch_row, fetch_row_of, fetch_rows, &
        fill_reals_of, fill_row, fill_row_of, fill_rows
    use alphamst_boundary, only: amst_projection, held_projection, hold, let_go, project_by
    use alphamst_context, only: amst_context
    use alphamst_handle, only: amst_handle, handle_to_copy
    use alphamst_library, only: settle, to_c
    use alphamst_options, only: amst_options, handle_of_options
    implicit none
    private

    !> Assignment makes a mesh of its own, with flags, markers, fields, revision and projection, without savepoints.
    !>
    !> The functions below return new arrays. Their get_ forms fill an array of the caller, which may
    !> have more columns than needed; n becomes the number of columns of the answer. Errors of those:
    !> BUFFER_TOO_SMALL, ARGUMENT (first extent). All have the optional arguments stat and errmsg.
    type, extends(amst_handle), public :: amst_mesh
        private
        type(held_projection), pointer :: projection => null()
    contains
        !> create(context, points(dim, :), faces(4, :) [, options]): faces of kind int32 or int64, corners
        !> counter-clockwise, dim 2 or 3. faces(3, :) are triangles, and so are those of four corners whose
        !> last is 0: they become quads as the option AMST_OPT_QUADRANGULATE says, 0 in pairs, 1 split. All
        !> given vertices keep their ids. Faces that run another way round than their neighbours, or clockwise
        !> in the plane, are turned over, and the log tells how many. An array section is copied first, see
        !> create_strided.
        !> Errors: ARGUMENT (extents), RANGE (corner, count), NOT_FINITE, NOT_QUAD, NOT_MANIFOLD.
        generic :: create => create_int32, create_int64
        !> create_strided(context, dim, points, n_vertices, vertex_stride, component_stride, faces,
        !> n_faces, face_stride, corner_stride [, options]): component c of vertex v is
        !> points(1 + (v - 1)*vertex_stride + (c - 1)*component_stride), faces likewise, so that for
        !> points(n, dim) the strides are 1 and n. Both strides 0 means packed. Nothing is copied first.
        !> Faces are of kind int32; for int64 it is create_strided_int64.
        procedure :: create_strided, create_strided_int64
        !> read(context, path [, options]): .off .obj .ply .msh .su2 .vtk; dim is 2 when every z is 0.
        !> Numbers of points, boundaries and regions are markers, with their names; the log tells what could
        !> not be kept, and stat is AMST_PARTIAL if something with a number is not in the mesh.
        !> Errors: IO, FORMAT, UNSUPPORTED and those of create.
        procedure :: read => read_file
        !> write(path): the same formats, and .svg. All markers and names are kept by .msh; the log tells what
        !> another format has no place for. Errors: IO, UNSUPPORTED.
        procedure :: write => write_file
        !> clone(copy): as copy = mesh, with stat and errmsg. With context: in that one, for threads that work at
        !> the same time (of OpenMP, say), each with a context and a clone of its own; no projection comes along.
        procedure :: clone
        procedure :: destroy

        !> 2 or 3 coordinates a point
        procedure :: dim => get_dim
        !> count(entity): number of vertices, edges or faces, kind int64. Errors: ARGUMENT (entity).
        procedure :: count => get_count
        !> Kind int64; rises with every change of connectivity.
        procedure :: revision => get_revision
        !> Kind int64; equal meshes have equal checksums.
        procedure :: checksum => get_checksum
        !> check(): connectivity and, for dim 2, orientation. alphamst_last_error_where has the first fault.
        procedure :: check

        !> points(dim, n_vertices); get_points(values [, n])
        procedure :: points, get_points
        !> set_points(points(dim, n_vertices)): connectivity and revision stay.
        !> Errors: RANGE (number), ARGUMENT (first extent), NOT_FINITE.
        procedure :: set_points
        !> faces(4, n_faces): corners; get_faces(values [, n])
        procedure :: faces, get_faces
        !> edges(2, n_edges): vertices, smaller id first; get_edges(values [, n])
        procedure :: edges, get_edges
        !> What pairs of triangles did when the mesh was created or read, ids as they were then:
        !> crossed_edges(2, n): vertices of sharp edges that are within quads;
        !> split_edges(3, n): two vertices and the new one at the midpoint between them
        procedure :: crossed_edges, split_edges
        !> edge_faces(2, n_edges): left and right of each edge; on the boundary the one face there is, then 0;
        !> get_edge_faces(values [, n])
        procedure :: edge_faces, get_edge_faces
        !> vertex_faces(offsets(:), faces(:)): those around vertex v, counter-clockwise, on the boundary from
        !> edge to edge, are faces(offsets(v):offsets(v + 1) - 1)
        procedure :: vertex_faces
        !> geometry(key): AMST_GEOMETRY_CENTROIDS(dim, n_faces); AMST_GEOMETRY_NORMALS(dim, n_edges), of length
        !> 1, out of the first face of edge_faces, so on the boundary outwards; AMST_GEOMETRY_LENGTHS
        !> (1, n_edges). Areas are quality(AMST_METRIC_AREA). Errors: ARGUMENT.
        procedure :: geometry
        !> find_edges(pairs(2, n)): edges(n) between pairs of vertices, 0 where there is none;
        !> get_found_edges(pairs, values) needs n elements. Errors: RANGE (vertex), ARGUMENT (extents).
        procedure :: find_edges, get_found_edges
        !> valences(n_vertices): number of edges at each vertex; get_valences(values [, n])
        procedure :: valences, get_valences
        !> singularities(:): interior vertices of valence other than 4, ascending;
        !> get_singularities(values [, n])
        procedure :: singularities, get_singularities
        !> chord(edge [, closed, crossings]): edges crossed by the chord through edge, in order; logical
        !> closed, and the faces it passes twice, kind int64. Errors: RANGE.
        procedure :: chord
        !> chord_ids([n_chords]): number of the chord of each edge. As an edge field 'chord' they are drawn
        !> in colour by write.
        procedure :: chord_ids
        !> chords(property [, options]): an AMST_CHORD_ property of each chord, kind int64; of the options
        !> AMST_OPT_EDIT_BOUNDARY counts. Errors: ARGUMENT.
        procedure :: chords

        !> set_flags(entity, ids(:), mask, value): the AMST_FLAG_* bits of mask become those of value;
        !> without ids for all entities. Errors: ARGUMENT (entity), RANGE (id, bits).
        generic :: set_flags => set_flags_of, set_flags_of_all
        !> flags(entity): the AMST_FLAG_* bits of each; get_flags(entity, values [, n]).
        !> Errors: ARGUMENT (entity).
        procedure :: flags, get_flags
        !> detect_features(angle [, found]): edges whose two faces have normals more than angle degrees
        !> apart, 0 to 180, become AMST_FLAG_FEATURE, and vertices where curves of such edges, these and
        !> those of before, end, cross or turn by more than 60 degrees, but not right back, AMST_FLAG_CORNER.
        !> No flag is taken away; found, kind int64, is the number of those edges. Errors: NOT_FINITE, RANGE.
        procedure :: detect_features

        !> set_markers(entity, ids(:), value): their marker, a number of a boundary, region or point, becomes
        !> value, 0 for none; without ids that of all entities. Operations keep what is marked; vertices with
        !> a marker are AMST_FLAG_CORNER. Errors: ARGUMENT (entity), RANGE (id).
        generic :: set_markers => set_markers_of, set_markers_of_all
        !> markers(entity): the marker of each; get_markers(entity, values [, n]).
        !> Errors: ARGUMENT (entity).
        procedure :: markers, get_markers
        !> marker_list(entity): the markers in use, ascending, without 0. Errors: ARGUMENT (entity).
        procedure :: marker_list
        !> set_marker_name(entity, marker, name): without trailing blanks; '' takes the name away.
        !> Errors: ARGUMENT (entity, marker 0, a name with double quotes or control characters).
        procedure :: set_marker_name
        !> marker_name(entity, marker): '' if it has none. Errors: ARGUMENT (entity).
        procedure :: marker_name

        !> set_field(entity, name, values(:), carry), or values(components, :): named numbers of each entity;
        !> a field of that name there is replaced. Operations keep the values of what they keep; an
        !> AMST_CARRY_* gives others theirs: LINEAR (vertices, also where they have moved) interpolates;
        !> CONSERVE and AVERAGE (faces, or the quarters of faces at vertices) keep the sum of value and area,
        !> CONSERVE with linear values before, AVERAGE with constant ones. The library reads 'size'
        !> (AMST_VERTEX, one number above 0): the wanted edge length; and 'cross' (AMST_FACE, three numbers),
        !> see compute_cross_field.
        !> Errors: ARGUMENT (entity, name empty, name or carry not for this entity), RANGE (extents, a size
        !> not above 0), NOT_FINITE.
        generic :: set_field => set_field_of_one, set_field_of_several
        !> field(entity, name): values(components, :); get_field(entity, name, values(components, :) [, n]).
        !> Errors: ARGUMENT (entity, name empty), NOT_FOUND.
        procedure :: field, get_field
        !> size_from_indicator(indicator(:) [, tolerance, faces, options, asked_faces]): writes the field 'size' of
        !> AMST_VERTEX. The indicator of a face is what it contributes to the error, at least 0. Given a
        !> tolerance, each face asks for edges at which its indicator is that, and faces, kind int64, is a limit
        !> of their number; without one there will be as many faces, with equal error everywhere. Of the options
        !> AMST_OPT_ERROR_ORDER, _MIN_EDGE, _MAX_EDGE, _GRADATION and _BUFFER_LAYERS count. asked_faces: how many
        !> the sizes ask for. Errors: RANGE (extent, below 0, both 0), ARGUMENT (MAX_EDGE below MIN_EDGE),
        !> NOT_FINITE.
        procedure :: size_from_indicator
        !> overlap(after, before_faces(:), after_faces(:), areas(:)): what a face of this mesh shares with one
        !> of another, as with the mesh after an operation, one element each; ascending by after_faces, then
        !> before_faces. In a plane those of a face sum up to its area. Errors: ARGUMENT (another dim).
        procedure :: overlap
        !> remove_field(entity, name). Errors: ARGUMENT (entity, name empty), NOT_FOUND.
        procedure :: remove_field
        !> compute_cross_field([options]): a new field 'cross' of AMST_FACE, a direction of length 1 that
        !> edges shall have there, or one at right angles to it. Along the boundary, features and borders
        !> of markers it is that of the edges, elsewhere a principal direction, the more the curvatures in
        !> them differ; and between that it is as smooth as can be. New faces inherit it. Of the options
        !> AMST_OPT_SMOOTH_STEPS counts.
        procedure :: compute_cross_field
        !> alignment(): mean angle, 0 to 45 degrees, between the sides of faces and the nearest of the four
        !> directions of 'cross': 0 where edges follow it, 22.5 where they do not know of it. Errors:
        !> NOT_FOUND.
        procedure :: alignment

        !> set_surface(points(dim, :), triangles(3, :)): the surface that operations project the vertices to
        !> that they move or add; corners are numbers of these points from 1. set_surface(): the mesh as it
        !> is now. Until then it is the mesh as it is when the first operation on it begins. It is part of
        !> the mesh as fields are. Errors: ARGUMENT (first extents), RANGE (no triangle, a corner that is
        !> no point), NOT_FINITE.
        generic :: set_surface => set_surface_to, set_surface_to_mesh

        !> set_projection([projection, user]): where the boundary runs, for operations with
        !> AMST_OPT_EDIT_BOUNDARY; without projection as the edges of the mesh do. An operation calls it once
        !> when it begins, for points on edges of the boundary, to learn where that runs, and once in the
        !> end, for new vertices, which come to lie where it says, bit for bit. The operation fails with
        !> AMST_ERR_PROJECTION, and nothing has changed, if the projection says so, if a result is not
        !> finite or farther off than AMST_OPT_TOLERANCE edges, and if a new vertex turned a face over
        !> there. projection and user must exist until they are replaced or the mesh and its copies are
        !> destroyed. Not kept in files. A handle given away by release keeps it, for which some bytes stay.
        procedure :: set_projection

        !> mark(revision): remember points, connectivity, flags, markers and fields under this name.
        procedure :: mark
        !> rollback(revision): back to that savepoint, which stays. Errors: NOT_FOUND.
        procedure :: rollback
        !> forget(revision): give the savepoint up. Errors: NOT_FOUND.
        procedure :: forget

        !> quality(metric): an AMST_METRIC_* of each face; get_quality(metric, values [, n]).
        !> Errors: ARGUMENT (metric).
        procedure :: quality, get_quality
        !> summary(metric): type(amst_summary). Errors: ARGUMENT (metric).
        procedure :: summary => get_summary

        procedure, private :: create_int32, create_int64, set_flags_of, set_flags_of_all, assign, &
            set_markers_of, set_markers_of_all, &
            set_field_of_one, set_field_of_several, components_of, set_surface_to, set_surface_to_mesh
        generic :: assignment(=) => assign
        final :: finalize
    end type amst_mesh

contains

    subroutine create_int32(self, context, points, faces, options, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        type(amst_context), intent(in) :: context
        real(real64), intent(in), contiguous :: points(:, :)
        integer(int32), intent(in), contiguous :: faces(:, :)
        type(amst_options), intent(in), optional :: options
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(int32) :: status

        handle = c_null_ptr
        status = amst_mesh_create(context%c_handle(), size(points, 1, int32), points, size(points, 2, int64), &
            0_int64, 0_int64, faces, size(faces, 2, int64), 0_int64, 0_int64, size(faces, 1, int32), &
            handle_of_options(options), handle)
        call take(self, handle, status, stat, errmsg)
    end subroutine create_int32

    subroutine create_int64(self, context, points, faces, options, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        type(amst_context), intent(in) :: context
        real(real64), intent(in), contiguous :: points(:, :)
        integer(int64), intent(in), contiguous :: faces(:, :)
        type(amst_options), intent(in), optional :: options
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(int32) :: status

        handle = c_null_ptr
        status = amst_mesh_create_i64(context%c_handle(), size(points, 1, int32), points, size(points, 2, int64), &
            0_int64, 0_int64, faces, size(faces, 2, int64), 0_int64, 0_int64, size(faces, 1, int32), &
            handle_of_options(options), handle)
        call take(self, handle, status, stat, errmsg)
    end subroutine create_int64

    subroutine create_strided(self, context, dim, points, n_vertices, vertex_stride, component_stride, &
            faces, n_faces, face_stride, corner_stride, options, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        type(amst_context), intent(in) :: context
        integer(int32), intent(in) :: dim
        real(real64), intent(in) :: points(*)
        integer(int64), intent(in) :: n_vertices, vertex_stride, component_stride
        integer(int32), intent(in) :: faces(*)
        integer(int64), intent(in) :: n_faces, face_stride, corner_stride
        type(amst_options), intent(in), optional :: options
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(int32) :: status

        handle = c_null_ptr
        status = amst_mesh_create(context%c_handle(), dim, points, n_vertices, vertex_stride, component_stride, &
            faces, n_faces, face_stride, corner_stride, 4_int32, handle_of_options(options), handle)
        call take(self, handle, status, stat, errmsg)
    end subroutine create_strided

    subroutine create_strided_int64(self, context, dim, points, n_vertices, vertex_stride, component_stride, &
            faces, n_faces, face_stride, corner_stride, options, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        type(amst_context), intent(in) :: context
        integer(int32), intent(in) :: dim
        real(real64), intent(in) :: points(*)
        integer(int64), intent(in) :: n_vertices, vertex_stride, component_stride
        integer(int64), intent(in) :: faces(*)
        integer(int64), intent(in) :: n_faces, face_stride, corner_stride
        type(amst_options), intent(in), optional :: options
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(int32) :: status

        handle = c_null_ptr
        status = amst_mesh_create_i64(context%c_handle(), dim, points, n_vertices, vertex_stride, component_stride, &
            faces, n_faces, face_stride, corner_stride, 4_int32, handle_of_options(options), handle)
        call take(self, handle, status, stat, errmsg)
    end subroutine create_strided_int64

    subroutine read_file(self, context, path, options, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        type(amst_context), intent(in) :: context
        character(len=*), intent(in) :: path
        type(amst_options), intent(in), optional :: options
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(int32) :: status

        handle = c_null_ptr
        status = amst_mesh_read(context%c_handle(), to_c(path), handle_of_options(options), handle)
        call take(self, handle, status, stat, errmsg)
    end subroutine read_file

    subroutine write_file(self, path, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        character(len=*), intent(in) :: path
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_write(self%c_handle(), to_c(path)), stat, errmsg)
    end subroutine write_file

    subroutine clone(self, copy, stat, errmsg, context)
        class(amst_mesh), intent(in) :: self
        class(amst_mesh), intent(inout) :: copy
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(amst_context), intent(in), optional :: context
        type(c_ptr) :: handle
        type(held_projection), pointer :: projection
        integer(int32) :: status

        handle = c_null_ptr
        projection => null()
        if (present(context)) then
            status = amst_mesh_clone_into(self%c_handle(), context%c_handle(), handle)
        else
            status = amst_mesh_clone(self%c_handle(), handle)
            projection => self%projection
        end if
        if (status >= 0) call hold(projection) ! before copy, which may be self, lets go of its own
        call take(copy, handle, status, stat, errmsg)
        if (status >= 0) copy%projection => projection
    end subroutine clone

    !> A new mesh into its variable, which keeps the one it had on failure.
    subroutine take(self, handle, status, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        type(c_ptr), intent(in) :: handle
        integer(int32), intent(in) :: status
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        if (status >= 0) call self%adopt(handle)
        call settle(status, stat, errmsg)
    end subroutine take

    subroutine destroy(self)
        class(amst_mesh), intent(inout) :: self

        type(c_ptr) :: handle

        handle = self%release()
        call let_go(handle, self%projection)
        call amst_mesh_destroy(handle)
    end subroutine destroy

    impure elemental subroutine finalize(self)
        type(amst_mesh), intent(inout) :: self

        call self%destroy()
    end subroutine finalize

    impure elemental subroutine assign(self, other)
        class(amst_mesh), intent(inout) :: self
        class(amst_mesh), intent(in) :: other
        type(c_ptr) :: handle
        type(held_projection), pointer :: projection

        handle = c_null_ptr
        projection => null()
        if (c_associated(handle_to_copy(other))) then
            call settle(amst_mesh_clone(handle_to_copy(other), handle))
            projection => other%projection
            call hold(projection)
        end if
        call self%adopt(handle)
        self%projection => projection
    end subroutine assign

    function get_dim(self, stat, errmsg) result(dim)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32) :: dim

        dim = 0
        call settle(amst_mesh_get_dim(self%c_handle(), dim), stat, errmsg)
    end function get_dim

    function get_count(self, entity, stat, errmsg) result(count)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: entity
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: count

        count = 0
        call settle(amst_mesh_get_count(self%c_handle(), entity, count), stat, errmsg)
    end function get_count

    function get_revision(self, stat, errmsg) result(revision)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: revision

        revision = 0
        call settle(amst_mesh_get_revision(self%c_handle(), revision), stat, errmsg)
    end function get_revision

    function get_checksum(self, stat, errmsg) result(checksum)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: checksum

        checksum = 0
        call settle(amst_mesh_get_checksum(self%c_handle(), checksum), stat, errmsg)
    end function get_checksum

    subroutine check(self, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_check(self%c_handle()), stat, errmsg)
    end subroutine check

    function points(self, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        real(real64), allocatable :: values(:, :)
        integer(int32) :: rows, status
        integer(int64) :: needed

        rows = 1
        needed = 0
        status = amst_mesh_get_dim(self%c_handle(), rows)
        if (status >= 0) status = amst_mesh_get_points(self%c_handle(), capacity=0_int64, needed=needed)
        allocate (values(rows, needed/rows))
        if (status >= 0) status = amst_mesh_get_points(self%c_handle(), values, needed, needed)
        call settle(status, stat, errmsg)
    end function points

    subroutine get_points(self, values, n, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        real(real64), intent(inout), contiguous :: values(:, :)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32) :: rows, status
        integer(int64) :: needed

        rows = size(values, 1, int32)
        needed = 0
        status = amst_mesh_get_dim(self%c_handle(), rows)
        if (check_rows(size(values, 1, int32), rows, stat, errmsg)) then
            if (status >= 0) status = amst_mesh_get_points(self%c_handle(), values, size(values, kind=int64), needed)
            call deliver(status, needed/max(rows, 1_int32), n, stat, errmsg)
        end if
    end subroutine get_points

    subroutine set_points(self, points, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        real(real64), intent(in), contiguous :: points(:, :)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32) :: rows, status

        rows = size(points, 1, int32)
        status = amst_mesh_get_dim(self%c_handle(), rows)
        if (check_rows(size(points, 1, int32), rows, stat, errmsg)) then
            if (status >= 0) status = amst_mesh_set_points(self%c_handle(), points, size(points, 2, int64))
            call settle(status, stat, errmsg)
        end if
    end subroutine set_points

    function faces(self, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:, :)

        call fetch_rows(amst_mesh_get_faces, self%c_handle(), 4_int32, values, stat, errmsg)
    end function faces

    subroutine get_faces(self, values, n, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(inout), contiguous :: values(:, :)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_rows(amst_mesh_get_faces, self%c_handle(), 4_int32, values, n, stat, errmsg)
    end subroutine get_faces

    function edges(self, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:, :)

        call fetch_rows(amst_mesh_get_edges, self%c_handle(), 2_int32, values, stat, errmsg)
    end function edges

    function crossed_edges(self, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:, :)

        call fetch_rows(amst_mesh_get_crossed_edges, self%c_handle(), 2_int32, values, stat, errmsg)
    end function crossed_edges

    function split_edges(self, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:, :)

        call fetch_rows(amst_mesh_get_split_edges, self%c_handle(), 3_int32, values, stat, errmsg)
    end function split_edges

    subroutine get_edges(self, values, n, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(inout), contiguous :: values(:, :)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_rows(amst_mesh_get_edges, self%c_handle(), 2_int32, values, n, stat, errmsg)
    end subroutine get_edges

    function edge_faces(self, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:, :)

        call fetch_rows(amst_mesh_get_edge_faces, self%c_handle(), 2_int32, values, stat, errmsg)
    end function edge_faces

    subroutine get_edge_faces(self, values, n, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(inout), contiguous :: values(:, :)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_rows(amst_mesh_get_edge_faces, self%c_handle(), 2_int32, values, n, stat, errmsg)
    end subroutine get_edge_faces

    subroutine vertex_faces(self, offsets, faces, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), allocatable, intent(out) :: offsets(:), faces(:)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32) :: status
        integer(int64) :: needed, vertices

        needed = 0
        vertices = -1 ! no offsets of no mesh
        status = amst_mesh_get_vertex_faces(self%c_handle(), capacity=0_int64, needed=needed)
        if (status >= 0) status = amst_mesh_get_count(self%c_handle(), AMST_VERTEX, vertices)
        allocate (offsets(vertices + 1), faces(needed))
        if (status >= 0) status = amst_mesh_get_vertex_faces(self%c_handle(), offsets, faces, needed, needed)
        call settle(status, stat, errmsg)
    end subroutine vertex_faces

    function geometry(self, key, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: key
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        real(real64), allocatable :: values(:, :)
        integer(int32) :: rows, status
        integer(int64) :: needed

        needed = 0
        rows = 1
        status = amst_mesh_get_geometry(self%c_handle(), key, capacity=0_int64, needed=needed)
        if (status >= 0 .and. key /= AMST_GEOMETRY_LENGTHS) status = amst_mesh_get_dim(self%c_handle(), rows)
        allocate (values(rows, needed/rows))
        if (status >= 0) status = amst_mesh_get_geometry(self%c_handle(), key, values, needed, needed)
        call settle(status, stat, errmsg)
    end function geometry

    function find_edges(self, pairs, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in), contiguous :: pairs(:, :)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)

        allocate (values(size(pairs, 2)), source=0_int32)
        call self%get_found_edges(pairs, values, stat, errmsg)
    end function find_edges

    subroutine get_found_edges(self, pairs, values, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in), contiguous :: pairs(:, :)
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        if (.not. check_rows(size(pairs, 1, int32), 2_int32, stat, errmsg)) return
        if (.not. check_rows(size(values, kind=int32), size(pairs, 2, int32), stat, errmsg)) return
        call settle(amst_mesh_find_edges(self%c_handle(), pairs, size(pairs, 2, int64), values), stat, errmsg)
    end subroutine get_found_edges

    function valences(self, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)

        call fetch_row(amst_mesh_get_valences, self%c_handle(), values, stat, errmsg)
    end function valences

    subroutine get_valences(self, values, n, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_row(amst_mesh_get_valences, self%c_handle(), values, n, stat, errmsg)
    end subroutine get_valences

    function singularities(self, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)

        call fetch_row(amst_mesh_get_singularities, self%c_handle(), values, stat, errmsg)
    end function singularities

    subroutine get_singularities(self, values, n, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_row(amst_mesh_get_singularities, self%c_handle(), values, n, stat, errmsg)
    end subroutine get_singularities

    function chord(self, edge, closed, crossings, stat, errmsg) result(edges)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: edge
        logical, intent(out), optional :: closed
        integer(int64), intent(out), optional :: crossings
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: edges(:)
        integer(int64) :: needed, twice
        integer(int32) :: cyclic, status

        needed = 0
        cyclic = 0
        twice = 0
        status = amst_mesh_get_chord(self%c_handle(), edge, capacity=0_int64, needed=needed)
        allocate (edges(needed))
        if (status >= 0) status = amst_mesh_get_chord(self%c_handle(), edge, cyclic, twice, edges, needed, needed)
        if (present(closed)) closed = cyclic /= 0
        if (present(crossings)) crossings = twice
        call settle(status, stat, errmsg)
    end function chord

    function chord_ids(self, n_chords, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int64), intent(inout), optional :: n_chords
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)
        integer(int64) :: needed
        integer(int32) :: status

        needed = 0
        status = amst_mesh_get_chord_ids(self%c_handle(), capacity=0_int64, needed=needed)
        allocate (values(needed))
        if (status >= 0) status = amst_mesh_get_chord_ids(self%c_handle(), n_chords, values, needed, needed)
        call settle(status, stat, errmsg)
    end function chord_ids

    function chords(self, property, options, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: property
        type(amst_options), intent(in), optional :: options
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64), allocatable :: values(:)
        integer(int64) :: needed
        integer(int32) :: status

        needed = 0
        status = amst_mesh_get_chords(self%c_handle(), property, handle_of_options(options), capacity=0_int64, &
            needed=needed)
        allocate (values(needed))
        if (status >= 0) status = amst_mesh_get_chords(self%c_handle(), property, handle_of_options(options), &
            values, needed, needed)
        call settle(status, stat, errmsg)
    end function chords

    subroutine set_flags_of_all(self, entity, mask, value, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int32), intent(in) :: entity, mask, value
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_set_flags(self%c_handle(), entity, n=0_int64, mask=mask, value=value), stat, errmsg)
    end subroutine set_flags_of_all

    ! No ids are passed on as such: the address of an empty array may be NULL, which would mean all.
    subroutine set_flags_of(self, entity, ids, mask, value, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int32), intent(in) :: entity, mask, value
        integer(int32), intent(in), contiguous :: ids(:)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), parameter :: no_ids(1) = 0
        integer(int32) :: status

        if (size(ids) == 0) then
            status = amst_mesh_set_flags(self%c_handle(), entity, no_ids, 0_int64, mask, value)
        else
            status = amst_mesh_set_flags(self%c_handle(), entity, ids, size(ids, kind=int64), mask, value)
        end if
        call settle(status, stat, errmsg)
    end subroutine set_flags_of

    function flags(self, entity, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: entity
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)

        call fetch_row_of(amst_mesh_get_flags, self%c_handle(), entity, values, stat, errmsg)
    end function flags

    subroutine get_flags(self, entity, values, n, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: entity
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_row_of(amst_mesh_get_flags, self%c_handle(), entity, values, n, stat, errmsg)
    end subroutine get_flags

    subroutine set_markers_of_all(self, entity, value, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int32), intent(in) :: entity, value
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_set_markers(self%c_handle(), entity, n=0_int64, value=value), stat, errmsg)
    end subroutine set_markers_of_all

    ! No ids are passed on as such, see set_flags_of.
    subroutine set_markers_of(self, entity, ids, value, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int32), intent(in) :: entity, value
        integer(int32), intent(in), contiguous :: ids(:)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), parameter :: no_ids(1) = 0
        integer(int32) :: status

        if (size(ids) == 0) then
            status = amst_mesh_set_markers(self%c_handle(), entity, no_ids, 0_int64, value)
        else
            status = amst_mesh_set_markers(self%c_handle(), entity, ids, size(ids, kind=int64), value)
        end if
        call settle(status, stat, errmsg)
    end subroutine set_markers_of

    function markers(self, entity, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: entity
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)

        call fetch_row_of(amst_mesh_get_markers, self%c_handle(), entity, values, stat, errmsg)
    end function markers

    subroutine get_markers(self, entity, values, n, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: entity
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_row_of(amst_mesh_get_markers, self%c_handle(), entity, values, n, stat, errmsg)
    end subroutine get_markers

    function marker_list(self, entity, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: entity
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)

        call fetch_row_of(amst_mesh_get_marker_list, self%c_handle(), entity, values, stat, errmsg)
    end function marker_list

    subroutine set_marker_name(self, entity, marker, name, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int32), intent(in) :: entity, marker
        character(len=*), intent(in) :: name
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_set_marker_name(self%c_handle(), entity, marker, to_c(name)), stat, errmsg)
    end subroutine set_marker_name

    function marker_name(self, entity, marker, stat, errmsg) result(name)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: entity, marker
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        character(len=:), allocatable :: name
        character(kind=c_char), allocatable :: characters(:)
        integer(int64) :: needed, i
        integer(int32) :: status

        needed = 1 ! the zero that ends it
        status = amst_mesh_get_marker_name(self%c_handle(), entity, marker, capacity=0_int64, needed=needed)
        allocate (characters(needed))
        if (status >= 0) status = amst_mesh_get_marker_name(self%c_handle(), entity, marker, characters, needed, needed)
        if (status < 0) needed = 1
        allocate (character(len=needed - 1) :: name)
        do i = 1, needed - 1
            name(i:i) = characters(i)
        end do
        call settle(status, stat, errmsg)
    end function marker_name

    subroutine detect_features(self, angle, found, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        real(real64), intent(in) :: angle
        integer(int64), intent(inout), optional :: found
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_detect_features(self%c_handle(), angle, found), stat, errmsg)
    end subroutine detect_features

    subroutine set_field_of_one(self, entity, name, values, carry, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int32), intent(in) :: entity, carry
        character(len=*), intent(in) :: name
        real(real64), intent(in), contiguous :: values(:)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_set_field(self%c_handle(), entity, to_c(name), 1_int32, carry, values, &
            size(values, kind=int64)), stat, errmsg)
    end subroutine set_field_of_one

    subroutine set_field_of_several(self, entity, name, values, carry, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int32), intent(in) :: entity, carry
        character(len=*), intent(in) :: name
        real(real64), intent(in), contiguous :: values(:, :)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_set_field(self%c_handle(), entity, to_c(name), size(values, 1, int32), carry, &
            values, size(values, 2, int64)), stat, errmsg)
    end subroutine set_field_of_several

    function field(self, entity, name, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: entity
        character(len=*), intent(in) :: name
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        real(real64), allocatable :: values(:, :)
        integer(int32) :: components, status
        integer(int64) :: needed

        call self%components_of(entity, name, components, needed, status)
        allocate (values(components, needed/components))
        if (status >= 0) status = amst_mesh_get_field(self%c_handle(), entity, to_c(name), values, needed, needed)
        call settle(status, stat, errmsg)
    end function field

    subroutine get_field(self, entity, name, values, n, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: entity
        character(len=*), intent(in) :: name
        real(real64), intent(inout), contiguous :: values(:, :)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32) :: components, status
        integer(int64) :: needed

        call self%components_of(entity, name, components, needed, status)
        if (status < 0) then
            call settle(status, stat, errmsg)
        else if (check_rows(size(values, 1, int32), components, stat, errmsg)) then
            status = amst_mesh_get_field(self%c_handle(), entity, to_c(name), values, size(values, kind=int64), &
                needed)
            call deliver(status, needed/components, n, stat, errmsg)
        end if
    end subroutine get_field

    !> How many numbers a field has for each entity, and in all; 1 and 0 where there is none.
    subroutine components_of(self, entity, name, components, needed, status)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: entity
        character(len=*), intent(in) :: name
        integer(int32), intent(out) :: components, status
        integer(int64), intent(out) :: needed
        integer(int64) :: count

        components = 1
        needed = 0
        count = 1
        status = amst_mesh_get_field(self%c_handle(), entity, to_c(name), capacity=0_int64, needed=needed)
        if (status >= 0) status = amst_mesh_get_count(self%c_handle(), entity, count)
        if (status >= 0) components = int(needed/count, int32)
    end subroutine components_of

    subroutine size_from_indicator(self, indicator, tolerance, faces, options, asked_faces, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        real(real64), intent(in), contiguous :: indicator(:)
        real(real64), intent(in), optional :: tolerance
        integer(int64), intent(in), optional :: faces
        type(amst_options), intent(in), optional :: options
        real(real64), intent(inout), optional :: asked_faces
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        real(real64) :: wanted
        integer(int64) :: most

        wanted = 0
        most = 0
        if (present(tolerance)) wanted = tolerance
        if (present(faces)) most = faces
        call settle(amst_mesh_size_from_indicator(self%c_handle(), indicator, size(indicator, kind=int64), wanted, &
            most, handle_of_options(options), asked_faces), stat, errmsg)
    end subroutine size_from_indicator

    subroutine overlap(self, after, before_faces, after_faces, areas, stat, errmsg)
        class(amst_mesh), intent(in) :: self, after
        integer(int32), allocatable, intent(out) :: before_faces(:), after_faces(:)
        real(real64), allocatable, intent(out) :: areas(:)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32) :: status
        integer(int64) :: capacity, needed

        ! Mostly enough, so that the work is done once: a face meets about four, on either side.
        capacity = 4*(self%count(AMST_FACE) + after%count(AMST_FACE))
        do
            needed = 0
            allocate (before_faces(capacity), after_faces(capacity), areas(capacity))
            status = amst_mesh_get_overlap(self%c_handle(), after%c_handle(), before_faces, after_faces, areas, &
                capacity, needed)
            if (status /= AMST_ERR_BUFFER_TOO_SMALL) exit
            capacity = needed
            deallocate (before_faces, after_faces, areas)
        end do
        if (status < 0) needed = 0
        before_faces = before_faces(:needed)
        after_faces = after_faces(:needed)
        areas = areas(:needed)
        call settle(status, stat, errmsg)
    end subroutine overlap

    subroutine remove_field(self, entity, name, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int32), intent(in) :: entity
        character(len=*), intent(in) :: name
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_remove_field(self%c_handle(), entity, to_c(name)), stat, errmsg)
    end subroutine remove_field

    subroutine compute_cross_field(self, options, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        type(amst_options), intent(in), optional :: options
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_compute_cross_field(self%c_handle(), handle_of_options(options)), stat, errmsg)
    end subroutine compute_cross_field

    function alignment(self, stat, errmsg) result(mean_degrees)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        real(real64) :: mean_degrees

        mean_degrees = 0
        call settle(amst_mesh_get_alignment(self%c_handle(), mean_degrees), stat, errmsg)
    end function alignment

    ! No points are passed on as such: the address of an empty array may be NULL, which would mean the mesh.
    subroutine set_surface_to(self, points, triangles, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        real(real64), intent(in), contiguous :: points(:, :)
        integer(int32), intent(in), contiguous :: triangles(:, :)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        real(real64), parameter :: no_points(1) = 0
        integer(int32) :: dim, status

        dim = 0
        status = amst_mesh_get_dim(self%c_handle(), dim)
        if (status < 0) then
            call settle(status, stat, errmsg)
            return
        end if
        if (.not. check_rows(size(points, 1, int32), dim, stat, errmsg)) return
        if (.not. check_rows(size(triangles, 1, int32), 3_int32, stat, errmsg)) return
        if (size(points) == 0) then
            status = amst_mesh_set_surface(self%c_handle(), no_points, 0_int64, triangles, size(triangles, 2, int64))
        else
            status = amst_mesh_set_surface(self%c_handle(), points, size(points, 2, int64), triangles, &
                size(triangles, 2, int64))
        end if
        call settle(status, stat, errmsg)
    end subroutine set_surface_to

    subroutine set_surface_to_mesh(self, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_set_surface(self%c_handle(), n_points=0_int64, n_triangles=0_int64), stat, errmsg)
    end subroutine set_surface_to_mesh

    function quality(self, metric, stat, errmsg) result(values)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: metric
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        real(real64), allocatable :: values(:)

        call fetch_reals_of(amst_mesh_get_quality, self%c_handle(), metric, values, stat, errmsg)
    end function quality

    subroutine get_quality(self, metric, values, n, stat, errmsg)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: metric
        real(real64), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_reals_of(amst_mesh_get_quality, self%c_handle(), metric, values, n, stat, errmsg)
    end subroutine get_quality

    function get_summary(self, metric, stat, errmsg) result(summary)
        class(amst_mesh), intent(in) :: self
        integer(int32), intent(in) :: metric
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(amst_summary) :: summary

        summary = amst_summary(0, 0, 0, 0, 0, 0)
        call settle(amst_mesh_get_summary(self%c_handle(), metric, summary), stat, errmsg)
    end function get_summary

    subroutine set_projection(self, projection, user, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        procedure(amst_projection), optional :: projection
        class(*), intent(inout), target, optional :: user
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(project_by(self%c_handle(), self%projection, projection, user), stat, errmsg)
    end subroutine set_projection

    subroutine mark(self, revision, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int64), intent(inout) :: revision
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_mark(self%c_handle(), revision), stat, errmsg)
    end subroutine mark

    subroutine rollback(self, revision, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int64), intent(in) :: revision
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_rollback(self%c_handle(), revision), stat, errmsg)
    end subroutine rollback

    subroutine forget(self, revision, stat, errmsg)
        class(amst_mesh), intent(inout) :: self
        integer(int64), intent(in) :: revision
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_mesh_forget(self%c_handle(), revision), stat, errmsg)
    end subroutine forget

end module alphamst_mesh
