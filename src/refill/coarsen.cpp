#include "refill/coarsen.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "quality/corner.h"
#include "random.h"

namespace alphamst::refill {
namespace {

// A filling under collapses: the vertex a of a quad (a, b, c, d) moves onto c, b and d lose the quad.
class Collapser {
public:
    Collapser(const fill::Request &request, const PlacedFilling &old, std::uint64_t seed)
        : request_(request), boundary_(old.filling.boundary), points_(old.positions),
          quads_(old.filling.quads), alive_(quads_.size(), 1),
          at_(static_cast<std::size_t>(old.filling.vertices)), random_(seed) {
        for (std::size_t q = 0; q < quads_.size(); ++q)
            for (const int v : quads_[q])
                at_[static_cast<std::size_t>(v)].push_back(q);
        entry_.assign(quads_.size(), {5000, 0, 0, 0});
        for (std::size_t q = 0; q < quads_.size(); ++q)
            enter(q);
    }

    // As far as quads can go; returns how many are left.
    std::int64_t reach(std::int64_t faces) {
        auto left = static_cast<std::int64_t>(quads_.size());
        while (left > faces) {
            if (queue_.empty())
                break;
            const Entry best = *queue_.begin();
            if (!collapse(best.quad, best.corner)) {
                queue_.erase(queue_.begin()); // until something changes around it
                entry_[best.quad].cost = 5000;
                continue;
            }
            --left;
        }
        return left;
    }

    PlacedFilling result() const {
        PlacedFilling shape{{boundary_, boundary_, {}}, {points_.begin(), points_.begin() + boundary_}};
        fill::Filling &filling = shape.filling;
        std::vector<int> name(at_.size(), -1);
        for (int v = 0; v < filling.boundary; ++v)
            name[static_cast<std::size_t>(v)] = v;
        for (std::size_t q = 0; q < quads_.size(); ++q) {
            if (!alive_[q])
                continue;
            std::array<int, 4> quad{};
            for (std::size_t k = 0; k < 4; ++k) {
                int &number = name[static_cast<std::size_t>(quads_[q][k])];
                if (number < 0) {
                    number = filling.vertices++;
                    shape.positions.push_back(points_[static_cast<std::size_t>(quads_[q][k])]);
                }
                quad[k] = number;
            }
            filling.quads.push_back(quad);
        }
        return shape;
    }

    // As a request counts them: singular ones inside, boundary ones with another number of faces.
    int irregular() const {
        int sum = 0;
        for (std::size_t v = 0; v < at_.size(); ++v) {
            const int faces = static_cast<int>(at_[v].size());
            if (inside(v))
                sum += faces != 0 && faces != 4;
            else
                sum += request_.regular[v] != 0 && faces != request_.regular[v];
        }
        return sum;
    }

private:
    struct Entry {
        int cost;
        std::uint64_t tie;
        std::size_t quad, corner;
        bool operator<(const Entry &other) const {
            return std::tie(cost, tie, quad) < std::tie(other.cost, other.tie, other.quad);
        }
    };

    bool inside(std::size_t v) const { return v >= static_cast<std::size_t>(boundary_); }

    int penalty(std::size_t v, int faces) const {
        const int off = faces - (inside(v) ? 4 : request_.word[v]);
        const int few = inside(v) ? 3 : 1, least = !inside(v) && !request_.angles.empty()
                                                       ? static_cast<int>(request_.angles[v] / 175) + 1
                                                       : few;
        return off * off + (faces < least ? 1000 : 0);
    }

    // Whether an edge joins the two inside the disk.
    bool joined(std::size_t v, int to) const {
        for (const std::size_t q : at_[v])
            for (std::size_t k = 0; k < 4; ++k)
                if (quads_[q][k] == static_cast<int>(v) &&
                    (quads_[q][(k + 1) % 4] == to || quads_[q][(k + 3) % 4] == to))
                    return true;
        return false;
    }

    // Whether no vertex but b and d is joined to both a and c, a being inside.
    bool only_share(std::size_t a, std::size_t c, int b, int d) const {
        for (const std::size_t q : at_[a])
            for (std::size_t k = 0; k < 4; ++k)
                if (quads_[q][k] == static_cast<int>(a))
                    // Each neighbour of a vertex inside is once the next one.
                    if (const int v = quads_[q][(k + 1) % 4]; v != b && v != d && joined(c, v))
                        return false;
        return true;
    }

    // Cost of moving corner k of quad q onto the opposite one; 5000: not allowed, or not below `limit`.
    int cost(std::size_t q, std::size_t k, int limit) const {
        const auto corner = [&](std::size_t i) { return static_cast<std::size_t>(quads_[q][(k + i) % 4]); };
        const std::size_t a = corner(0), b = corner(1), c = corner(2), d = corner(3);
        if (!inside(a) || (inside(c) && c < a))
            return 5000;
        const auto faces = [&](std::size_t v) { return static_cast<int>(at_[v].size()); };
        const int merged = faces(a) + faces(c) - 2;
        int sum = penalty(c, merged) - penalty(a, faces(a)) - penalty(c, faces(c));
        for (const std::size_t v : {b, d})
            sum += penalty(v, faces(v) - 1) - penalty(v, faces(v));
        if (sum >= std::min(500, limit) || !only_share(a, c, static_cast<int>(b), static_cast<int>(d)))
            return 5000;
        return sum;
    }

