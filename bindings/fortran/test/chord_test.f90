!> Chords: queries, and operations that know their result.
program chord_test
    use, intrinsic :: iso_fortran_env, only: int32, int64
    use alphamst
    use checks, only: claim, finish, new_grid, refused, square
    implicit none
    type(amst_context) :: context

    call context%create()
    call queries()
    call rings_in_and_out()
    call refusals()
    call finish()

contains

    subroutine queries()
        type(amst_mesh) :: mesh
        integer(int32), allocatable :: ids(:), edges(:)
        integer(int64) :: n_chords, crossings
        integer(int32) :: stat
        logical :: closed
        character(len=200) :: errmsg

        call new_grid(mesh, context, 5, 3)
        n_chords = 0
        allocate (ids, source=mesh%chord_ids(n_chords))
        call claim(size(ids) == mesh%count(AMST_EDGE) .and. n_chords == 8, 'chords of a grid')
        call claim(minval(ids) == 1 .and. maxval(ids) == 8, 'numbered from 1')
        call claim(sum(mesh%chords(AMST_CHORD_LENGTH)) == 30, 'lengths sum up to twice the faces')
        allocate (edges, source=mesh%chord(1, closed, crossings))
        call claim(.not. closed .and. crossings == 0 .and. all(ids(edges) == ids(1)), 'chord of an edge')
        errmsg = ''
        call claim(size(mesh%chord(99, stat=stat, errmsg=errmsg)) == 0, 'no such edge')
        call refused(stat, AMST_ERR_RANGE, errmsg, 'edge 99')
        call claim(size(mesh%chords(99, stat=stat, errmsg=errmsg)) == 0, 'no such property')
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'property 99')
    end subroutine queries

    subroutine rings_in_and_out()
        type(amst_mesh) :: mesh
        type(amst_patches) :: patches
        integer(int64), allocatable :: edges(:), after(:)
        integer(int64) :: digest, mark
        integer :: ring

        call new_grid(mesh, context, 10, 10)
        call patches%create(mesh)
        call patches%add_faces(square(10, 2, 8))
        digest = mesh%checksum()
        call mesh%mark(mark)
        call alphamst_insert_chords(mesh, patches, 2)
        call claim(mesh%count(AMST_FACE) == 148, 'two rings')
        allocate (edges, source=mesh%chords(AMST_CHORD_EDGE))
        allocate (after, source=mesh%chords(AMST_CHORD_SINGULAR_AFTER))
        ring = findloc(mesh%chords(AMST_CHORD_CLOSED), 1_int64, 1)
        call claim(ring > 0, 'a closed chord')
        call alphamst_collapse_chord(mesh, int(edges(ring), int32))
        call claim(mesh%count(AMST_FACE) == 124, 'one ring less')
        call claim(size(mesh%singularities()) == after(ring), 'with the singular vertices foretold')
        call mesh%rollback(mark)
        call claim(mesh%checksum() == digest, 'undone')
    end subroutine rings_in_and_out

    subroutine refusals()
        type(amst_mesh) :: mesh
        type(amst_options) :: options
        integer(int32) :: stat
        integer(int64) :: digest
        character(len=200) :: errmsg

        call new_grid(mesh, context, 4, 4)
        digest = mesh%checksum()
        errmsg = ''
        call alphamst_collapse_chord(mesh, 1, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_CHORD, errmsg, 'a chord to the boundary')
        call alphamst_split_chord(mesh, 1, 1, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_CHORD, errmsg, 'a split of it')
        call alphamst_split_chord(mesh, 1, 0, stat=stat, errmsg=errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'no copies')
        call claim(all(mesh%chords(AMST_CHORD_REFUSAL) == AMST_REFUSAL_BOUNDARY), 'the reason')
        call claim(mesh%checksum() == digest, 'the mesh is as before')
        call options%create()
        call options%set(AMST_OPT_EDIT_BOUNDARY, 1)
        call claim(all(mesh%chords(AMST_CHORD_REFUSAL, options) == 0), 'allowed')
        call alphamst_split_chord(mesh, 1, 2, options)
        call claim(mesh%count(AMST_FACE) == 24, 'split')
        call alphamst_collapse_chord(mesh, 1, options)
        call claim(mesh%count(AMST_FACE) == 20, 'collapsed')
    end subroutine refusals

end program chord_test
