#include "allocation.h"

#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace {
std::atomic<std::int64_t> live{0}, most{0};
}

void *operator new(std::size_t size) {
    void *memory = std::malloc(size);
    if (memory == nullptr)
        throw std::bad_alloc();
    live += static_cast<std::int64_t>(malloc_usable_size(memory));
    if (live > most)
        most = live.load();
    return memory;
}

void operator delete(void *memory) noexcept {
    live -= static_cast<std::int64_t>(malloc_usable_size(memory));
    std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept { operator delete(memory); }

namespace alphamst::benchmarks {

std::int64_t bytes_live() { return live; }
std::int64_t bytes_most() { return most; }
void restart_bytes_most() { most = live.load(); }

} // namespace alphamst::benchmarks
