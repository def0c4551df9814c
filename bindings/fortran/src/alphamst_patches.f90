!> Patch sets: disjoint regions of faces of one mesh, each to be replaced by an operation. Patches and
!> all ids count from 1.
!>
!> A set belongs to one revision of its mesh; operations given the set move it along, other changes
!> make it STALE. A call that takes a set as intent(inout) needs it and its mesh to itself.
module alphamst_patches
    use, intrinsic :: iso_c_binding, only: c_associated, c_null_ptr, c_ptr
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use amst_c, only: AMST_ALL, amst_patches_add_ball, amst_patches_add_box, amst_patches_add_faces, &
        amst_patches_add_rings, amst_patches_check, amst_patches_create, amst_patches_decompose, &
        amst_patches_destroy, amst_patches_get_boundary, amst_patches_get_corners, &
        amst_patches_get_count, amst_patches_get_faces, amst_patches_predict, amst_patches_set_alpha, &
        amst_patches_set_corners, amst_patches_write
    use alphamst_arrays, only: fetch_row_of, fill_row_of
    use alphamst_handle, only: amst_handle, handle_to_copy
    use alphamst_library, only: settle, to_c
    use alphamst_mesh, only: amst_mesh
    use alphamst_options, only: amst_options, handle_of_options
    implicit none
    private

    !> Sets cannot be assigned: that is an error stop. All procedures have the optional arguments stat
    !> and errmsg. Errors of all but create, destroy and count: STALE, RANGE (patch, face, vertex,
    !> count); of those that add: PATCH (no face would be left), NOT_FINITE. Their optional argument
    !> patch becomes the number of the new patch.
    type, extends(amst_handle), public :: amst_patches
    contains
        !> create(mesh [, options]): the options that count are REPAIR_PATCHES, PATCH_FACES,
        !> MIN_CONVEXITY and SEED. The mesh may end before the set.
        procedure :: create
        procedure :: destroy
        !> add_faces(faces(:) [, patch]): faces in any order; those taken or FIXED are left out, and
        !> the patch is made a disk or a ring, unless AMST_OPT_REPAIR_PATCHES is 0.
        procedure :: add_faces
        !> add_rings(vertex, rings [, patch]): the faces within so many layers of a vertex.
        procedure :: add_rings
        !> add_ball(center(3), radius [, patch]): the connected faces around the one nearest to center
        !> with their centroid within radius. A mesh of dim 2 lies in z = 0. Errors: ARGUMENT (radius).
        procedure :: add_ball
        !> add_box(low(3), high(3) [, patch]): faces with their centroid in the box, the largest
        !> connected part. Errors: ARGUMENT (low above high).
        procedure :: add_box
        !> decompose(method [, added]): AMST_DECOMPOSE_* patches over the faces not yet taken; added,
        !> kind int64, is their number. Errors: ARGUMENT (method).
        procedure :: decompose
        !> set_corners(patch, vertices(:)): 3 to 6 boundary vertices, counter-clockwise; none lets the
        !> library choose. Errors: RANGE.
        procedure :: set_corners
        !> set_alpha(alpha [, patch]): of one patch, or of all that are in the set now; 0 means that of
        !> the operation. Errors: ARGUMENT (alpha < 0), NOT_FINITE.
        procedure :: set_alpha
        !> Number of patches, kind int64
        procedure :: count => get_count
        !> faces(patch): ids, ascending; get_faces(patch, values [, n]) into an array of the caller,
        !> n is their number. Errors: BUFFER_TOO_SMALL.
        procedure :: faces, get_faces
        !> boundary(patch): vertices, counter-clockwise, from the first corner;
        !> get_boundary(patch, values [, n]). Errors: PATCH (not a disk).
        procedure :: boundary, get_boundary
        !> corners(patch): those that were set, or where one face fits; get_corners(patch, values [, n]).
        !> Errors: PATCH (not a disk).
        procedure :: corners, get_corners
        !> check(patch, defects [, convexity]): AMST_DEFECT_* bits, 0 if usable; area over that of the
        !> convex hull, 0..1.
        procedure :: check
        !> write(path): picture (.svg) of mesh, outlines and singularities. Errors: IO, UNSUPPORTED.
        procedure :: write => write_file
        !> predict(patch, alpha [, options, faces, singularities]): the numbers, kind int64, that
        !> alphamst_adapt would deliver. Errors: ARGUMENT (alpha <= 0), NOT_FINITE, PATCH, NO_FILLING.
        procedure :: predict
        procedure, private :: refuse_copy
        generic :: assignment(=) => refuse_copy
        final :: finalize
    end type amst_patches

