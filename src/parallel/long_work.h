// Pieces of work that take seconds each, on threads of their own.
#pragma once

#include <cstddef>
#include <functional>

namespace alphamst::parallel {

// Calls work(0) .. work(n - 1) on at most so many threads, 0: as many as there are cores. The calling thread
// takes part, and while it waits for the others it calls wait every few milliseconds. What one of them throws
// stops the others at their next Stop::point() and is thrown here.
void run_long(std::size_t n, int threads, const std::function<void(std::size_t)> &work,
              const std::function<void()> &wait);

} // namespace alphamst::parallel
