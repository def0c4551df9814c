!> The functions of meshes and what is on them; part of amst_c.
module amst_c_mesh
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_funptr, c_int32_t, c_int64_t, c_ptr
    implicit none
    private :: c_char, c_double, c_funptr, c_int32_t, c_int64_t, c_ptr

    interface
        ! mesh

        integer(c_int32_t) function amst_mesh_create(ctx, dim, coords, n_vertices, vertex_stride, &
                component_stride, faces, n_faces, face_stride, corner_stride, corners_per_face, &
                options, out) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: coords(*)
            integer(c_int64_t), value :: n_vertices, vertex_stride, component_stride
            integer(c_int32_t), intent(in), optional :: faces(*)
            integer(c_int64_t), value :: n_faces, face_stride, corner_stride
            integer(c_int32_t), value :: corners_per_face
            type(c_ptr), value :: options
            type(c_ptr), intent(inout) :: out
        end function amst_mesh_create

        integer(c_int32_t) function amst_mesh_create_i64(ctx, dim, coords, n_vertices, vertex_stride, &
                component_stride, faces, n_faces, face_stride, corner_stride, corners_per_face, &
                options, out) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: coords(*)
            integer(c_int64_t), value :: n_vertices, vertex_stride, component_stride
            integer(c_int64_t), intent(in), optional :: faces(*)
            integer(c_int64_t), value :: n_faces, face_stride, corner_stride
            integer(c_int32_t), value :: corners_per_face
            type(c_ptr), value :: options
            type(c_ptr), intent(inout) :: out
        end function amst_mesh_create_i64

        integer(c_int32_t) function amst_mesh_read(ctx, path, options, out) bind(c)
            import :: c_char, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            character(kind=c_char), intent(in) :: path(*)
            type(c_ptr), value :: options
            type(c_ptr), intent(inout) :: out
        end function amst_mesh_read

        integer(c_int32_t) function amst_mesh_write(mesh, path) bind(c)
            import :: c_char, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            character(kind=c_char), intent(in) :: path(*)
        end function amst_mesh_write

        integer(c_int32_t) function amst_mesh_clone(mesh, out) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            type(c_ptr), intent(inout) :: out
        end function amst_mesh_clone

        integer(c_int32_t) function amst_mesh_clone_into(mesh, ctx, out) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, ctx
            type(c_ptr), intent(inout) :: out
        end function amst_mesh_clone_into

        subroutine amst_mesh_destroy(mesh) bind(c)
            import :: c_ptr
            implicit none
            type(c_ptr), value :: mesh
        end subroutine amst_mesh_destroy

        integer(c_int32_t) function amst_mesh_get_dim(mesh, dim) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout) :: dim
        end function amst_mesh_get_dim

        integer(c_int32_t) function amst_mesh_get_count(mesh, entity, count) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            integer(c_int64_t), intent(inout) :: count
        end function amst_mesh_get_count

        integer(c_int32_t) function amst_mesh_get_revision(mesh, revision) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), intent(inout) :: revision
        end function amst_mesh_get_revision

        integer(c_int32_t) function amst_mesh_get_points(mesh, out, capacity, needed) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_points

        integer(c_int32_t) function amst_mesh_set_points(mesh, points, n) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), intent(in), optional :: points(*)
            integer(c_int64_t), value :: n
        end function amst_mesh_set_points

        integer(c_int32_t) function amst_mesh_get_faces(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_faces

        integer(c_int32_t) function amst_mesh_get_edges(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_edges

        integer(c_int32_t) function amst_mesh_get_crossed_edges(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_crossed_edges

        integer(c_int32_t) function amst_mesh_get_split_edges(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_split_edges

        integer(c_int32_t) function amst_mesh_get_edge_faces(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_edge_faces

        integer(c_int32_t) function amst_mesh_get_vertex_faces(mesh, offsets, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: offsets(*)
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_vertex_faces

        integer(c_int32_t) function amst_mesh_get_geometry(mesh, key, out, capacity, needed) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: key
            real(c_double), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_geometry

        integer(c_int32_t) function amst_mesh_find_edges(mesh, pairs, n, edges) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(in), optional :: pairs(*)
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(inout), optional :: edges(*)
        end function amst_mesh_find_edges

        integer(c_int32_t) function amst_mesh_get_valences(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_valences

        integer(c_int32_t) function amst_mesh_get_singularities(mesh, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_singularities

        integer(c_int32_t) function amst_mesh_check(mesh) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
        end function amst_mesh_check

        integer(c_int32_t) function amst_mesh_get_checksum(mesh, digest) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), intent(inout) :: digest
        end function amst_mesh_get_checksum

        ! flags

        integer(c_int32_t) function amst_mesh_set_flags(mesh, entity, ids, n, mask, value) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            integer(c_int32_t), intent(in), optional :: ids(*)
            integer(c_int64_t), value :: n
            integer(c_int32_t), value :: mask, value
        end function amst_mesh_set_flags

        integer(c_int32_t) function amst_mesh_get_flags(mesh, entity, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_flags

        integer(c_int32_t) function amst_mesh_detect_features(mesh, angle, found) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), value :: angle
            integer(c_int64_t), intent(inout), optional :: found
        end function amst_mesh_detect_features

        ! markers

        integer(c_int32_t) function amst_mesh_set_markers(mesh, entity, ids, n, value) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            integer(c_int32_t), intent(in), optional :: ids(*)
            integer(c_int64_t), value :: n
            integer(c_int32_t), value :: value
        end function amst_mesh_set_markers

        integer(c_int32_t) function amst_mesh_get_markers(mesh, entity, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_markers

        integer(c_int32_t) function amst_mesh_get_marker_list(mesh, entity, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_marker_list

        integer(c_int32_t) function amst_mesh_set_marker_name(mesh, entity, marker, name) bind(c)
            import :: c_char, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity, marker
            character(kind=c_char), intent(in), optional :: name(*)
        end function amst_mesh_set_marker_name

        integer(c_int32_t) function amst_mesh_get_marker_name(mesh, entity, marker, out, capacity, needed) bind(c)
            import :: c_char, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity, marker
            character(kind=c_char), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_marker_name

        ! fields

        integer(c_int32_t) function amst_mesh_set_field(mesh, entity, name, components, carry, values, n) bind(c)
            import :: c_char, c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            character(kind=c_char), intent(in) :: name(*)
            integer(c_int32_t), value :: components, carry
            real(c_double), intent(in) :: values(*)
            integer(c_int64_t), value :: n
        end function amst_mesh_set_field

        integer(c_int32_t) function amst_mesh_get_field(mesh, entity, name, out, capacity, needed) bind(c)
            import :: c_char, c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            character(kind=c_char), intent(in) :: name(*)
            real(c_double), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_field

        integer(c_int32_t) function amst_mesh_remove_field(mesh, entity, name) bind(c)
            import :: c_char, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: entity
            character(kind=c_char), intent(in) :: name(*)
        end function amst_mesh_remove_field

        integer(c_int32_t) function amst_mesh_size_from_indicator(mesh, indicator, n, tolerance, faces, options, &
                asked_faces) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), intent(in), optional :: indicator(*)
            integer(c_int64_t), value :: n
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: faces
            type(c_ptr), value :: options
            real(c_double), intent(inout), optional :: asked_faces
        end function amst_mesh_size_from_indicator

        integer(c_int32_t) function amst_mesh_get_overlap(before, after, before_faces, after_faces, areas, &
                capacity, needed) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: before
            type(c_ptr), value :: after
            integer(c_int32_t), intent(inout), optional :: before_faces(*)
            integer(c_int32_t), intent(inout), optional :: after_faces(*)
            real(c_double), intent(inout), optional :: areas(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_overlap

        integer(c_int32_t) function amst_mesh_compute_cross_field(mesh, options) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
        end function amst_mesh_compute_cross_field

        integer(c_int32_t) function amst_mesh_get_alignment(mesh, mean_degrees) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), intent(inout) :: mean_degrees
        end function amst_mesh_get_alignment

        ! surface

        integer(c_int32_t) function amst_mesh_set_surface(mesh, points, n_points, triangles, n_triangles) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            real(c_double), intent(in), optional :: points(*)
            integer(c_int64_t), value :: n_points
            integer(c_int32_t), intent(in), optional :: triangles(*)
            integer(c_int64_t), value :: n_triangles
        end function amst_mesh_set_surface

        ! boundary

        integer(c_int32_t) function amst_mesh_set_projection(mesh, fn, user) bind(c)
            import :: c_funptr, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
        end function amst_mesh_set_projection

        ! undoing

        integer(c_int32_t) function amst_mesh_mark(mesh, revision) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), intent(inout) :: revision
        end function amst_mesh_mark

        integer(c_int32_t) function amst_mesh_rollback(mesh, revision) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: revision
        end function amst_mesh_rollback

        integer(c_int32_t) function amst_mesh_forget(mesh, revision) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: revision
        end function amst_mesh_forget
    end interface
end module amst_c_mesh
