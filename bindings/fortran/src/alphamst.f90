!> AlphaMST: adaptation of quadrilateral meshes patch by patch.
!>
!>     use alphamst
!>     type(amst_context) :: context
!>     type(amst_mesh) :: mesh
!>     type(amst_patches) :: patches
!>
!>     call context%create()
!>     call mesh%read(context, 'in.msh')
!>     call patches%create(mesh)
!>     call patches%add_ball([5.8d0, 4.8d0, 0d0], 0.6d0)
!>     call alphamst_adapt(mesh, patches, 2d0)
!>
!> Types and constants have the names of the C interface, amst_ and AMST_, procedures that belong to
!> no type begin with alphamst_. Each module below has its own description; alphamst_library that of
!> the optional arguments stat and errmsg.
module alphamst
    use amst_c, only: &
        AMST_VERSION_MAJOR, AMST_VERSION_MINOR, AMST_VERSION_PATCH, AMST_ERR_INTERNAL, AMST_ERR_STATE, &
        AMST_ERR_NO_MEMORY, AMST_ERR_CANCELLED, AMST_ERR_UNSUPPORTED, AMST_ERR_FORMAT, AMST_ERR_IO, &
        AMST_ERR_NOT_FOUND, AMST_ERR_STALE, AMST_ERR_PATCH, AMST_ERR_NO_FILLING, AMST_ERR_GEOMETRY, &
        AMST_ERR_NOT_MANIFOLD, AMST_ERR_NOT_QUAD, AMST_ERR_NOT_FINITE, AMST_ERR_BUFFER_TOO_SMALL, &
        AMST_ERR_RANGE, AMST_ERR_ARGUMENT, AMST_ERR_NULL, AMST_OK, AMST_PARTIAL, AMST_ENTITY_NONE, &
        AMST_VERTEX, AMST_EDGE, AMST_FACE, AMST_FLAG_FIXED, AMST_FLAG_FEATURE, AMST_FLAG_CORNER, &
        AMST_CARRY_DROP, AMST_CARRY_INHERIT, AMST_CARRY_LINEAR, AMST_CARRY_CONSERVE, &
        AMST_DEFECT_EMPTY, AMST_DEFECT_NOT_CONNECTED, AMST_DEFECT_NOT_DISK, AMST_DEFECT_PINCHED, &
        AMST_DEFECT_OVERLAP, AMST_DEFECT_CROSSES_FEATURE, AMST_DEFECT_ODD_BOUNDARY, &
        AMST_DEFECT_CORNERS, AMST_DEFECT_NOT_CONVEX, AMST_DECOMPOSE_CLUSTERS, &
        AMST_CHORD_EDGE, AMST_CHORD_CLOSED, AMST_CHORD_LENGTH, AMST_CHORD_FACES, &
        AMST_CHORD_CROSSINGS, AMST_CHORD_TOUCHES, AMST_CHORD_SINGULARITIES, AMST_CHORD_REFUSAL, &
        AMST_CHORD_SINGULAR_AFTER, AMST_REFUSAL_CROSSING, AMST_REFUSAL_CLOSED, AMST_REFUSAL_BOUNDARY, &
        AMST_REFUSAL_FIXED, AMST_REFUSAL_FEATURE, AMST_REFUSAL_VALENCE, AMST_REFUSAL_DOUBLE, &
        AMST_ERR_CHORD, AMST_ERR_PROJECTION, AMST_OPT_QUADRANGULATE, AMST_OPT_EDIT_BOUNDARY, AMST_OPT_STRATEGY, &
        AMST_OPT_ALIGN, AMST_OPT_CHART, AMST_OPT_TOLERANCE, AMST_OPT_EFFORT, AMST_OPT_SIZE_WEIGHT, &
        AMST_OPT_TRANSITION, AMST_OPT_LEAST_SIZE, &
        AMST_DECOMPOSE_PARTITION, AMST_DECOMPOSE_VORONOI, AMST_DECOMPOSE_MEDIAL, &
        AMST_DECOMPOSE_SINGULARITIES, AMST_METRIC_AREA, AMST_METRIC_ASPECT_RATIO, AMST_METRIC_CONDITION, &
        AMST_METRIC_DISTORTION, AMST_METRIC_EDGE_RATIO, AMST_METRIC_JACOBIAN, AMST_METRIC_MAX_ANGLE, &
        AMST_METRIC_MIN_ANGLE, AMST_METRIC_ODDY, AMST_METRIC_RADIUS_RATIO, AMST_METRIC_RELATIVE_SIZE, &
        AMST_METRIC_SCALED_JACOBIAN, AMST_METRIC_SHAPE, AMST_METRIC_SHAPE_AND_SIZE, AMST_METRIC_SHEAR, &
        AMST_METRIC_SHEAR_AND_SIZE, AMST_METRIC_SKEW, AMST_METRIC_STRETCH, AMST_METRIC_TAPER, &
        AMST_METRIC_WARPAGE, AMST_OPT_SEED, AMST_OPT_SMOOTH_STEPS, AMST_OPT_REPAIR_PATCHES, &
        AMST_OPT_CANDIDATES, AMST_OPT_NODE_LIMIT, AMST_OPT_MIN_QUALITY, AMST_OPT_MIN_CONVEXITY, &
        AMST_OPT_PATCH_FACES, AMST_RESULT_STATUS, AMST_RESULT_FACES_BEFORE, AMST_RESULT_FACES_AFTER, &
        AMST_RESULT_FACES_WANTED, AMST_RESULT_SINGULAR_BEFORE, AMST_RESULT_SINGULAR_AFTER, &
        AMST_RESULT_SINGULAR_BOUND, AMST_RESULT_CANDIDATE, AMST_RESULT_UNUSED_OPTION, &
        AMST_RESULT_ALPHA, AMST_RESULT_QUALITY_BEFORE, AMST_RESULT_QUALITY_AFTER, AMST_RESULT_SECONDS, &
        AMST_RESULT_SIZE_ERROR_BEFORE, AMST_RESULT_SIZE_ERROR_AFTER, AMST_RESULT_LEAST_AREA_BEFORE, &
        AMST_RESULT_LEAST_AREA_AFTER, AMST_RESULT_TIME_STEP, AMST_RESULT_SHORTEST_EDGE_BEFORE, &
        AMST_RESULT_SHORTEST_EDGE_AFTER, AMST_RESULT_ASPECT_RATIO_BEFORE, AMST_RESULT_ASPECT_RATIO_AFTER, &
        AMST_LOG_OFF, AMST_LOG_ERROR, AMST_LOG_WARNING, AMST_LOG_INFO, AMST_LOG_DEBUG, AMST_ALL, &
        amst_summary
    use alphamst_library, only: alphamst_version, alphamst_version_string, alphamst_has, &
        alphamst_status_name, alphamst_last_error, alphamst_last_error_where
    use alphamst_context, only: amst_context, amst_progress_listener, amst_log_listener
    use alphamst_options, only: amst_options
    use alphamst_boundary, only: amst_projection
    use alphamst_mesh, only: amst_mesh
    use alphamst_patches, only: amst_patches
    use alphamst_report, only: amst_report
    use alphamst_operations, only: alphamst_adapt, alphamst_reduce_singularities, alphamst_smooth, &
        alphamst_clean, alphamst_collapse_chord, alphamst_split_chord, alphamst_insert_chords
    implicit none
    public
end module alphamst
