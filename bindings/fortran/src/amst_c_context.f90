!> The functions of the library, its errors, contexts and options; part of amst_c.
module amst_c_context
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_funptr, c_int32_t, c_int64_t, c_ptr
    implicit none
    private :: c_char, c_double, c_funptr, c_int32_t, c_int64_t, c_ptr

    interface
        ! library and errors

        integer(c_int32_t) function amst_version() bind(c)
            import :: c_int32_t
            implicit none
        end function amst_version

        type(c_ptr) function amst_version_string() bind(c)
            import :: c_ptr
            implicit none
        end function amst_version_string

        integer(c_int32_t) function amst_has(feature) bind(c)
            import :: c_char, c_int32_t
            implicit none
            character(kind=c_char), intent(in) :: feature(*)
        end function amst_has

        type(c_ptr) function amst_status_name(status) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            integer(c_int32_t), value :: status
        end function amst_status_name

        type(c_ptr) function amst_last_error() bind(c)
            import :: c_ptr
            implicit none
        end function amst_last_error

        integer(c_int32_t) function amst_last_error_where(entity, id, patch) bind(c)
            import :: c_int32_t
            implicit none
            integer(c_int32_t), intent(inout), optional :: entity, id, patch
        end function amst_last_error_where

        ! context

        integer(c_int32_t) function amst_context_create(index_base, out) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            integer(c_int32_t), value :: index_base
            type(c_ptr), intent(inout) :: out
        end function amst_context_create

        subroutine amst_context_destroy(ctx) bind(c)
            import :: c_ptr
            implicit none
            type(c_ptr), value :: ctx
        end subroutine amst_context_destroy

        integer(c_int32_t) function amst_context_set_threads(ctx, n) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            integer(c_int32_t), value :: n
        end function amst_context_set_threads

        integer(c_int32_t) function amst_context_set_log(ctx, level, fn, user) bind(c)
            import :: c_funptr, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            integer(c_int32_t), value :: level
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
        end function amst_context_set_log

        integer(c_int32_t) function amst_context_set_progress(ctx, fn, user) bind(c)
            import :: c_funptr, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
        end function amst_context_set_progress

        integer(c_int32_t) function amst_context_set_cancel(ctx, flag) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            integer(c_int32_t), value :: flag
        end function amst_context_set_cancel

        integer(c_int32_t) function amst_context_get_progress(ctx, fraction) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: ctx
            real(c_double), intent(inout) :: fraction
        end function amst_context_get_progress

        ! options

        integer(c_int32_t) function amst_options_create(out) bind(c)
            import :: c_int32_t, c_ptr
            implicit none
            type(c_ptr), intent(inout) :: out
        end function amst_options_create

        subroutine amst_options_destroy(options) bind(c)
            import :: c_ptr
            implicit none
            type(c_ptr), value :: options
        end subroutine amst_options_destroy

        integer(c_int32_t) function amst_options_set_int(options, key, value) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: options
            integer(c_int32_t), value :: key
            integer(c_int64_t), value :: value
        end function amst_options_set_int

        integer(c_int32_t) function amst_options_set_real(options, key, value) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: options
            integer(c_int32_t), value :: key
            real(c_double), value :: value
        end function amst_options_set_real

        integer(c_int32_t) function amst_options_get_int(options, key, value) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: options
            integer(c_int32_t), value :: key
            integer(c_int64_t), intent(inout) :: value
        end function amst_options_get_int

        integer(c_int32_t) function amst_options_get_real(options, key, value) bind(c)
            import :: c_double, c_int32_t, c_ptr
            implicit none
            type(c_ptr), value :: options
            integer(c_int32_t), value :: key
            real(c_double), intent(inout) :: value
        end function amst_options_get_real

        integer(c_int32_t) function amst_options_set_edges(options, vertices, n_edges) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: options
            integer(c_int32_t), intent(in) :: vertices(*)
            integer(c_int64_t), value :: n_edges
        end function amst_options_set_edges

        integer(c_int32_t) function amst_options_get_edges(options, out, capacity, needed) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            implicit none
            type(c_ptr), value :: options
            integer(c_int32_t), intent(inout), optional :: out(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: needed
        end function amst_options_get_edges
    end interface
end module amst_c_context
