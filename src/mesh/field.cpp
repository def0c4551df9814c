#include "mesh/field.h"

#include <algorithm>

namespace alphamst::mesh {
namespace {

auto named(Entity entity, std::string_view name) {
    return [=](const std::shared_ptr<const Field> &field) {
        return field->entity == entity && field->name == name;
    };
}

} // namespace

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
