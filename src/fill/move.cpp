#include "fill/move.h"

namespace alphamst::fill {

Move::Move(const std::vector<int> &change, const std::vector<std::vector<int>> &product) {
    int square = 0;
    for (std::size_t a = 0; a < change.size(); ++a) {
        int sum = 0;
        for (std::size_t b = 0; b < change.size(); ++b)
            sum += change[b] * product[a][b];
        z.set(a, change[a]);
        slope.set(a, sum);
        square += sum * change[a];
    }
    curvature = square / 2;
    for (std::size_t j = 0; j < most_chords; ++j) {
        constexpr int all = 0x7fff;
        adds_one.set(j, z[j] == 1 ? 0 : all);
        adds_two.set(j, z[j] == 2 ? 0 : all);
        takes_one.set(j, z[j] == -1 ? 0 : all);
        takes_two.set(j, z[j] == -2 ? 0 : all);
    }
}

} // namespace alphamst::fill
