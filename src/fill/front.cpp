#include "fill/front.h"

#include <algorithm>
#include <numeric>

namespace alphamst::fill {

Front::Front(const Word &word) : word(word), ids(word.size()), vertices(static_cast<int>(word.size())) {
    std::iota(ids.begin(), ids.end(), 0);
}

int Front::corners() const { return static_cast<int>(std::count(word.begin(), word.end(), 1)); }

int Front::concaves() const {
    int sum = 0;
    for (const int letter : word)
        sum += std::max(0, letter - 2);
    return sum;
}

bool Front::peel(std::size_t i, std::size_t j) {
    const std::size_t length = word.size();
    const std::size_t row = (j + length - i) % length; // edges of the side
    if (row == 0 || row + 4 > length)
        return false;
    const std::size_t before = (i + length - 1) % length, after = (j + 1) % length;
    if (word[before] < 2 || word[after] < 2)
        return false;
    std::vector<int> top{ids[before]};
    for (std::size_t k = 1; k < row; ++k)
        top.push_back(vertices++);
    top.push_back(ids[after]);
    for (std::size_t k = 0; k < row; ++k)
        quads.push_back({ids[(i + k) % length], ids[(i + k + 1) % length], top[k + 1], top[k]});
    Word next_word;
    std::vector<int> next_ids;
    for (std::size_t k = after;; k = (k + 1) % length) { // after ... before, then the new row
        next_word.push_back(word[k] - (k == after || k == before ? 1 : 0));
        next_ids.push_back(ids[k]);
        if (k == before)
            break;
    }
    next_word.insert(next_word.end(), row - 1, 2);
    next_ids.insert(next_ids.end(), top.begin() + 1, top.end() - 1);
    word = std::move(next_word);
    ids = std::move(next_ids);
    return true;
}

bool Front::cancel_concave() {
    const std::size_t length = word.size();
    struct Choice {
        std::size_t i = 0, j = 0, rows = 0;
        double cost = 1e300;
    } best;
    for (std::size_t i = 0; i < length; ++i) {
        if (word[i] != 1)
            continue;
        std::size_t row = 1;
        while (row < length && word[(i + row) % length] == 2)
            ++row;
        const std::size_t j = (i + row) % length;
        if (row >= length || word[j] != 1)
            continue;
        // Rows until the first vertex beyond each end that is not flat.
        std::size_t left = 1, right = 1;
        while (left < length && word[(i + length - left) % length] == 2)
            ++left;
        while (right < length && word[(j + right) % length] == 2)
            ++right;
        const bool concave_left = word[(i + length - left % length) % length] > 2;
        const bool concave_right = word[(j + right) % length] > 2;
        const std::size_t rows = std::min(left, right);
        const bool wins_left = concave_left && left == rows, wins_right = concave_right && right == rows;
        if ((!concave_left && left == rows) || (!concave_right && right == rows) ||
            (!wins_left && !wins_right))
            continue; // would run into another corner
        if (2 * rows + row + 2 > length)
            continue;
        const double cost = static_cast<double>(rows * row) / (wins_left && wins_right ? 2 : 1);
        if (cost < best.cost)
            best = {i, j, rows, cost};
    }
    if (best.rows == 0)
        return false;
    const std::size_t row = (best.j + length - best.i) % length;
    if (!peel(best.i, best.j))
        return false;
    for (std::size_t k = 1; k < best.rows; ++k) {
        // The new row ends the word; its corners are the last old vertex and the first.
        const std::size_t now = word.size();
        if (!peel(now - row, 0))
            return true;
    }
    return true;
}

bool Front::offset() {
    const std::size_t length = word.size();
    // Two corners with flat vertices between need three edges: the row between shrinks by two.
    std::size_t flats = length, start = length;
    for (std::size_t i = 0; i < 2 * length; ++i) {
        const int letter = word[i % length];
        if (letter == 1) {
            if (flats < 2)
                return false;
            flats = 0;
        } else {
            flats = letter == 2 && flats < length ? flats + 1 : length;
            if (start == length && i > 0 && word[(i - 1) % length] != 1)
                start = i % length;
        }
    }
    if (start == length)
        return false;
    // A front vertex of letter r has 2 r - 3 partners one layer in; the last before and
    // the first after a corner are one vertex, the new corner.
    Word next_word;
    std::vector<int> next_ids;
    std::vector<int> first(length, -1), last(length, -1);
    for (std::size_t step = 0; step < length; ++step) {
        const std::size_t i = (start + step) % length, before = (i + length - 1) % length;
        if (word[i] == 1)
            continue;
        const bool shares = word[before] == 1;
        if (shares) {
            first[i] = last[i] = last[(before + length - 1) % length];
            next_word.back() = 1;
        }
        for (int k = shares ? 1 : 0; k < 2 * word[i] - 3; ++k) {
            const int v = vertices++;
            if (k == 0)
                first[i] = v;
            last[i] = v;
            next_word.push_back(k % 2 == 0 ? 2 : 3);
            next_ids.push_back(v);
        }
    }
    for (std::size_t i = 0; i < length; ++i) {
        const std::size_t after = (i + 1) % length, before = (i + length - 1) % length;
        if (word[i] == 1) {
            quads.push_back({ids[before], ids[i], ids[after], last[before]});
            continue;
        }
        if (word[after] != 1)
            quads.push_back({ids[i], ids[after], first[after], last[i]});
        int left = first[i];
        for (int k = 1; k + 1 < 2 * word[i] - 3; k += 2) {
            const int top = last[i] - (2 * word[i] - 4 - k);
            quads.push_back({ids[i], top + 1, top, left});
            left = top + 1;
        }
    }
    word = std::move(next_word);
    ids = std::move(next_ids);
    return true;
}

Filling Front::close(const Filling &rest, int boundary) const {
    Filling whole{boundary, vertices, quads};
    append(whole, rest, ids);
    return whole;
}

} // namespace alphamst::fill
