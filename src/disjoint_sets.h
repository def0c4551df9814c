// Sets of ids that are united two by two. Each has a member that stands for it; which one, the caller says,
// since results depend on it.
#pragma once

#include <boost/pending/disjoint_sets.hpp>
#include <numeric>
#include <vector>

#include "index.h"

namespace alphamst {

class DisjointSets {
public:
    explicit DisjointSets(std::size_t n) : sets_(n), name_(n) {
        std::iota(name_.begin(), name_.end(), std::size_t{0});
    }

    // The member that stands for the set of this one.
    template <std::integral Id> Id find(Id i) { return static_cast<Id>(name_[sets_.find_set(at(i))]); }

    // Who stands for the set of a stands for both.
    template <std::integral Id> void unite(Id a, Id b) {
        const std::size_t name = at(find(a));
        sets_.union_set(at(a), at(b));
        name_[sets_.find_set(at(a))] = name;
    }

    // A set of its own again; all that were in one set with it have to become so, too.
    void separate(std::integral auto i) {
        sets_.make_set(at(i));
        name_[at(i)] = at(i);
    }

private:
    boost::disjoint_sets_with_storage<> sets_;
    std::vector<std::size_t> name_; // [who stands for the set in sets_]
};

} // namespace alphamst
