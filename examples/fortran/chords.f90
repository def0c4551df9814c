! Chords: those of a plate with a hole in colour; two rings more around the hole, and one less.
!
!   build/release/examples/fortran/chords examples/data/plate.off [chords_]
program chords
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    implicit none
    type(amst_context) :: context
    type(amst_mesh) :: mesh
    character(len=1024) :: path, prefix

    if (command_argument_count() < 1) error stop 'usage: chords MESH [PREFIX]'
    call get_command_argument(1, path)
    prefix = ''
    if (command_argument_count() > 1) call get_command_argument(2, prefix)
    call context%create()
    call mesh%read(context, path)
    print '(a16, a7, a10, a8, a8)', 'mesh            ', 'faces', 'singular', 'chords', 'closed'
    call show('read            ', 'read')
    call alphamst_split_chord(mesh, ring(), 2)
    call show('two rings in    ', 'in')
    call alphamst_collapse_chord(mesh, ring())
    call show('one ring out    ', 'out')

contains

    !> An edge of the shortest closed chord.
    function ring() result(edge)
        integer(int32) :: edge
        integer(int64), allocatable :: edges(:), lengths(:)
        logical, allocatable :: closed(:)

        allocate (edges, source=mesh%chords(AMST_CHORD_EDGE))
        allocate (lengths, source=mesh%chords(AMST_CHORD_LENGTH))
        allocate (closed, source=mesh%chords(AMST_CHORD_CLOSED) == 1)
        edge = int(edges(minloc(lengths, 1, closed)), int32)
    end function ring

    subroutine show(what, name)
        character(len=16), intent(in) :: what
        character(len=*), intent(in) :: name
        integer(int32), allocatable :: ids(:)

        allocate (ids, source=mesh%chord_ids())
        print '(a16, i7, i10, i8, i8)', what, mesh%count(AMST_FACE), size(mesh%singularities()), &
            maxval(ids), count(mesh%chords(AMST_CHORD_CLOSED) == 1)
        if (prefix == '') return
        call mesh%set_field(AMST_EDGE, 'chord', real(ids, real64), AMST_CARRY_DROP)
        call mesh%write(trim(prefix)//name//'.svg')
    end subroutine show

end program chords