    void enter(std::size_t q) {
        if (entry_[q].cost < 1000)
            queue_.erase(entry_[q]);
        entry_[q] = {5000, 0, q, 0};
        if (!alive_[q])
            return;
        for (std::size_t k = 0; k < 4; ++k) {
            const int here = cost(q, k, entry_[q].cost);
            if (here < entry_[q].cost)
                entry_[q] = {here, random_(), q, k};
        }
        if (entry_[q].cost < 1000)
            queue_.insert(entry_[q]);
    }

    // Smallest scaled Jacobian of the quads at both vertices, quad q left out, with both at p.
    double worst(std::size_t a, std::size_t c, std::size_t q, const Eigen::Vector2d &p) const {
        double least = 1;
        for (const std::size_t v : {a, c})
            for (const std::size_t r : at_[v]) {
                if (r == q)
                    continue;
                std::array<Eigen::Vector2d, 4> x;
                for (std::size_t k = 0; k < 4; ++k) {
                    const auto u = static_cast<std::size_t>(quads_[r][k]);
                    x[k] = u == a || u == c ? p : points_[u];
                }
                for (std::size_t k = 0; k < 4; ++k) {
                    const Eigen::Vector2d next = x[(k + 1) % 4] - x[k], before = x[(k + 3) % 4] - x[k];
                    least = std::min(least, quality::scaled_jacobian(quality::determinant(next, before),
                                                                     next.norm() * before.norm()));
                }
            }
        return least;
    }

    // To the mean of its neighbours, if that makes its worst corner better.
    void relax(std::size_t v) {
        if (!inside(v) || at_[v].empty())
            return;
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        for (const std::size_t r : at_[v])
            for (std::size_t k = 0; k < 4; ++k)
                if (quads_[r][k] == static_cast<int>(v))
                    mean += points_[static_cast<std::size_t>(quads_[r][(k + 1) % 4])] /
                            static_cast<double>(at_[v].size());
        const std::size_t none = quads_.size();
        if (worst(v, v, none, mean) > worst(v, v, none, points_[v]))
            points_[v] = mean;
    }

    bool collapse(std::size_t q, std::size_t k) {
        const std::array<int, 4> quad = quads_[q];
        const auto corner = [&](std::size_t i) { return static_cast<std::size_t>(quad[(k + i) % 4]); };
        const std::size_t a = corner(0), c = corner(2);
        constexpr double flat = 0.02; // a corner below this is as good as inverted
        Eigen::Vector2d place = points_[c];
        double best = worst(a, c, q, place);
        if (inside(c))
            for (const Eigen::Vector2d &p : {Eigen::Vector2d((points_[a] + points_[c]) / 2), points_[a]})
                if (const double here = worst(a, c, q, p); here > best) {
                    best = here;
                    place = p;
                }
        if (best < flat)
            return false;
        points_[c] = place;
        alive_[q] = 0;
        for (const int v : quad)
            std::erase(at_[static_cast<std::size_t>(v)], q);
        for (const std::size_t r : at_[a]) {
            std::replace(quads_[r].begin(), quads_[r].end(), static_cast<int>(a), static_cast<int>(c));
            at_[c].push_back(r);
        }
        at_[a].clear();
        std::vector<std::size_t> near, changed{q};
        for (const std::size_t v : {c, corner(1), corner(3)})
            for (const std::size_t r : at_[v])
                for (const int u : quads_[r])
                    near.push_back(static_cast<std::size_t>(u));
        for (const std::size_t v : sorted_unique(near)) {
            relax(v);
            changed.insert(changed.end(), at_[v].begin(), at_[v].end());
        }
        for (const std::size_t r : sorted_unique(changed))
            enter(r);
        return true;
    }

    static const std::vector<std::size_t> &sorted_unique(std::vector<std::size_t> &list) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        return list;
    }

    const fill::Request &request_;
    const int boundary_;
    geometry::Points points_;
    std::vector<std::array<int, 4>> quads_;
    std::vector<char> alive_;
    std::vector<std::vector<std::size_t>> at_; // quads at each vertex
    std::vector<Entry> entry_{};
    std::set<Entry> queue_;
    Random random_;
};

} // namespace

std::optional<Coarse> coarsen(const fill::Request &request, const PlacedFilling &old, std::uint64_t seed) {
    std::optional<Coarse> coarse = coarsen_towards(request, old, seed);
    if (coarse && static_cast<std::int64_t>(coarse->shape.filling.quads.size()) != request.faces)
        coarse.reset();
    return coarse;
}

std::optional<Coarse> coarsen_towards(const fill::Request &request, const PlacedFilling &old,
                                      std::uint64_t seed) {
    const auto faces = static_cast<std::int64_t>(old.filling.quads.size());
    Collapser collapser(request, old, seed);
    if (collapser.reach(request.faces) == faces)
        return std::nullopt;
    return Coarse{collapser.result(), collapser.irregular()};
}

} // namespace alphamst::refill
