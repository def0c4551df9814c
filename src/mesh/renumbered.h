// Numbers of entities while commits renumber the mesh.
#pragma once

#include <unordered_map>

namespace alphamst::mesh {

// Every entity has a name that stays: its number at the start, or the one that add() gave it.
class Renumbered {
public:
    explicit Renumbered(int entities) : next_(entities) {}

    // -1 if it is gone.
    int now(int name) const {
        const auto found = now_.find(name);
        return found == now_.end() ? name : found->second;
    }

    void remove(int id) {
        if (const int name = name_of(id); name >= 0)
            now_[name] = -1;
        name_[id] = -1;
    }
    // A new entity with this number; its name.
    int add(int id) {
        name_[id] = next_;
        now_[next_] = id;
        return next_++;
    }
    void move(int from, int to) {
        const int name = name_of(from);
        name_[to] = name;
        name_[from] = -1;
        if (name >= 0)
            now_[name] = to;
    }

private:
    int name_of(int id) const {
        const auto found = name_.find(id);
        return found == name_.end() ? id : found->second;
    }

    std::unordered_map<int, int> now_, name_; // name_: -1 where a number is free
    int next_;
};

} // namespace alphamst::mesh
