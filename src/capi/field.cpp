#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/ids.h"
#include "mesh/sides.h"

namespace alphamst::capi {
namespace {

// The fields that the library reads: the wanted edge length at each vertex, and a direction of edges at
// each face.
constexpr std::string_view size_name = "size";
constexpr std::string_view cross_name = "cross";

static_assert(int{AMST_CARRY_DROP} == static_cast<int>(mesh::Carry::drop) &&
              int{AMST_CARRY_INHERIT} == static_cast<int>(mesh::Carry::inherit) &&
              int{AMST_CARRY_LINEAR} == static_cast<int>(mesh::Carry::linear) &&
              int{AMST_CARRY_CONSERVE} == static_cast<int>(mesh::Carry::conserve) &&
              int{AMST_CARRY_AVERAGE} == static_cast<int>(mesh::Carry::average));

std::string plural(Entity entity) {
    return entity == Entity::vertex ? "vertices" : entity == Entity::edge ? "edges" : "faces";
}

const char *place_of(Entity entity) {
    return entity == Entity::vertex ? "vertex {}" : entity == Entity::edge ? "edge {}" : "face {}";
}

std::string_view name_of(const char *name) {
    const std::string_view given = &required(name, "name");
    if (given.empty())
        throw Failure(Fault::argument, "name is empty; a field needs one");
    return given;
}

mesh::Carry carry_of(std::int32_t carry, Entity entity) {
    if (carry < AMST_CARRY_DROP || carry > AMST_CARRY_AVERAGE)
        throw Failure(Fault::argument,
                      "carry must be AMST_CARRY_DROP, _INHERIT, _LINEAR, _CONSERVE or _AVERAGE, it is " +
                          std::to_string(carry));
    if (carry == AMST_CARRY_LINEAR && entity != Entity::vertex)
        throw Failure(Fault::argument,
                      "AMST_CARRY_LINEAR is for fields on vertices, not on " + plural(entity));
    if ((carry == AMST_CARRY_CONSERVE || carry == AMST_CARRY_AVERAGE) && entity == Entity::edge)
        throw Failure(Fault::argument, std::string("AMST_CARRY_") +
                                           (carry == AMST_CARRY_CONSERVE ? "CONSERVE" : "AVERAGE") +
                                           " is for fields on faces or vertices, not on edges");
    return static_cast<mesh::Carry>(carry);
}

void require_finite(const mesh::Field &field) {
    const auto infinite = [](double value) { return !std::isfinite(value); };
    const auto found = std::find_if(field.values.begin(), field.values.end(), infinite);
    if (found != field.values.end())
        throw Failure(Fault::not_finite,
                      std::string(place_of(field.entity)) + " has a value that is not a finite number",
                      field.entity, {(found - field.values.begin()) / field.components});
}

void require_size(const mesh::Field &field) {
    if (field.entity != Entity::vertex)
        throw Failure(Fault::argument, "\"size\" is the wanted edge length at vertices; give a field on " +
                                           plural(field.entity) + " another name");
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

void require_cross(const mesh::Field &field) {
    if (field.entity != Entity::face)
        throw Failure(Fault::argument, "\"cross\" is a direction of edges at faces; give a field on " +
                                           plural(field.entity) + " another name");
    if (field.components != 3)
        throw Failure(Fault::range, "\"cross\" is a direction in space: it has 3 components, not " +
                                        std::to_string(field.components));
}

const mesh::Field &find(const mesh::QuadMesh &mesh, Entity entity, std::string_view name) {
    const mesh::Field *field = mesh.fields.find(entity, name);
    if (field == nullptr)
        throw Failure(Fault::not_found,
                      "there is no field \"" + std::string(name) + "\" on " + plural(entity));
    return *field;
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_set_field(amst_mesh *mesh, std::int32_t entity, const char *name,
                                std::int32_t components, std::int32_t carry, const double *values,
                                std::int64_t n) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        target.context->require_idle();
        auto field = std::make_shared<mesh::Field>();
        field->name = name_of(name);
        field->entity = entity_of(entity);
        field->carry = carry_of(carry, field->entity);
        if (components < 1)
            throw Failure(Fault::range, "components must be at least 1, it is " + std::to_string(components));
        field->components = components;
        require_array(values, n, "values", "n");
        const std::int64_t count = count_of(*target.current, field->entity);
        if (n != count)
            throw Failure(Fault::range, "n is " + std::to_string(n) + ", the mesh has " +
                                            std::to_string(count) + ' ' + plural(field->entity));
        field->values.assign(values, values + n * components);
        require_finite(*field);
        if (field->name == size_name)
            require_size(*field);
        if (field->name == cross_name)
            require_cross(*field);
        target.writable().fields.set(std::move(field));
    });
}

amst_status amst_mesh_get_field(const amst_mesh *mesh, std::int32_t entity, const char *name, double *out,
                                std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = *required(mesh, "mesh").impl->current;
        const std::string_view wanted = name_of(name);
        const mesh::Field &field = find(asked, entity_of(entity), wanted);
        if (answer(out, capacity, needed, static_cast<std::int64_t>(field.values.size())))
            std::copy(field.values.begin(), field.values.end(), out);
    });
}

amst_status amst_mesh_remove_field(amst_mesh *mesh, std::int32_t entity, const char *name) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        target.context->require_idle();
        const std::string_view wanted = name_of(name);
        const Entity kind = entity_of(entity);
        find(*target.current, kind, wanted);
        target.writable().fields.remove(kind, wanted);
    });
}
