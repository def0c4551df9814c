!> What the tests share: claims, a grid of unit squares, and the end of a program.
module checks
    use, intrinsic :: iso_fortran_env, only: error_unit, int32, int64, real64
    use alphamst
    implicit none
    private

    public :: claim, refused, finish, new_grid, square, grid_points, grid_faces

    integer :: failures = 0

contains

    subroutine claim(holds, what)
        logical, intent(in) :: holds
        character(len=*), intent(in) :: what

        if (holds) return
        failures = failures + 1
        write (error_unit, '(a)') 'does not hold: '//what
    end subroutine claim

    !> A call has failed with this status and has said why.
    subroutine refused(stat, wanted, errmsg, what)
        integer(int32), intent(in) :: stat, wanted
        character(len=*), intent(inout) :: errmsg
        character(len=*), intent(in) :: what

        call claim(stat == wanted, what//' is '//alphamst_status_name(wanted)//', not '//alphamst_status_name(stat))
        call claim(len_trim(errmsg) > 0, what//' is explained')
        errmsg = ''
    end subroutine refused

    subroutine finish()
        if (failures > 0) error stop 1
    end subroutine finish

    !> Vertex (i, j), 0 <= i <= nx, is number 1 + i + j*(nx + 1) and lies at (i, j).
    function grid_points(nx, ny) result(points)
        integer, intent(in) :: nx, ny
        real(real64) :: points(2, (nx + 1)*(ny + 1))
        integer :: i, j

        do j = 0, ny
            do i = 0, nx
                points(:, 1 + i + j*(nx + 1)) = [i, j]
            end do
        end do
    end function grid_points

    !> Face (i, j), 0 <= i < nx, is number 1 + i + j*nx.
    function grid_faces(nx, ny) result(faces)
        integer, intent(in) :: nx, ny
        integer(int32) :: faces(4, nx*ny)
        integer :: i, j, v

        do j = 0, ny - 1
            do i = 0, nx - 1
                v = 1 + i + j*(nx + 1)
                faces(:, 1 + i + j*nx) = [v, v + 1, v + nx + 2, v + nx + 1]
            end do
        end do
    end function grid_faces

    subroutine new_grid(mesh, context, nx, ny)
        type(amst_mesh), intent(inout) :: mesh
        type(amst_context), intent(in) :: context
        integer, intent(in) :: nx, ny

        call mesh%create(context, grid_points(nx, ny), grid_faces(nx, ny))
    end subroutine new_grid

    !> The faces (i, j), low <= i, j < high, of a grid of nx columns.
    function square(nx, low, high) result(faces)
        integer, intent(in) :: nx, low, high
        integer(int32) :: faces((high - low)**2)
        integer :: i, j

        faces = [((1 + i + j*nx, i=low, high - 1), j=low, high - 1)]
    end function square

end module checks
