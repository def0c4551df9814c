program version
    use, intrinsic :: iso_c_binding, only: c_int32_t
    implicit none

    interface
        function amst_version() bind(c, name='amst_version') result(number)
            import :: c_int32_t
            implicit none
            integer(c_int32_t) :: number
        end function amst_version
    end interface

    integer(c_int32_t) :: number

    number = amst_version()
    print '(a,i0,a,i0,a,i0)', 'AlphaMST ', number/10000, '.', mod(number/100, 100), '.', mod(number, 100)
    if (number < 100 .or. number > 999999) error stop 'not a version of AlphaMST'
end program version
