!> One run: a shock goes through the channel, and the mesh with it if it shall.
module run
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use channel
    use gas
    use scheme
    implicit none
    private

    public :: solve

    !> Of the shock, which begins at x = 0.2 and at the end has nearly come through.
    real(real64), parameter :: mach = 2, begin = 0.2_real64, end_time = 0.55_real64
    real(real64), parameter :: ahead(4) = [1.4_real64, 0.0_real64, 0.0_real64, 1.0_real64] ! sound runs at 1
    !> Largest over least edge of an adapted mesh. Between two adaptations the shock passes at most so many
    !> faces as there are layers around it in which they are small.
    integer, parameter :: coarsening = 4, steps_between = 16, layers = 6
    !> A face is small enough if the density jumps by so much to the next one.
    real(real64), parameter :: jump = 0.02_real64
    !> Mass and energy of a mesh before and after it is adapted differ by no more than rounding.
    real(real64), parameter :: rounding = 1e-12_real64

    type, public :: outcome
        type(amst_mesh) :: mesh
        real(real64), allocatable :: density(:)
        integer :: steps = 0, adaptations = 0
        real(real64) :: seconds = 0, adapting = 0
        real(real64) :: lost(4) = 0    ! relative, by adaptations: mass, momentum and energy
        real(real64) :: balance(4) = 0 ! what there is in the end, less what there was and came in
    end type outcome

    type :: state
        type(amst_mesh) :: mesh
        type(volumes) :: volumes
        real(real64), allocatable :: u(:, :) ! means over faces
        real(real64) :: time = 0
    end type state

contains

    !> With edges of 1/n, or none shorter if adapted. Pictures get the prefix, and rows are printed, if it is
    !> there.
    subroutine solve(context, n, adapted, got, prefix)
        type(amst_context), intent(in) :: context
        integer, intent(in) :: n
        logical, intent(in) :: adapted
        type(outcome), intent(out) :: got
        character(len=*), intent(in), optional :: prefix
        type(state) :: now
        type(amst_options) :: options
        real(real64) :: began, ended, step, first(4), entered(4)
        integer :: k
        call cpu_time(began)
        call make_channel(now%mesh, context, merge(n / coarsening, n, adapted))
        call begin_at_rest(now)
        if (adapted) then
            options = rules(n)
            do k = 1, layers ! while faces are large few layers of them are enough
                call options%set(AMST_OPT_BUFFER_LAYERS, k)
                call adapt(now, options, got)
                call begin_at_rest(now)
            end do
        end if
        first = matmul(now%u, now%volumes%areas)
        entered = 0
        do while (now%time < end_time)
            if (adapted .and. mod(got%steps, steps_between) == 0) call adapt(now, options, got)
            if (present(prefix) .and. mod(got%steps, 8 * steps_between) == 0) call show(now, got, prefix)
            step = min(now%volumes%longest_step(now%u), end_time - now%time)
            call now%volumes%advance(now%u, step, entered)
            now%time = now%time + step
            got%steps = got%steps + 1
        end do
        if (present(prefix)) call show(now, got, prefix)
        call cpu_time(ended)
        got%seconds = ended - began
        got%balance = matmul(now%u, now%volumes%areas) - first - entered
        got%density = now%u(1, :)
        got%mesh = now%mesh
    end subroutine solve

    function rules(n) result(options)
        integer, intent(in) :: n
        type(amst_options) :: options
        call options%create()
        call options%set(AMST_OPT_MIN_EDGE, 1.0_real64 / n)
        call options%set(AMST_OPT_MAX_EDGE, real(coarsening, real64) / n)
        call options%set(AMST_OPT_SIZE_BAND, 0.7_real64)
        call options%set(AMST_OPT_EDIT_BOUNDARY, 1)
        call options%set(AMST_OPT_EFFORT, 0.05_real64) ! a mesh that lives for a few steps need not be the best
        call options%set(AMST_OPT_CANDIDATES, 2)
    end function rules

    subroutine begin_at_rest(now)
        type(state), intent(inout) :: now
        integer(int32) :: f
        real(real64) :: behind(4)
        behind = behind_shock(mach, ahead)
        associate (centroids => mesh_centroids(now%mesh))
            if (allocated(now%u)) deallocate (now%u)
            allocate (now%u(4, size(centroids, 2)))
            do f = 1, size(centroids, 2)
                now%u(:, f) = conserved(merge(behind, ahead, centroids(1, f) < begin))
            end do
        end associate
        call now%volumes%take(now%mesh, behind)
    end subroutine begin_at_rest

    function mesh_centroids(mesh) result(centroids)
        type(amst_mesh), intent(in) :: mesh
        real(real64), allocatable :: centroids(:, :)
        centroids = mesh%geometry(AMST_GEOMETRY_CENTROIDS)
    end function mesh_centroids

    !> From the error to the sizes, from these to the mesh, and the gas comes along.
    subroutine adapt(now, options, got)
        type(state), intent(inout) :: now
        type(amst_options), intent(in) :: options
        type(outcome), intent(inout) :: got
        real(real64) :: before(4), after(4), began, ended
        call cpu_time(began)
        before = matmul(now%u, now%volumes%areas)
        call now%mesh%set_field(AMST_FACE, 'gas', now%u, AMST_CARRY_CONSERVE)
        call now%mesh%size_from_indicator(now%volumes%jumps(now%u), jump, options=options)
        call alphamst_adapt(now%mesh, alpha=1.0_real64, options=options)
        now%u = now%mesh%field(AMST_FACE, 'gas')
        call now%volumes%take(now%mesh, behind_shock(mach, ahead))
        after = matmul(now%u, now%volumes%areas)
        got%lost = max(got%lost, abs(after - before) / abs(before(4)))
        got%lost(1) = max(got%lost(1), abs(after(1) / before(1) - 1))
        if (any(got%lost > rounding)) error stop 'an adaptation has lost mass, momentum or energy'
        got%adaptations = got%adaptations + 1
        call cpu_time(ended)
        got%adapting = got%adapting + ended - began
    end subroutine adapt

    subroutine show(now, got, prefix)
        type(state), intent(in) :: now
        type(outcome), intent(in) :: got
        character(len=*), intent(in) :: prefix
        character(len=1024) :: path
        real(real64) :: total(4)
        total = matmul(now%u, now%volumes%areas)
        print '(f7.4, 2i7, 2f19.15, 2es10.1)', now%time, got%steps, size(now%u, 2), total(1), total(4), &
            got%lost(1), got%lost(4)
        if (prefix == '') return
        write (path, '(a, i0.5, a)') trim(prefix), got%steps, '.svg'
        call now%mesh%write(path)
    end subroutine show

end module run
