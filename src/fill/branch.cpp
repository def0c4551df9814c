#include "fill/branch.h"

#include <algorithm>

namespace alphamst::fill {
namespace {

using Visit = std::function<void(Branch &)>;

// Letters first .. last (cyclic) of the front, the ends replaced.
Part slice(const Word &word, int first, int last, int first_letter, int last_letter) {
    const int length = static_cast<int>(word.size());
    Part part;
    for (int i = first;; i = (i + 1) % length) {
        part.word.push_back(word[static_cast<std::size_t>(i)]);
        part.vertices.push_back(i);
        if (i == last)
            break;
    }
    part.word.front() = first_letter;
    part.word.back() = last_letter;
    return part;
}

bool legal(const Part &part) {
    return part.word.size() >= 4 && part.word.size() % 2 == 0 &&
           *std::min_element(part.word.begin(), part.word.end()) >= 1;
}

void offer(Branch &branch, const Visit &visit) {
    if (std::all_of(branch.parts.begin(), branch.parts.end(), legal))
        visit(branch);
}

// The quad at a corner v (letter 1): its fourth vertex is forced next to another
// corner, else new or any front vertex that leaves two even parts.
void corner_branches(const Word &word, int v, Budget budget, const Visit &visit) {
    const int length = static_cast<int>(word.size());
    auto at = [&](int i) { return (i % length + length) % length; };
    auto letter = [&](int i) { return word[static_cast<std::size_t>(at(i))]; };
    const int p = at(v - 1), n = at(v + 1);
    if (letter(p) == 1 && letter(n) == 1)
        return;
    if (letter(n) == 1 || letter(p) == 1) {
        const bool after = letter(n) == 1;
        const int first = after ? at(n + 1) : n, last = after ? p : at(p - 1);
        Branch branch{{p, v, n, after ? first : last}, {0, 0}, {}};
        if (length >= 6) {
            branch.parts = {slice(word, first, last, letter(first) - 1, letter(last) - 1)};
            offer(branch, visit);
        }
        return;
    }
    for (int valence = 3; valence <= 5; ++valence) {
        const Budget used{valence == 3, valence == 5};
        if (used.v3 > budget.v3 || used.v5 > budget.v5)
            continue;
        Branch branch{{p, v, n, -1}, used, {slice(word, n, p, letter(n) - 1, letter(p) - 1)}};
        branch.parts[0].word.push_back(valence - 1);
        branch.parts[0].vertices.push_back(-1);
        offer(branch, visit);
    }
    for (int d = 4; d + 4 <= length; d += 2) {
        const int u = at(v + d);
        for (int share = 1; share + 2 <= letter(u); ++share) {
            Branch branch{{p, v, n, u},
                          {0, 0},
                          {slice(word, n, u, letter(n) - 1, share),
                           slice(word, u, p, letter(u) - 1 - share, letter(p) - 1)}};
            offer(branch, visit);
        }
    }
}

// The quad (v, n, a, b) on an edge of a front without corners.
void edge_branches(const Word &word, Budget budget, const Visit &visit) {
    const int length = static_cast<int>(word.size());
    auto letter = [&](int i) { return word[static_cast<std::size_t>(i)]; };
    const int rv = letter(0) - 1, rn = letter(1) - 1;
    auto affordable = [&](Budget used) { return used.v3 <= budget.v3 && used.v5 <= budget.v5; };
    for (int va = 3; va <= 5; ++va)
        for (int vb = 3; vb <= 5; ++vb) { // both new
            const Budget used{(va == 3) + (vb == 3), (va == 5) + (vb == 5)};
            if (!affordable(used))
                continue;
            Branch branch{{0, 1, -2, -1}, used, {slice(word, 1, 0, rn, rv)}};
            branch.parts[0].word.insert(branch.parts[0].word.end(), {vb - 1, va - 1});
            branch.parts[0].vertices.insert(branch.parts[0].vertices.end(), {-1, -2});
            offer(branch, visit);
        }
    for (int valence = 3; valence <= 5; ++valence) { // one new, one on the front
        const Budget used{valence == 3, valence == 5};
        if (!affordable(used))
            continue;
        for (int j = 3; j < length - 2; ++j)
            for (int share = 1; share + 2 <= letter(j); ++share) {
                const int rest = letter(j) - 1 - share;
                Branch b{{0, 1, -2, j}, used, {slice(word, j, 0, share, rv), slice(word, 1, j, rn, rest)}};
                b.parts[1].word.push_back(valence - 1);
                b.parts[1].vertices.push_back(-2);
                offer(b, visit);
                Branch a{{0, 1, j, -1}, used, {slice(word, 1, j, rn, share), slice(word, j, 0, rest, rv)}};
                a.parts[1].word.push_back(valence - 1);
                a.parts[1].vertices.push_back(-1);
                offer(a, visit);
            }
    }
    for (int i = 4; i < length - 2; i += 2) // both on the front
        for (int j = i + 1; j < length - 2; j += 2)
            for (int si = 1; si < letter(i); ++si)
                for (int sj = 1; sj < letter(j); ++sj) {
                    Branch branch{
                        {0, 1, i, j}, {0, 0}, {slice(word, 1, i, rn, si), slice(word, j, 0, sj, rv)}};
                    const int ri = letter(i) - 1 - si, rj = letter(j) - 1 - sj;
                    if (j == i + 1) {
                        if (ri != 0 || rj != 0)
                            continue;
                    } else {
                        branch.parts.push_back(slice(word, i, j, ri, rj));
                    }
                    offer(branch, visit);
                }
}

// The corner with the fewest branches, -1 without corners: beside another corner the quad is forced.
int best_corner(const Word &word) {
    const std::size_t length = word.size();
    int best = -1, best_score = 99;
    for (std::size_t i = 0; i < length; ++i)
        if (word[i] == 1) {
            const int p = word[(i + length - 1) % length], n = word[(i + 1) % length];
            const int score = (p == 1 || n == 1) ? 0 : p + n;
            if (score < best_score) {
                best = static_cast<int>(i);
                best_score = score;
            }
        }
    return best;
}

} // namespace

void visit_branches(const Word &front, Budget budget, const std::function<void(Branch &)> &visit) {
    const int corner = best_corner(front);
    if (corner >= 0)
        corner_branches(front, corner, budget, visit);
    else
        edge_branches(front, budget, visit);
}

} // namespace alphamst::fill
