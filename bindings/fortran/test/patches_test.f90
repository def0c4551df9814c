program patches_test
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none
    type(amst_context) :: context
    type(amst_mesh) :: mesh

    call context%create()
    call new_grid(mesh, context, 10, 10)
    call ways_to_add()
    call decompositions_cover_the_rest()
    call boundary_and_corners()
    call defects_and_convexity()
    call predictions()
    call alphas()
    call options_count()
    call errors()
    call pictures()
    call finish()

contains

    subroutine ways_to_add()
        type(amst_patches) :: patches
        integer(int32) :: patch

        call patches%create(mesh)
        call claim(patches%count() == 0, 'no patch at first')
        call patches%add_faces([23, 12, 22, 13, 23], patch)
        call claim(patch == 1, 'patches count from 1')
        call claim(all(patches%faces(1) == [12, 13, 22, 23]), 'faces, ascending')
        call patches%add_rings(1 + 8 + 2*11, 2, patch) ! around (8, 2)
        call claim(size(patches%faces(2)) == 16 .and. patch == 2, 'rings')
        call patches%add_ball([8.0_real64, 8.0_real64, 0.0_real64], 1.0_real64, patch)
        call claim(all(patches%faces(3) == [78, 79, 88, 89]) .and. patch == 3, 'ball')
        call patches%add_box([0.0_real64, 6.0_real64, -1.0_real64], [3.0_real64, 9.0_real64, 1.0_real64], patch)
        call claim(all(patches%faces(4) == [61, 62, 63, 71, 72, 73, 81, 82, 83]) .and. patch == 4, 'box')
        call claim(patches%count() == 4, 'four patches')
    end subroutine ways_to_add

    subroutine decompositions_cover_the_rest()
        type(amst_patches) :: patches
        type(amst_options) :: options
        integer(int64) :: added
        integer(int32) :: method, patch, covered, stat
        character(len=200) :: errmsg

        call options%create()
        call options%set(AMST_OPT_PATCH_FACES, 12.0_real64)
        do method = AMST_DECOMPOSE_CLUSTERS, AMST_DECOMPOSE_VORONOI
            call patches%create(mesh, options)
            call patches%decompose(method, added)
            call claim(patches%count() == added .and. added >= 4, 'number of new patches')
            covered = 0
            do patch = 1, int(added, int32)
                covered = covered + size(patches%faces(patch))
            end do
            call claim(covered > 80, 'faces covered')
        end do
        call patches%create(mesh, options)
        call patches%decompose(AMST_DECOMPOSE_MEDIAL, added)
        call claim(added >= 2, 'discs')
        do patch = 1, int(added, int32)
            covered = size(patches%faces(patch))
            call claim(covered >= 3 .and. covered <= 12, 'faces of a disc')
        end do
        call patches%create(mesh, options)
        call patches%decompose(AMST_DECOMPOSE_SINGULARITIES, added)
        call claim(patches%count() == 0 .and. added == 0, 'a grid has no singularities')
        call patches%decompose(7, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'method 7')
    end subroutine decompositions_cover_the_rest

    subroutine boundary_and_corners()
        type(amst_patches) :: patches
        integer(int32) :: row(12), stat
        integer(int64) :: n
        character(len=200) :: errmsg

        call patches%create(mesh)
        call patches%add_faces(square(10, 2, 5))
        associate (boundary => patches%boundary(1), corners => patches%corners(1))
            call claim(size(boundary) == 12 .and. size(corners) == 4, 'sizes of boundary and corners')
            call claim(boundary(1) == corners(1), 'the boundary starts at the first corner')
            call claim(any(corners == 25) .and. any(corners == 61), 'corners of the square')
        end associate
        call patches%get_boundary(1, row, n)
        call claim(all(row == patches%boundary(1)) .and. n == 12, 'boundary in place')
        call patches%get_faces(1, row, n)
        call claim(all(row(:9) == patches%faces(1)) .and. n == 9, 'faces in place')
        call patches%get_faces(1, row(:8), n, stat, errmsg)
        call refused(stat, AMST_ERR_BUFFER_TOO_SMALL, errmsg, 'room for 8 faces')
        call claim(n == 9, 'room that is needed')

        call patches%set_corners(1, [61, 58, 26])
        call claim(all(patches%corners(1) == [61, 58, 26]), 'corners that were set')
        call patches%get_corners(1, row, n)
        call claim(all(row(:3) == [61, 58, 26]) .and. n == 3, 'corners in place')
        call patches%get_boundary(1, row)
        call claim(row(1) == 61, 'the boundary starts there')
        call patches%set_corners(1, [integer(int32) ::])
        call claim(size(patches%corners(1)) == 4, 'corners of the library again')
        call patches%set_corners(1, [25, 28], stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'two corners')
    end subroutine boundary_and_corners

    subroutine defects_and_convexity()
        type(amst_patches) :: patches
        integer(int32) :: defects
        real(real64) :: convexity

        call patches%create(mesh)
        call patches%add_faces(square(10, 0, 3))
        call patches%check(1, defects, convexity)
        call claim(defects == 0 .and. abs(convexity - 1) < 1e-12_real64, 'a square')
        call patches%add_faces([46, 45, 47, 36, 56]) ! a cross, 5 of a hull of 7
        call patches%check(2, defects, convexity)
        call claim(defects == 0 .and. abs(convexity - 5/7.0_real64) < 1e-12_real64, 'a cross')
        call patches%set_corners(1, [1, 4, 13])
        call patches%check(1, defects)
        call claim(defects == AMST_DEFECT_CORNERS, 'a corner that is inside')
    end subroutine defects_and_convexity

    subroutine predictions()
        type(amst_patches) :: patches
        type(amst_options) :: options
        integer(int64) :: faces, singularities
        integer(int32) :: stat
        character(len=200) :: errmsg

        call options%create()
        call patches%create(mesh)
        call patches%add_faces(square(10, 2, 6))
        singularities = -1
        call patches%predict(1, 1.0_real64, options, faces, singularities)
        call claim(faces == 16 .and. singularities == 0, 'a square as it is')
        call patches%predict(1, 2.0_real64, faces=faces)
        call claim(faces == 32 .and. singularities == 0, 'twice the faces')
        call patches%predict(1, 2.0_real64, singularities=singularities)
        call claim(faces == 32 .and. singularities >= 4, 'with singularities')
        call patches%predict(1, 0.0_real64, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'alpha 0')
    end subroutine predictions

    subroutine alphas()
        type(amst_mesh) :: copy
        type(amst_patches) :: patches
        type(amst_report) :: report
        integer(int32) :: stat
        character(len=200) :: errmsg

        copy = mesh
        call patches%create(copy)
        call patches%add_faces(square(10, 1, 5))
        call patches%add_faces(square(10, 5, 9))
        call patches%set_alpha(3.0_real64)
        call patches%set_alpha(1.5_real64, 2)
        call alphamst_adapt(copy, patches, 1.0_real64, report=report)
        call claim(report%get_int(AMST_RESULT_FACES_WANTED, 1) == 48, 'alpha of all')
        call claim(report%get_int(AMST_RESULT_FACES_WANTED, 2) == 24, 'alpha of one')
        call patches%set_alpha(-1.0_real64, 2, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'alpha -1')
        call patches%set_alpha(1.0_real64, 3, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'patch 3')
    end subroutine alphas

    subroutine options_count()
        type(amst_patches) :: patches
        type(amst_options) :: options
        integer(int32) :: defects, stat, entity, id, patch
        character(len=200) :: errmsg

        call options%create()
        call options%set(AMST_OPT_REPAIR_PATCHES, 0)
        call patches%create(mesh, options)
        call patches%add_faces([1, 2, 3, 11, 13, 21, 22, 23]) ! around face 12
        call patches%check(1, defects)
        call claim(iand(defects, AMST_DEFECT_NOT_DISK) /= 0, 'a ring without repair')
        call claim(size(patches%boundary(1, stat, errmsg)) == 0, 'no boundary of a ring')
        call refused(stat, AMST_ERR_PATCH, errmsg, 'boundary of a ring')
        call alphamst_last_error_where(patch=patch)
        call claim(patch == 1, 'place of a patch')
        call patches%add_faces([5, 3], stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_PATCH, errmsg, 'a face that is taken')
        call alphamst_last_error_where(entity, id, patch)
        call claim(entity == AMST_FACE .and. id == 3 .and. patch == 1, 'place of a taken face')
        call patches%create(mesh)
        call patches%add_faces([1, 2, 3, 11, 13, 21, 22, 23])
        call claim(size(patches%faces(1)) == 9, 'a ring with repair')
    end subroutine options_count

    subroutine errors()
        type(amst_mesh) :: copy
        type(amst_patches) :: patches
        integer(int32) :: patch, stat
        character(len=200) :: errmsg
        real(real64), parameter :: origin(3) = 0, ones(3) = 1

        patch = 77
        call patches%add_rings(1, 1, patch, stat, errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'a set never created')
        copy = mesh
        call patches%create(copy)
        call patches%add_faces([5, 101], patch, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'face 101')
        call patches%add_faces([integer(int32) ::], patch, stat, errmsg)
        call refused(stat, AMST_ERR_PATCH, errmsg, 'no faces')
        call patches%add_rings(122, 1, patch, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'vertex 122')
        call patches%add_ball(origin, -1.0_real64, patch, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'radius -1')
        call patches%add_box(ones, origin, patch, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'low above high')
        call claim(patch == 77, 'nothing is written')
        call patches%add_rings(13, 1)
        call copy%set_flags(AMST_FACE, [100], AMST_FLAG_FIXED, AMST_FLAG_FIXED)
        call alphamst_clean(copy)
        call copy%destroy()
        call claim(patches%count() == 1, 'the set outlives its mesh variable')
    end subroutine errors

    subroutine pictures()
        type(amst_patches) :: patches
        integer(int32) :: stat
        integer :: unit
        character(len=200) :: errmsg
        character(len=8) :: start

        call patches%create(mesh)
        call patches%add_faces([12])
        call patches%write('patches_test.svg')
        open (newunit=unit, file='patches_test.svg', status='old', action='read')
        read (unit, '(a)') start
        call claim(start(1:1) == '<', 'a picture')
        close (unit, status='delete')
        call patches%write('patches_test.vtk', stat, errmsg)
        call refused(stat, AMST_ERR_UNSUPPORTED, errmsg, 'a picture that is none')
    end subroutine pictures

end program patches_test
