!> Finite volumes of second order on the faces of a mesh: linear on each face, limited, in two stages a step.
module scheme
    use, intrinsic :: iso_fortran_env, only: int32, real64
    use alphamst
    use gas
    implicit none
    private

    !> Markers of the boundary.
    integer(int32), parameter, public :: wall = 1, inflow = 2, outflow = 3

    !> What the scheme needs of the mesh, taken once after each change of it.
    type, public :: volumes
        private
        real(real64), allocatable, public :: areas(:)     ! of faces
        real(real64), allocatable :: lengths(:)           ! of edges,
        real(real64), allocatable :: normals(:, :)        ! and out of their first face
        integer(int32), allocatable :: sides(:, :)        ! the faces of each edge, 0 beyond the boundary
        integer(int32), allocatable :: markers(:)
        real(real64), allocatable :: to_middle(:, :, :)   ! (2, 2, edge): from the centroid of each of its faces
        real(real64), allocatable :: to_other(:, :)       ! from centroid to centroid, or to the mirrored one
        real(real64), allocatable :: gradient_of(:, :, :) ! (2, 2, face): what turns sums of differences into it
        real(real64) :: entering(4)                       ! the primitive state at the inflow
    contains
        procedure :: take
        procedure :: jumps
        procedure :: longest_step
        procedure :: advance
        procedure, private :: beyond, slopes, rates
    end type volumes

