program geometry_test
    use, intrinsic :: iso_fortran_env, only: int32, real64
    use alphamst
    use checks
    implicit none
    type(amst_context) :: context
    type(amst_mesh) :: mesh

    call context%create()
    call new_grid(mesh, context, 4, 4)
    call normals_point_out_of_the_first_face()
    call faces_are_around_their_vertices()
    call finish()

contains

    subroutine normals_point_out_of_the_first_face()
        real(real64), allocatable :: none(:, :)
        integer(int32) :: stat, e
        character(len=200) :: errmsg
        logical :: outwards

        associate (centroids => mesh%geometry(AMST_GEOMETRY_CENTROIDS), lengths => mesh%geometry(AMST_GEOMETRY_LENGTHS), &
                normals => mesh%geometry(AMST_GEOMETRY_NORMALS), points => mesh%points(), edges => mesh%edges(), &
                sides => mesh%edge_faces())
            call claim(all(shape(centroids) == [2, 16]), 'shape of centroids')
            call claim(all(shape(lengths) == [1, 40]), 'shape of lengths')
            call claim(maxval(abs(lengths - 1)) <= 0, 'lengths')
            call claim(all(shape(normals) == [2, 40]), 'shape of normals')
            outwards = .true.
            do e = 1, 40
                associate (middle => (points(:, edges(1, e)) + points(:, edges(2, e)))/2)
                    outwards = outwards .and. &
                        abs(dot_product(normals(:, e), middle - centroids(:, sides(1, e))) - 0.5_real64) < 1e-14_real64
                end associate
            end do
            call claim(outwards, 'out of the first face')
        end associate
        allocate (none(1, 1)) ! else gfortran warns of bounds that it reads, though it need not
        none = mesh%geometry(99, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'no such geometry')
        call claim(size(none) == 0, 'a failed function is empty')
    end subroutine normals_point_out_of_the_first_face

    subroutine faces_are_around_their_vertices()
        type(amst_mesh) :: nothing
        integer(int32), allocatable :: offsets(:), around(:)
        integer(int32) :: v, i, stat
        character(len=200) :: errmsg
        logical :: at_it

        call mesh%vertex_faces(offsets, around)
        call claim(size(offsets) == 26 .and. size(around) == 64, 'extents')
        call claim(offsets(1) == 1 .and. offsets(26) == 65, 'from 1')
        at_it = .true.
        associate (faces => mesh%faces())
            do v = 1, 25
                do i = offsets(v), offsets(v + 1) - 1
                    at_it = at_it .and. any(faces(:, around(i)) == v)
                end do
            end do
        end associate
        call claim(at_it, 'each has the vertex')
        call nothing%vertex_faces(offsets, around, stat, errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'no mesh')
        call claim(size(offsets) == 0 .and. size(around) == 0, 'nothing')
    end subroutine faces_are_around_their_vertices

end program geometry_test
