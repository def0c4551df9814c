// The one exception type of the core. A failure says what went wrong, about
// which entity, and in a sentence for the user. Ids in the sentence are written
// as {} and filled in by the C interface, the only place that knows the
// caller's index base.
#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace alphamst {

enum class Fault {
    argument,
    range,
    not_finite,
    not_quad,
    not_manifold,
    patch,
    no_filling,
    geometry,
    chord,
    projection,
    stale,
    not_found,
    io,
    format,
    unsupported,
    cancelled,
    state,
    internal
};

enum class Entity { none = -1, vertex = 0, edge = 1, face = 2 };

class Failure : public std::exception {
public:
    // Each {} in text stands for the next of ids (0-based); the first id is
    // the place of the failure when entity is not none.
    Failure(Fault fault, std::string text, Entity entity = Entity::none, std::vector<std::int64_t> ids = {})
        : fault(fault), text(std::move(text)), entity(entity), ids(std::move(ids)) {}

    const char *what() const noexcept override { return text.c_str(); }

    Fault fault;
    std::string text;
    Entity entity;
    std::vector<std::int64_t> ids;
    std::int64_t patch = -1; // 0-based, -1: not about one patch
};

} // namespace alphamst
