#include "io/fields.h"

#include <memory>
#include <utility>

#include "io/scanner.h"

namespace alphamst::io {
namespace {

// Why these values are no field, "" if they are one.
std::string fault_of(const mesh::Field &field) {
    if (field.name.empty())
        return "it has no name";
    try {
        mesh::require_sound(field);
    } catch (const Failure &failure) {
        std::string text = failure.text;
        if (const std::size_t hole = text.find("{}"); hole != std::string::npos && !failure.ids.empty())
            text.replace(hole, 2, "number " + std::to_string(failure.ids[0]));
        return text;
    }
    return "";
}

} // namespace

void add_new_field(Arrays &mesh, Entity entity, std::string_view name, int components, bool whole,
                   std::vector<double> values) {
    auto field = std::make_shared<mesh::Field>();
    field->entity = entity;
    field->name = name;
    field->components = components;
    const bool direction = entity == Entity::face && name == "cross";
    field->carry = whole || direction         ? mesh::Carry::inherit
                   : entity == Entity::vertex ? mesh::Carry::linear
                                              : mesh::Carry::conserve;
    field->values = std::move(values);
    if (mesh.fields.find(entity, name) != nullptr)
        mesh.remarks.push_back("there are several data " + quoted(name) + ", of which the last count");
    mesh.fields.set(std::move(field));
}

void settle_fields(Arrays &mesh) {
    const mesh::Fields all = mesh.fields;
    for (const auto &field : all) {
        const std::string fault = fault_of(*field);
        if (fault.empty())
            continue;
        mesh.remarks.push_back("the data " + io::quoted(field->name) + " are left out: " + fault);
        mesh.fields.remove(field->entity, field->name);
    }
}

} // namespace alphamst::io