contains

    subroutine take(self, mesh, entering)
        class(volumes), intent(inout) :: self
        type(amst_mesh), intent(in) :: mesh
        real(real64), intent(in) :: entering(4)
        real(real64) :: m(2, 2)
        integer(int32) :: e, f, k
        self%entering = entering
        self%areas = mesh%quality(AMST_METRIC_AREA)
        self%lengths = reshape(mesh%geometry(AMST_GEOMETRY_LENGTHS), [mesh%count(AMST_EDGE)])
        self%normals = mesh%geometry(AMST_GEOMETRY_NORMALS)
        self%sides = mesh%edge_faces()
        self%markers = mesh%markers(AMST_EDGE)
        if (allocated(self%to_other)) deallocate (self%to_other, self%to_middle, self%gradient_of)
        allocate (self%to_other(2, size(self%lengths)), self%to_middle(2, 2, size(self%lengths)))
        allocate (self%gradient_of(2, 2, size(self%areas)), source=0.0_real64)
        associate (points => mesh%points(), edges => mesh%edges(), &
                centroids => mesh%geometry(AMST_GEOMETRY_CENTROIDS))
            do e = 1, size(self%lengths)
                associate (middle => sum(points(:, edges(:, e)), 2) / 2, sides => self%sides(:, e))
                    self%to_middle(:, 1, e) = middle - centroids(:, sides(1))
                    if (sides(2) > 0) then
                        self%to_middle(:, 2, e) = middle - centroids(:, sides(2))
                        self%to_other(:, e) = centroids(:, sides(2)) - centroids(:, sides(1))
                    else
                        self%to_other(:, e) = 2 * self%normals(:, e) * &
                            dot_product(self%to_middle(:, 1, e), self%normals(:, e))
                    end if
                    do k = 1, count(sides > 0)
                        self%gradient_of(:, :, sides(k)) = self%gradient_of(:, :, sides(k)) &
                            + outer(self%to_other(:, e))
                    end do
                end associate
            end do
        end associate
        do f = 1, size(self%areas) ! the inverse
            m = self%gradient_of(:, :, f)
            self%gradient_of(:, :, f) = reshape([m(2, 2), -m(2, 1), -m(1, 2), m(1, 1)], [2, 2]) &
                / (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1))
        end do
    end subroutine take

    !> d d' / |d|^2: differences count by one over the square of the distance.
    pure function outer(d) result(m)
        real(real64), intent(in) :: d(2)
        real(real64) :: m(2, 2)
        m = reshape([d(1) * d, d(2) * d], [2, 2]) / dot_product(d, d)
    end function outer

    !> The primitive state on the far side of an edge whose first face has w there.
    pure function beyond(self, w, e) result(other)
        class(volumes), intent(in) :: self
        real(real64), intent(in) :: w(4)
        integer(int32), intent(in) :: e
        real(real64) :: other(4)
        select case (self%markers(e))
        case (inflow)
            other = self%entering
        case (outflow)
            other = w
        case default
            other = mirrored(w, self%normals(:, e))
        end select
    end function beyond

    !> The greatest relative jump of the density between each face and its neighbours.
    function jumps(self, u) result(jump)
        class(volumes), intent(in) :: self
        real(real64), intent(in) :: u(:, :)
        real(real64) :: jump(size(u, 2)), here
        integer(int32) :: e
        jump = 0
        do e = 1, size(self%lengths)
            associate (sides => self%sides(:, e))
                if (sides(2) == 0) cycle
                here = abs(u(1, sides(1)) - u(1, sides(2))) / min(u(1, sides(1)), u(1, sides(2)))
                jump(sides) = max(jump(sides), here)
            end associate
        end do
    end function jumps

    !> In which no wave crosses more than half of a face.
    function longest_step(self, u) result(step)
        class(volumes), intent(in) :: self
        real(real64), intent(in) :: u(:, :)
        real(real64) :: step, crossing(size(u, 2)), w(4)
        integer(int32) :: e, k
        crossing = 0
        do e = 1, size(self%lengths)
            do k = 1, count(self%sides(:, e) > 0)
                associate (f => self%sides(k, e))
                    w = primitive(u(:, f))
                    crossing(f) = crossing(f) + self%lengths(e) / 2 &
                        * (abs(dot_product(w(2:3), self%normals(:, e))) + speed_of_sound(w))
                end associate
            end do
        end do
        step = minval(self%areas / crossing) / 2
    end function longest_step

    !> Two stages (Heun). `entered` grows by what came in over the boundary.
    subroutine advance(self, u, step, entered)
        class(volumes), intent(in) :: self
        real(real64), intent(inout) :: u(:, :), entered(4)
        real(real64), intent(in) :: step
        real(real64), dimension(4, size(u, 2)) :: first, second
        real(real64), dimension(4) :: came, come
        call self%rates(u, first, came)
        call self%rates(u + step * first, second, come)
        u = u + step / 2 * (first + second)
        entered = entered + step / 2 * (came + come)
    end subroutine advance

    !> How fast means change: d/dt u, and what comes in over the boundary.
    subroutine rates(self, u, rate, entering)
        class(volumes), intent(in) :: self
        real(real64), intent(in) :: u(:, :)
        real(real64), intent(out) :: rate(:, :), entering(4)
        real(real64) :: w(4, size(u, 2)), slope(4, 2, size(u, 2)), left(4), right(4), f(4)
        integer(int32) :: e
        do e = 1, size(u, 2)
            w(:, e) = primitive(u(:, e))
        end do
        call self%slopes(w, slope)
        rate = 0
        entering = 0
        do e = 1, size(self%lengths)
            associate (a => self%sides(1, e), b => self%sides(2, e))
                left = w(:, a) + matmul(slope(:, :, a), self%to_middle(:, 1, e))
                if (b > 0) then
                    right = w(:, b) + matmul(slope(:, :, b), self%to_middle(:, 2, e))
                else
                    right = self%beyond(left, e)
                end if
                f = self%lengths(e) * flow(left, right, self%normals(:, e))
                rate(:, a) = rate(:, a) - f / self%areas(a)
                if (b > 0) then
                    rate(:, b) = rate(:, b) + f / self%areas(b)
                else
                    entering = entering - f
                end if
            end associate
        end do
    end subroutine rates

    !> Gradients that fit the neighbours best, made less steep until the middles of edges are within the range
    !> of the neighbours (Barth and Jespersen).
    subroutine slopes(self, w, slope)
        class(volumes), intent(in) :: self
        real(real64), intent(in) :: w(:, :)
        real(real64), intent(out) :: slope(:, :, :) ! (4, 2, face)
        real(real64), dimension(4, size(w, 2)) :: least, most, limit
        real(real64) :: change(4)
        integer(int32) :: e, f, k
        slope = 0
        least = 0
        most = 0
        do e = 1, size(self%lengths)
            associate (a => self%sides(1, e), b => self%sides(2, e), d => self%to_other(:, e))
                if (b > 0) then
                    change = w(:, b) - w(:, a)
                else
                    change = self%beyond(w(:, a), e) - w(:, a)
                end if
                do k = 1, count(self%sides(:, e) > 0)
                    f = self%sides(k, e)
                    slope(:, 1, f) = slope(:, 1, f) + change * (d(1) / dot_product(d, d))
                    slope(:, 2, f) = slope(:, 2, f) + change * (d(2) / dot_product(d, d))
                    least(:, f) = min(least(:, f), merge(change, -change, k == 1))
                    most(:, f) = max(most(:, f), merge(change, -change, k == 1))
                end do
            end associate
        end do
        do f = 1, size(w, 2)
            slope(:, :, f) = matmul(slope(:, :, f), self%gradient_of(:, :, f))
        end do
        limit = 1
        do e = 1, size(self%lengths)
            do k = 1, count(self%sides(:, e) > 0)
                f = self%sides(k, e)
                change = matmul(slope(:, :, f), self%to_middle(:, k, e))
                where (change > most(:, f))
                    limit(:, f) = min(limit(:, f), most(:, f) / change)
                else where (change < least(:, f))
                    limit(:, f) = min(limit(:, f), least(:, f) / change)
                end where
            end do
        end do
        do k = 1, 2
            slope(:, k, :) = slope(:, k, :) * limit
        end do
    end subroutine slopes

end module scheme
