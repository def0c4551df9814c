!> The C interface of AlphaMST, function by function. Nothing is added: alphamst.h has the meaning
!> of every call, and its rules for errors, ownership, arrays, ids and threads hold here.
!>
!> Handles are type(c_ptr); c_null_ptr stands for NULL. An argument that may be NULL in C and is no
!> handle is optional: leave it out for NULL. Outputs are intent(inout), since a call that fails
!> leaves them as they were. Strings end with c_null_char.
module amst_c
    use amst_c_types
    use amst_c_context
    use amst_c_mesh
    use amst_c_operations
    implicit none
end module amst_c
