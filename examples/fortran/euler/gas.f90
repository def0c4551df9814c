!> An ideal gas: its states and what flows between two of them.
!>
!> Conserved are density, momentum and energy per area, (4); primitive are density, velocity and pressure.
module gas
    use, intrinsic :: iso_fortran_env, only: real64
    implicit none
    private

    public :: conserved, primitive, speed_of_sound, mirrored, behind_shock, flow

    real(real64), parameter :: gamma = 1.4_real64 ! air

contains

    pure function conserved(w) result(u)
        real(real64), intent(in) :: w(4)
        real(real64) :: u(4)
        u(1) = w(1)
        u(2:3) = w(1) * w(2:3)
        u(4) = w(4) / (gamma - 1) + w(1) * (w(2)**2 + w(3)**2) / 2
    end function conserved

    pure function primitive(u) result(w)
        real(real64), intent(in) :: u(4)
        real(real64) :: w(4)
        w(1) = u(1)
        w(2:3) = u(2:3) / u(1)
        w(4) = (gamma - 1) * (u(4) - (u(2)**2 + u(3)**2) / (2 * u(1)))
    end function primitive

    pure function speed_of_sound(w) result(speed)
        real(real64), intent(in) :: w(4)
        real(real64) :: speed
        speed = sqrt(gamma * w(4) / w(1))
    end function speed_of_sound

    !> What is on the other side of a wall.
    pure function mirrored(w, normal) result(other)
        real(real64), intent(in) :: w(4), normal(2)
        real(real64) :: other(4)
        other = w
        other(2:3) = w(2:3) - 2 * dot_product(w(2:3), normal) * normal
    end function mirrored

    !> Behind a shock of this Mach number that runs to the right into gas at rest (Rankine and Hugoniot).
    pure function behind_shock(mach, ahead) result(w)
        real(real64), intent(in) :: mach, ahead(4)
        real(real64) :: w(4)
        w(1) = ahead(1) * (gamma + 1) * mach**2 / ((gamma - 1) * mach**2 + 2)
        w(2) = 2 * (mach - 1 / mach) / (gamma + 1) * speed_of_sound(ahead)
        w(3) = 0
        w(4) = ahead(4) * (2 * gamma * mach**2 - gamma + 1) / (gamma + 1)
    end function behind_shock

    !> Of conserved quantities through an edge of length 1, from the left to the right state along the normal:
    !> HLLC, with the speeds of waves as Einfeldt has them (Toro, Riemann Solvers, chapter 10).
    pure function flow(left, right, normal) result(f)
        real(real64), intent(in) :: left(4), right(4), normal(2)
        real(real64) :: f(4), across(2), sound(2), root(2), speed, mean_sound, first, last, middle
        across = [dot_product(left(2:3), normal), dot_product(right(2:3), normal)]
        sound = [speed_of_sound(left), speed_of_sound(right)]
        root = sqrt([left(1), right(1)])
        root = root / sum(root)
        speed = sum(root * across)
        mean_sound = sqrt(sum(root * sound**2) + product(root) * (across(2) - across(1))**2 / 2)
        first = min(across(1) - sound(1), speed - mean_sound)
        last = max(across(2) + sound(2), speed + mean_sound)
        associate (push => [left(1) * (first - across(1)), right(1) * (last - across(2))])
            middle = (right(4) - left(4) + push(1) * across(1) - push(2) * across(2)) / (push(1) - push(2))
        end associate
        if (middle >= 0) then
            f = through(left, across(1), normal)
            if (first < 0) f = f + first * (star(left, across(1), first, middle, normal) - conserved(left))
        else
            f = through(right, across(2), normal)
            if (last > 0) f = f + last * (star(right, across(2), last, middle, normal) - conserved(right))
        end if
    end function flow

    pure function through(w, across, normal) result(f)
        real(real64), intent(in) :: w(4), across, normal(2)
        real(real64) :: f(4)
        f = conserved(w)
        f = across * f + w(4) * [0.0_real64, normal, across]
    end function through

    !> Between the wave of this speed and the contact, whose speed is `middle`.
    pure function star(w, across, speed, middle, normal) result(u)
        real(real64), intent(in) :: w(4), across, speed, middle, normal(2)
        real(real64) :: u(4)
        u = conserved(w)
        u(2:3) = u(2:3) + w(1) * (middle - across) * normal
        u(4) = u(4) + w(1) * (middle - across) * (middle + w(4) / (w(1) * (speed - across)))
        u = u * (speed - across) / (speed - middle)
    end function star

end module gas
