!> A context that ends in its own listener: nobody is called any more, and the operation goes on. The
!> addresses of the listeners, 64 bytes, stay behind, since the library still has them; that is why
!> this is a program of its own: a leak checker names them.
module last_words
    use, intrinsic :: iso_fortran_env, only: real64
    use alphamst
    implicit none

    type :: witness
        integer :: calls = 0
        type(amst_context), pointer :: context => null()
    end type witness

contains

    function end_context(fraction, stage, user) result(cancel)
        real(real64), intent(in) :: fraction
        character(len=*), intent(in) :: stage
        class(*), pointer, intent(in) :: user
        logical :: cancel

        cancel = fraction < 0 .or. stage == ''
        select type (user)
        type is (witness)
            user%calls = user%calls + 1
            call user%context%destroy()
        end select
    end function end_context

end module last_words

program context_end_test
    use, intrinsic :: iso_fortran_env, only: real64
    use alphamst
    use checks
    use last_words
    implicit none
    type(amst_context), target :: context
    type(amst_mesh) :: mesh
    type(amst_patches) :: patches
    type(amst_report) :: report
    type(witness), target :: seen

    call context%create()
    call new_grid(mesh, context, 10, 10)
    call patches%create(mesh)
    call patches%add_faces(square(10, 1, 5))
    call patches%add_faces(square(10, 5, 9))
    seen%context => context
    call context%set_progress(end_context, seen)
    call alphamst_adapt(mesh, patches, 2.0_real64, report=report)
    call claim(seen%calls == 1, 'the listener ends with the context')
    call claim(.not. context%exists(), 'the context is gone')
    call claim(report%get_int(AMST_RESULT_FACES_AFTER) == 64, 'the operation is done')
    call alphamst_smooth(mesh)
    call claim(seen%calls == 1, 'and nobody listens to the next one')
    call finish()
end program context_end_test
