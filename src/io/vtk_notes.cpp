#include "io/vtk_notes.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>

#include "io/markers.h"

namespace alphamst::io::vtk {
namespace {

constexpr std::string_view carry_note = "carry ", marker_note = "marker ";

struct Kind {
    std::string_view word; // with the blank behind it
    Entity entity;
};
constexpr std::array<Kind, 3> kinds{
    {{"vertex ", Entity::vertex}, {"edge ", Entity::edge}, {"face ", Entity::face}}};

std::string note_of(std::string_view note, Entity entity, const std::string &name) {
    std::string text(note);
    for (const Kind &kind : kinds)
        if (kind.entity == entity)
            text += kind.word;
    return text + name;
}

void add_carry(Entity entity, std::string_view name, const Data &note, Arrays &mesh) {
    const mesh::Field *old = mesh.fields.find(entity, name);
    constexpr double last = static_cast<double>(mesh::Carry::average);
    if (old == nullptr || note.values.size() != 1 || !(note.values[0] >= 0 && note.values[0] <= last))
        return;
    auto field = std::make_shared<mesh::Field>(*old);
    field->carry = static_cast<mesh::Carry>(std::lround(note.values[0]));
    mesh.fields.set(std::move(field));
}

void add_names(Entity entity, std::string_view name, const Data &note, Arrays &mesh) {
    using Limits = std::numeric_limits<std::int32_t>;
    for (const double marker : note.values)
        if (marker >= Limits::min() && marker <= Limits::max() && marker != 0 && !name.empty())
            mesh.names[{entity, static_cast<std::int32_t>(marker)}] = clean_name(name);
}

} // namespace

std::vector<Data> notes_of(const Arrays &mesh) {
    std::vector<Data> notes;
    for (const auto &field : mesh.fields)
        if (field->entity != Entity::edge)
            notes.push_back({note_of(carry_note, field->entity, field->name),
                             1,
                             true,
                             {static_cast<double>(field->carry)}});
    for (const auto &[of, name] : mesh.names) {
        const std::string note = note_of(marker_note, of.first, name);
        Data *same = nullptr; // two markers may have one name
        for (Data &other : notes)
            if (other.name == note)
                same = &other;
        if (same == nullptr)
            same = &notes.emplace_back(Data{note, 1, true, {}});
        same->values.push_back(of.second);
    }
    return notes;
}

void add_notes(std::span<const Data> notes, Arrays &mesh) {
    for (const Data &note : notes)
        for (const Kind &kind : kinds) {
            const std::string_view name = note.name;
            for (const std::string_view start : {carry_note, marker_note}) {
                if (!note.whole || note.components != 1 || !name.starts_with(start) ||
                    !name.substr(start.size()).starts_with(kind.word))
                    continue;
                const std::string_view rest = name.substr(start.size() + kind.word.size());
                start == carry_note ? add_carry(kind.entity, rest, note, mesh)
                                    : add_names(kind.entity, rest, note, mesh);
            }
        }
}

} // namespace alphamst::io::vtk
