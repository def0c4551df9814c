// Where work may be stopped deep inside, on any thread of an operation: it asks whether the operation goes
// on.
#pragma once

#include <functional>
#include <utility>

namespace alphamst {

class Stop {
public:
    // Throws where the operation is to end.
    using Ask = std::function<void()>;

    // As long as this lives, this thread asks that; null: nothing.
    explicit Stop(const Ask *ask) : before_(std::exchange(current(), ask)) {}
    ~Stop() { current() = before_; }
    Stop(const Stop &) = delete;
    Stop &operator=(const Stop &) = delete;

    // To be called every few microseconds to milliseconds, where it is right to throw.
    static void point() {
        if (const Ask *ask = current())
            (*ask)();
    }
    // What this thread asks, to be handed on to others that work for it.
    static const Ask *of_this_thread() { return current(); }

private:
    static const Ask *&current() {
        static thread_local const Ask *ask = nullptr;
        return ask;
    }

    const Ask *before_;
};

} // namespace alphamst