contains

    subroutine create(self, mesh, options, stat, errmsg)
        class(amst_patches), intent(inout) :: self
        type(amst_mesh), intent(in) :: mesh
        type(amst_options), intent(in), optional :: options
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(int32) :: status

        handle = c_null_ptr
        status = amst_patches_create(mesh%c_handle(), handle_of_options(options), handle)
        if (status >= 0) call self%adopt(handle)
        call settle(status, stat, errmsg)
    end subroutine create

    subroutine destroy(self)
        class(amst_patches), intent(inout) :: self

        call amst_patches_destroy(self%release())
    end subroutine destroy

    impure elemental subroutine finalize(self)
        type(amst_patches), intent(inout) :: self

        call self%destroy()
    end subroutine finalize

    impure elemental subroutine refuse_copy(self, other)
        class(amst_patches), intent(inout) :: self
        class(amst_patches), intent(in) :: other

        if (c_associated(handle_to_copy(other))) error stop 'an amst_patches cannot be assigned: create another one'
        call self%destroy()
    end subroutine refuse_copy

    subroutine add_faces(self, faces, patch, stat, errmsg)
        class(amst_patches), intent(inout) :: self
        integer(int32), intent(in), contiguous :: faces(:)
        integer(int32), intent(inout), optional :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_patches_add_faces(self%c_handle(), faces, size(faces, kind=int64), patch), stat, errmsg)
    end subroutine add_faces

    subroutine add_rings(self, vertex, rings, patch, stat, errmsg)
        class(amst_patches), intent(inout) :: self
        integer(int32), intent(in) :: vertex, rings
        integer(int32), intent(inout), optional :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_patches_add_rings(self%c_handle(), vertex, rings, patch), stat, errmsg)
    end subroutine add_rings

    subroutine add_ball(self, center, radius, patch, stat, errmsg)
        class(amst_patches), intent(inout) :: self
        real(real64), intent(in) :: center(3), radius
        integer(int32), intent(inout), optional :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_patches_add_ball(self%c_handle(), center, radius, patch), stat, errmsg)
    end subroutine add_ball

    subroutine add_box(self, low, high, patch, stat, errmsg)
        class(amst_patches), intent(inout) :: self
        real(real64), intent(in) :: low(3), high(3)
        integer(int32), intent(inout), optional :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_patches_add_box(self%c_handle(), low, high, patch), stat, errmsg)
    end subroutine add_box

    subroutine decompose(self, method, added, stat, errmsg)
        class(amst_patches), intent(inout) :: self
        integer(int32), intent(in) :: method
        integer(int64), intent(inout), optional :: added
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_patches_decompose(self%c_handle(), method, added), stat, errmsg)
    end subroutine decompose

    subroutine set_corners(self, patch, vertices, stat, errmsg)
        class(amst_patches), intent(inout) :: self
        integer(int32), intent(in) :: patch
        integer(int32), intent(in), contiguous :: vertices(:)
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_patches_set_corners(self%c_handle(), patch, vertices, size(vertices, kind=int64)), &
            stat, errmsg)
    end subroutine set_corners

    subroutine set_alpha(self, alpha, patch, stat, errmsg)
        class(amst_patches), intent(inout) :: self
        real(real64), intent(in) :: alpha
        integer(int32), intent(in), optional :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32) :: which

        which = AMST_ALL
        if (present(patch)) which = patch
        call settle(amst_patches_set_alpha(self%c_handle(), which, alpha), stat, errmsg)
    end subroutine set_alpha

    function get_count(self, stat, errmsg) result(count)
        class(amst_patches), intent(in) :: self
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int64) :: count

        count = 0
        call settle(amst_patches_get_count(self%c_handle(), count), stat, errmsg)
    end function get_count

    function faces(self, patch, stat, errmsg) result(values)
        class(amst_patches), intent(in) :: self
        integer(int32), intent(in) :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)

        call fetch_row_of(amst_patches_get_faces, self%c_handle(), patch, values, stat, errmsg)
    end function faces

    subroutine get_faces(self, patch, values, n, stat, errmsg)
        class(amst_patches), intent(in) :: self
        integer(int32), intent(in) :: patch
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_row_of(amst_patches_get_faces, self%c_handle(), patch, values, n, stat, errmsg)
    end subroutine get_faces

    function boundary(self, patch, stat, errmsg) result(values)
        class(amst_patches), intent(in) :: self
        integer(int32), intent(in) :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)

        call fetch_row_of(amst_patches_get_boundary, self%c_handle(), patch, values, stat, errmsg)
    end function boundary

    subroutine get_boundary(self, patch, values, n, stat, errmsg)
        class(amst_patches), intent(in) :: self
        integer(int32), intent(in) :: patch
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_row_of(amst_patches_get_boundary, self%c_handle(), patch, values, n, stat, errmsg)
    end subroutine get_boundary

    function corners(self, patch, stat, errmsg) result(values)
        class(amst_patches), intent(in) :: self
        integer(int32), intent(in) :: patch
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: values(:)

        call fetch_row_of(amst_patches_get_corners, self%c_handle(), patch, values, stat, errmsg)
    end function corners

    subroutine get_corners(self, patch, values, n, stat, errmsg)
        class(amst_patches), intent(in) :: self
        integer(int32), intent(in) :: patch
        integer(int32), intent(inout), contiguous :: values(:)
        integer(int64), intent(out), optional :: n
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call fill_row_of(amst_patches_get_corners, self%c_handle(), patch, values, n, stat, errmsg)
    end subroutine get_corners

    subroutine check(self, patch, defects, convexity, stat, errmsg)
        class(amst_patches), intent(in) :: self
        integer(int32), intent(in) :: patch
        integer(int32), intent(inout) :: defects
        real(real64), intent(inout), optional :: convexity
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_patches_check(self%c_handle(), patch, defects, convexity), stat, errmsg)
    end subroutine check

    subroutine write_file(self, path, stat, errmsg)
        class(amst_patches), intent(in) :: self
        character(len=*), intent(in) :: path
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_patches_write(self%c_handle(), to_c(path)), stat, errmsg)
    end subroutine write_file

    subroutine predict(self, patch, alpha, options, faces, singularities, stat, errmsg)
        class(amst_patches), intent(in) :: self
        integer(int32), intent(in) :: patch
        real(real64), intent(in) :: alpha
        type(amst_options), intent(in), optional :: options
        integer(int64), intent(inout), optional :: faces, singularities
        integer(int32), intent(out), optional :: stat
        character(len=*), intent(inout), optional :: errmsg

        call settle(amst_patches_predict(self%c_handle(), patch, alpha, handle_of_options(options), &
            faces, singularities), stat, errmsg)
    end subroutine predict

end module alphamst_patches
