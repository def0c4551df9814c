// Fields: named reals on every vertex, edge or face of a mesh, and the rule by which each
// follows the mesh through an operation.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "failure.h"

namespace alphamst::mesh {

// Numbers equal those of enum amst_carry.
enum class Carry { drop = 0, inherit = 1, linear = 2, conserve = 3, average = 4 };

struct Field {
    Entity entity = Entity::vertex;
    std::string name;
    int components = 1;
    Carry carry = Carry::drop;
    std::vector<double> values; // [entities][components]
};

// Throws Failure: argument (a carry rule that is not for this kind of entity, a field that the library reads
// on the wrong kind), range (components, a "size" that no edge has), not_finite.
void require_sound(const Field &field);

// At most one field of a name on each kind of entity. Copies share the fields, none of which ever
// changes: a new one takes its place.
class Fields {
public:
    using List = std::vector<std::shared_ptr<const Field>>;

    const Field *find(Entity entity, std::string_view name) const noexcept; // null if there is none
    // In the place of one with its name. Changes nothing where memory runs out.
    void set(std::shared_ptr<const Field> field);
    void remove(Entity entity, std::string_view name) noexcept;
    bool empty() const noexcept { return list_.empty(); }
    List::const_iterator begin() const noexcept { return list_.begin(); }
    List::const_iterator end() const noexcept { return list_.end(); }

private:
    List list_;
};

} // namespace alphamst::mesh
