program options_test
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use alphamst
    use checks
    implicit none

    call defaults_and_changes()
    call errors()
    call assignment_copies_every_key()
    call edges_are_not_crossed()
    call finish()

contains

    subroutine defaults_and_changes()
        type(amst_options) :: options

        call options%create()
        call claim(options%get_int(AMST_OPT_SEED) == 0, 'seed')
        call claim(options%get_int(AMST_OPT_SMOOTH_STEPS) == 20, 'smooth steps')
        call claim(options%get_int(AMST_OPT_REPAIR_PATCHES) == 1, 'repair')
        call claim(options%get_int(AMST_OPT_CANDIDATES) == 16, 'candidates')
        call claim(options%get_int(AMST_OPT_NODE_LIMIT) == 1000, 'node limit')
        call claim(options%get_int(AMST_OPT_QUADRANGULATE) == 0, 'quadrangulate')
        call claim(options%get_int(AMST_OPT_CHART) == 0, 'chart')
        call claim(options%get_int(AMST_OPT_KEEP_BOUNDARY) == 0, 'keep boundary')
        call claim(options%get_int(AMST_OPT_STARTS) == 1, 'starts')
        call claim(abs(options%get_real(AMST_OPT_MIN_QUALITY)) <= 0, 'quality')
        call claim(abs(options%get_real(AMST_OPT_MIN_CONVEXITY) - 0.6_real64) <= 0, 'convexity')
        call claim(abs(options%get_real(AMST_OPT_PATCH_FACES) - 100) <= 0, 'patch faces')
        call claim(abs(options%get_real(AMST_OPT_TOLERANCE) - 0.5_real64) <= 0, 'tolerance')
        call claim(abs(options%get_real(AMST_OPT_EFFORT) - 1) <= 0, 'effort')
        call claim(abs(options%get_real(AMST_OPT_SIZE_WEIGHT) - 0.7_real64) <= 0, 'weight of sizes')
        call claim(abs(options%get_real(AMST_OPT_TRANSITION) - 0.5_real64) <= 0, 'transition')
        call claim(abs(options%get_real(AMST_OPT_LEAST_SIZE) - 0.125_real64) <= 0, 'least size')
        call claim(abs(options%get_real(AMST_OPT_SHARP_ANGLE) - 40) <= 0, 'sharp angle')
        call claim(abs(options%get_real(AMST_OPT_SIZE_BAND)) <= 0, 'size band')
        call claim(options%get_int(AMST_OPT_BUFFER_LAYERS) == 2, 'buffer layers')
        call claim(abs(options%get_real(AMST_OPT_MIN_EDGE)) <= 0, 'least edge')
        call claim(abs(options%get_real(AMST_OPT_MAX_EDGE)) <= 0, 'largest edge')
        call claim(abs(options%get_real(AMST_OPT_GRADATION) - 0.2_real64) <= 0, 'gradation')
        call claim(abs(options%get_real(AMST_OPT_ERROR_ORDER) - 1) <= 0, 'order')
        call options%set(AMST_OPT_SEED, -2_int64**62)
        call claim(options%get_int(AMST_OPT_SEED) == -2_int64**62, 'a seed of 64 bits')
        call options%set(AMST_OPT_SMOOTH_STEPS, 7)
        call claim(options%get_int(AMST_OPT_SMOOTH_STEPS) == 7, 'a value of 32 bits')
        call options%set(AMST_OPT_PATCH_FACES, 12.5_real64)
        call claim(abs(options%get_real(AMST_OPT_PATCH_FACES) - 12.5_real64) <= 0, 'a real value')
    end subroutine defaults_and_changes

    subroutine edges_are_not_crossed()
        type(amst_context) :: context
        type(amst_options) :: options, copy
        type(amst_mesh) :: mesh
        real(real64), parameter :: points(2, 4) = reshape( &
            [0.0_real64, 0.0_real64, 1.0_real64, 0.0_real64, 1.0_real64, 1.0_real64, 0.0_real64, 1.0_real64], [2, 4])
        integer(int32), parameter :: triangles(3, 2) = reshape([1, 2, 3, 3, 4, 1], [3, 2])
        integer(int32), parameter :: diagonal(2, 1) = reshape([3, 1], [2, 1])
        integer(int32) :: stat
        character(len=200) :: errmsg

        call context%create()
        call options%create()
        call claim(size(options%edges()) == 0, 'no edges at first')
        call mesh%create(context, points, triangles, options)
        call claim(mesh%count(AMST_FACE) == 1, 'one quad')
        call options%set_edges(diagonal)
        copy = options
        call claim(all(copy%edges() == diagonal), 'edges are copied')
        call mesh%create(context, points, triangles, copy)
        call claim(mesh%count(AMST_FACE) > 1, 'the diagonal is not crossed')
        call claim(size(mesh%crossed_edges()) == 0, 'nothing is crossed')
        call copy%set_edges(diagonal(:, 1:0))
        call copy%set(AMST_OPT_QUADRANGULATE, 1)
        call mesh%create(context, points, triangles, copy)
        call claim(all(shape(mesh%split_edges()) == [3, 5]), 'all edges are split')
        call claim(minval(mesh%split_edges()) == 1, 'split edges count from 1')
        call options%set_edges(diagonal + 1)
        call mesh%create(context, points, triangles, options, stat, errmsg)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'no such edge')
        call options%set_edges(triangles, stat, errmsg)
        call refused(stat, AMST_ERR_ARGUMENT, errmsg, 'three vertices')
    end subroutine edges_are_not_crossed

    subroutine errors()
        type(amst_options) :: options
        integer(int32) :: stat
        integer(int64) :: value
        real(real64) :: real_value
        character(len=200) :: errmsg

        call options%set(AMST_OPT_SEED, 1, stat, errmsg)
        call refused(stat, AMST_ERR_NULL, errmsg, 'options never created')
        call options%create(stat, errmsg)
        call claim(stat == AMST_OK, 'create')
        call options%set(AMST_OPT_SMOOTH_STEPS, 1001, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'steps 1001')
        call options%set(AMST_OPT_NODE_LIMIT, 2_int64**40, stat, errmsg)
        call refused(stat, AMST_ERR_RANGE, errmsg, 'limit 2^40')
        call options%set(AMST_OPT_SEED, 0.5_real64, stat, errmsg)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'a real seed')
        value = options%get_int(AMST_OPT_PATCH_FACES, stat, errmsg)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'patch faces as an integer')
        real_value = options%get_real(AMST_OPT_SEED, stat, errmsg)
        call refused(stat, AMST_ERR_NOT_FOUND, errmsg, 'the seed as a real number')
        call claim(value == 0 .and. abs(real_value) <= 0, 'a failed function is 0')
    end subroutine errors

    subroutine assignment_copies_every_key()
        type(amst_options) :: a, b, none
        integer :: k

        call a%create()
        call b%create()
        do k = 0, AMST_OPT_BUFFER_LAYERS
            call a%set(k, merge(5 + k, changed(k), k < AMST_OPT_QUADRANGULATE .and. k /= AMST_OPT_REPAIR_PATCHES))
        end do
        do k = AMST_OPT_MIN_QUALITY, AMST_OPT_ERROR_ORDER
            call a%set(k, merge(9.0_real64, 0.05_real64*(k - 999), k == AMST_OPT_PATCH_FACES))
        end do
        b = a
        call a%destroy()
        do k = 0, AMST_OPT_BUFFER_LAYERS
            call claim(b%get_int(k) == merge(5 + k, changed(k), &
                k < AMST_OPT_QUADRANGULATE .and. k /= AMST_OPT_REPAIR_PATCHES), 'copied integer')
        end do
        do k = AMST_OPT_MIN_QUALITY, AMST_OPT_ERROR_ORDER
            call claim(abs(b%get_real(k) - merge(9.0_real64, 0.05_real64*(k - 999), &
                k == AMST_OPT_PATCH_FACES)) <= 0, 'copied real')
        end do
        b = b
        call claim(b%get_int(AMST_OPT_SEED) == 5, 'assigned to itself')
        b = none
        call claim(.not. b%exists(), 'assigned nothing')
    end subroutine assignment_copies_every_key

    !> Of keys that are 0 or 1: what is not their default.
    pure integer function changed(key)
        integer, intent(in) :: key

        changed = merge(0, merge(2, 1, key == AMST_OPT_STARTS), key == AMST_OPT_REPAIR_PATCHES)
    end function changed

end program options_test
