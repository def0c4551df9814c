#include <algorithm>
#include <string>
#include <string_view>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/ids.h"
#include "entity.h"

namespace alphamst::capi {
namespace {

static_assert(int{AMST_CARRY_DROP} == static_cast<int>(mesh::Carry::drop) &&
              int{AMST_CARRY_INHERIT} == static_cast<int>(mesh::Carry::inherit) &&
              int{AMST_CARRY_LINEAR} == static_cast<int>(mesh::Carry::linear) &&
              int{AMST_CARRY_CONSERVE} == static_cast<int>(mesh::Carry::conserve) &&
              int{AMST_CARRY_AVERAGE} == static_cast<int>(mesh::Carry::average));

std::string_view name_of(const char *name) {
    const std::string_view given = &required(name, "name");
    if (given.empty())
        throw Failure(Fault::argument, "name is empty; a field needs one");
    return given;
}

mesh::Carry carry_of(std::int32_t carry) {
    if (carry < AMST_CARRY_DROP || carry > AMST_CARRY_AVERAGE)
        throw Failure(Fault::argument,
                      "carry must be AMST_CARRY_DROP, _INHERIT, _LINEAR, _CONSERVE or _AVERAGE, it is " +
                          std::to_string(carry));
    return static_cast<mesh::Carry>(carry);
}

const mesh::Field &find(const mesh::QuadMesh &mesh, Entity entity, std::string_view name) {
    const mesh::Field *field = mesh.fields.find(entity, name);
    if (field == nullptr)
        throw Failure(Fault::not_found,
                      "there is no field \"" + std::string(name) + "\" on " + plural_of(entity));
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
        field->carry = carry_of(carry);
        if (components < 1)
            throw Failure(Fault::range, "components must be at least 1, it is " + std::to_string(components));
        field->components = components;
        require_array(values, n, "values", "n");
        const std::int64_t count = count_of(*target.current, field->entity);
        if (n != count)
            throw Failure(Fault::range, "n is " + std::to_string(n) + ", the mesh has " +
                                            std::to_string(count) + ' ' + plural_of(field->entity));
        field->values.assign(values, values + n * components);
        mesh::require_sound(*field);
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
