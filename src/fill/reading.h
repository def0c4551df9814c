// What is left to fill after cheap rows of quads, read as a polygon: some corners keep one face,
// all other front vertices become flat and so, mostly, irregular.
#pragma once

#include <memory>
#include <vector>

#include "fill/closed_form.h"
#include "fill/front.h"
#include "fill/plan.h"
#include "random.h"

namespace alphamst::fill {

struct Reading {
    std::shared_ptr<const Front> front;
    std::vector<int> corners; // front positions, ascending; empty: flat all round
    Sides sides;
    int changed = 0;        // vertices that become irregular (or cease to be) by this reading
    int least = 0;          // changed + fewest irregular vertices inside
    double natural = 0;     // faces of a square-like filling of the sides
    double count_error = 0; // |log| of wanted over natural face count
};

class Readings {
public:
    explicit Readings(const Request &request);

    // Fewest irregular vertices that any reading can have.
    int least() const;
    // Readings with at most k irregular vertices at best, fewest first, then by count_error; made as
    // needed.
    const std::vector<Reading> &up_to(int k);

private:
    // A front and the fewest irregular vertices that any reading of it can have.
    struct Stage {
        std::shared_ptr<const Front> front;
        int least = 0;
        bool read = false;
    };

    bool changes(const Front &front, std::size_t position, int letter) const;
    bool allowed(const Front &front, std::size_t position, int letter) const;
    int buried(const Front &front) const;
    void collect_stages();
    void add_stage(Front front);
    void read(const std::shared_ptr<const Front> &front);
    std::vector<int> choose(const std::vector<int> &pool, const std::vector<int> &forced, int n, int round,
                            int length);
    void add(const std::shared_ptr<const Front> &front, std::vector<int> corners, int base);

    const Request &request_;
    Random random_;
    std::vector<Stage> stages_;
    std::vector<Reading> readings_;
};

} // namespace alphamst::fill
