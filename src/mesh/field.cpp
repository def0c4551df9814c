#include "mesh/field.h"

#include <algorithm>
#include <cmath>

#include "entity.h"
#include "mesh/sides.h"

namespace alphamst::mesh {
namespace {

auto named(Entity entity, std::string_view name) {
    return [=](const std::shared_ptr<const Field> &field) {
        return field->entity == entity && field->name == name;
    };
}

// The fields that the library reads: the wanted edge length at each vertex, and a direction of edges at
// each face.
constexpr std::string_view size_name = "size";
constexpr std::string_view cross_name = "cross";

const char *place_of(Entity entity) {
    return entity == Entity::vertex ? "vertex {}" : entity == Entity::edge ? "edge {}" : "face {}";
}

void require_carry(const Field &field) {
    if (field.carry == Carry::linear && field.entity != Entity::vertex)
        throw Failure(Fault::argument,
                      "AMST_CARRY_LINEAR is for fields on vertices, not on " + plural_of(field.entity));
    if ((field.carry == Carry::conserve || field.carry == Carry::average) && field.entity == Entity::edge)
        throw Failure(Fault::argument, std::string("AMST_CARRY_") +
                                           (field.carry == Carry::conserve ? "CONSERVE" : "AVERAGE") +
                                           " is for fields on faces or vertices, not on edges");
}

void require_finite(const Field &field) {
    const auto infinite = [](double value) { return !std::isfinite(value); };
    const auto found = std::find_if(field.values.begin(), field.values.end(), infinite);
    if (found != field.values.end())
        throw Failure(Fault::not_finite,
                      std::string(place_of(field.entity)) + " has a value that is not a finite number",
                      field.entity, {(found - field.values.begin()) / field.components});
}

void require_size(const Field &field) {
    if (field.entity != Entity::vertex)
        throw Failure(Fault::argument, "\"size\" is the wanted edge length at vertices; give a field on " +
                                           plural_of(field.entity) + " another name");
    if (field.components != 1)
        throw Failure(Fault::range, "\"size\" is the wanted edge length: it has 1 component, not " +
                                        std::to_string(field.components));
    const auto found =
        std::find_if(field.values.begin(), field.values.end(), [](double value) { return !(value > 0); });
    if (found != field.values.end())
        throw Failure(Fault::range, "vertex {} has a \"size\" that is not above 0", Entity::vertex,
                      {found - field.values.begin()});
    const auto far = std::ranges::find_if(field.values, [](double value) {
        return value < mesh::least_extent || value > mesh::largest_coordinate;
    });
    if (far != field.values.end())
        throw Failure(
            Fault::range,
            "vertex {} has a \"size\" that is not between 1e-30 and 1e30; no edge of a mesh is so short "
            "or so long",
            Entity::vertex, {far - field.values.begin()});
}

void require_cross(const Field &field) {
    if (field.entity != Entity::face)
        throw Failure(Fault::argument, "\"cross\" is a direction of edges at faces; give a field on " +
                                           plural_of(field.entity) + " another name");
    if (field.components != 3)
        throw Failure(Fault::range, "\"cross\" is a direction in space: it has 3 components, not " +
                                        std::to_string(field.components));
}

} // namespace

void require_sound(const Field &field) {
    require_carry(field);
    require_finite(field);
    if (field.name == size_name)
        require_size(field);
    if (field.name == cross_name)
        require_cross(field);
}

const Field *Fields::find(Entity entity, std::string_view name) const noexcept {
    const auto found = std::find_if(list_.begin(), list_.end(), named(entity, name));
    return found == list_.end() ? nullptr : found->get();
}

void Fields::set(std::shared_ptr<const Field> field) {
    const auto old = std::find_if(list_.begin(), list_.end(), named(field->entity, field->name));
    if (old == list_.end())
        list_.push_back(std::move(field));
    else
        *old = std::move(field);
}

void Fields::remove(Entity entity, std::string_view name) noexcept {
    const auto old = std::find_if(list_.begin(), list_.end(), named(entity, name));
    if (old != list_.end())
        list_.erase(old);
}

} // namespace alphamst::mesh
