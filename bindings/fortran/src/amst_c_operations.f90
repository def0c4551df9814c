!> The functions of patches, operations, quality and reports; part of amst_c.
module amst_c_operations
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int32_t, c_int64_t, c_ptr
    use amst_c_types, only: amst_summary
    implicit none
    private :: c_char, c_double, c_int32_t, c_int64_t, c_ptr, amst_summary

    interface
        ! patches

        integer(c_int32_t) function amst_patches_create(mesh, options, out) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
            type(c_ptr), intent(inout) :: out
        end function amst_patches_create

        subroutine amst_patches_destroy(patches) bind(c)
            import :: c_ptr
            implicit none
            type(c_ptr), value :: patches
        end subroutine amst_patches_destroy

        integer(c_int32_t) function amst_patches_add_faces(patches, faces, n, patch) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), intent(in), optional :: faces(*)
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(inout), optional :: patch
        end function amst_patches_add_faces

        integer(c_int32_t) function amst_patches_add_rings(patches, vertex, rings, patch) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: vertex, rings
            integer(c_int32_t), intent(inout), optional :: patch
        end function amst_patches_add_rings

        integer(c_int32_t) function amst_patches_add_ball(patches, center, radius, patch) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            real(c_double), intent(in) :: center(3)
            real(c_double), value :: radius
            integer(c_int32_t), intent(inout), optional :: patch
        end function amst_patches_add_ball

        integer(c_int32_t) function amst_patches_add_box(patches, low, high, patch) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            real(c_double), intent(in) :: low(3), high(3)
            integer(c_int32_t), intent(inout), optional :: patch
        end function amst_patches_add_box

        integer(c_int32_t) function amst_patches_decompose(patches, method, added) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: method
            integer(c_int64_t), intent(inout), optional :: added
        end function amst_patches_decompose

        integer(c_int32_t) function amst_patches_set_corners(patches, patch, vertices, n) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(in), optional :: vertices(*)
            integer(c_int64_t), value :: n
        end function amst_patches_set_corners

        integer(c_int32_t) function amst_patches_set_alpha(patches, patch, alpha) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            real(c_double), value :: alpha
        end function amst_patches_set_alpha

        integer(c_int32_t) function amst_patches_get_count(patches, count) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int64_t), intent(inout) :: count
        end function amst_patches_get_count

        integer(c_int32_t) function amst_patches_get_faces(patches, patch, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_patches_get_faces

        integer(c_int32_t) function amst_patches_get_boundary(patches, patch, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_patches_get_boundary

        integer(c_int32_t) function amst_patches_get_corners(patches, patch, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_patches_get_corners

        integer(c_int32_t) function amst_patches_check(patches, patch, defects, convexity) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(inout) :: defects
            real(c_double), intent(inout), optional :: convexity
        end function amst_patches_check

        integer(c_int32_t) function amst_patches_write(patches, path) bind(c)
            import :: c_char, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            character(kind=c_char), intent(in) :: path(*)
        end function amst_patches_write

        integer(c_int32_t) function amst_patches_predict(patches, patch, alpha, options, faces, &
                singularities) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: patches
            integer(c_int32_t), value :: patch
            real(c_double), value :: alpha
            type(c_ptr), value :: options
            integer(c_int64_t), intent(inout), optional :: faces, singularities
        end function amst_patches_predict

        ! operations

        integer(c_int32_t) function amst_adapt(mesh, patches, alpha, options, report) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, patches
            real(c_double), value :: alpha
            type(c_ptr), value :: options
            type(c_ptr), intent(inout), optional :: report
        end function amst_adapt

        integer(c_int32_t) function amst_reduce_singularities(mesh, patches, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, patches, options
            type(c_ptr), intent(inout), optional :: report
        end function amst_reduce_singularities

        integer(c_int32_t) function amst_smooth(mesh, patches, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, patches, options
            type(c_ptr), intent(inout), optional :: report
        end function amst_smooth

        integer(c_int32_t) function amst_clean(mesh, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
            type(c_ptr), intent(inout), optional :: report
        end function amst_clean

        ! chords

        integer(c_int32_t) function amst_mesh_get_chord(mesh, edge, closed, crossings, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: edge
            integer(c_int32_t), intent(inout), optional :: closed
            integer(c_int64_t), intent(inout), optional :: crossings
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_chord

        integer(c_int32_t) function amst_mesh_get_chord_ids(mesh, n_chords, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int64_t), intent(inout), optional :: n_chords
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_chord_ids

        integer(c_int32_t) function amst_mesh_get_chords(mesh, property, options, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
            integer(c_int32_t), value :: property
            integer(c_int64_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_chords

        integer(c_int32_t) function amst_collapse_chord(mesh, edge, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
            integer(c_int32_t), value :: edge
            type(c_ptr), intent(inout), optional :: report
        end function amst_collapse_chord

        integer(c_int32_t) function amst_split_chord(mesh, edge, n, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, options
            integer(c_int32_t), value :: edge, n
            type(c_ptr), intent(inout), optional :: report
        end function amst_split_chord

        integer(c_int32_t) function amst_insert_chords(mesh, patches, n, options, report) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh, patches, options
            integer(c_int32_t), value :: n
            type(c_ptr), intent(inout), optional :: report
        end function amst_insert_chords

        ! quality

        integer(c_int32_t) function amst_mesh_get_quality(mesh, metric, out, capacity, needed) bind(c)
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: metric
            real(c_double), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_mesh_get_quality

        integer(c_int32_t) function amst_mesh_get_summary(mesh, metric, out) bind(c)
            import :: amst_summary, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: metric
            type(amst_summary), intent(inout) :: out
        end function amst_mesh_get_summary

        ! report

        subroutine amst_report_destroy(report) bind(c)
            import :: c_ptr
            implicit none
            type(c_ptr), value :: report
        end subroutine amst_report_destroy

        integer(c_int32_t) function amst_report_get_int(report, patch, key, value) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: report
            integer(c_int32_t), value :: patch, key
            integer(c_int64_t), intent(inout) :: value
        end function amst_report_get_int

        integer(c_int32_t) function amst_report_get_real(report, patch, key, value) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: report
            integer(c_int32_t), value :: patch, key
            real(c_double), intent(inout) :: value
        end function amst_report_get_real

        integer(c_int32_t) function amst_report_get_valence(report, patch, after, valence, count) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: report
            integer(c_int32_t), value :: patch, after, valence
            integer(c_int64_t), intent(inout) :: count
        end function amst_report_get_valence

        integer(c_int32_t) function amst_report_get_origin(report, entity, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: report
            integer(c_int32_t), value :: entity
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_report_get_origin
    end interface
end module amst_c_operations
