#include "adapt/sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <unordered_set>

#include "adapt/commit.h"
#include "index.h"
#include "reference/locate.h"
#include "reference/statistics.h"

namespace alphamst::adapt {
namespace {

constexpr int buffer_layers = 2;
constexpr std::size_t most_windows = 64;   // in a round
constexpr double crowding = 0.25;          // of the faces wanted in a window
constexpr double even_enough = 0.15;       // as little as that is not worth spreading faces
constexpr int most_elsewhere = 16;         // windows around regular vertices, for the count
constexpr std::size_t most_for_count = 32; // windows that a pass for the count tries
// Where hardly any window gets refilled, windows of a round may geometry::overlap: it seldom matters. Where
// as many as one in so many does, they would stand in each other's way.
constexpr int seldom = 8;
// Of edges of the boundary, log2 of their length over what is wanted.
constexpr double uneven = 0.3;

} // namespace

// Windows that are tried together. All arrays are [window].
struct Sweep::Round {
    std::vector<int> seeds; // places in seeds_
    std::vector<Random> luck;
    std::vector<refill::Place> places;
    std::vector<std::optional<refill::Goal>> goals;
    std::vector<std::optional<refill::Replacement>> found;
    std::vector<refill::Trace> traces;
};

Sweep::Sweep(mesh::QuadMesh &mesh, reference::Reference &reference, std::vector<double> target_counts,
             const std::optional<reference::SizingField> &density, const Settings &settings)
    : mesh_(mesh), reference_(reference), settings_(settings), target_counts_(std::move(target_counts)),
      sizing_(density),
      wanted_(std::llround(std::accumulate(target_counts_.begin(), target_counts_.end(), 0.0))),
      workers_(settings.threads), growths_(static_cast<std::size_t>(workers_.count()), patch::Growth(mesh)),
      random_(settings.seed), singular_(static_cast<int>(irregular().size())) {}

std::vector<int> Sweep::irregular() const {
    std::vector<int> vertices;
    for (int v = 0; v < mesh_.n_vertices(); ++v)
        if (!mesh_.isolated(v) &&
            (mesh_.on_boundary(v) ? reference::mismatch(mesh_, v) != 0 : mesh_.singular(v)))
            vertices.push_back(v);
    return vertices;
}

// The singular vertex nearest by edges that has more edges than 4 where this one has fewer, or the
// other way round; -1 if there is none near. Such pairs may cancel each other.
int Sweep::partner(int vertex) const {
    if (mesh_.on_boundary(vertex))
        return -1;
    constexpr std::size_t most_looked_at = 300;
    const bool few = mesh_.valence(vertex) < 4;
    std::vector<int> found{vertex};
    std::unordered_set<int> seen{vertex};
    for (std::size_t i = 0; i < found.size() && found.size() < most_looked_at; ++i)
        for (const int v : mesh_.vertices_around(found[i])) {
            if (!seen.insert(v).second)
                continue;
            if (mesh_.singular(v) && (mesh_.valence(v) > 4) == few)
                return v;
            found.push_back(v);
        }
    return -1;
}

patch::GrowthPlan Sweep::plan_window(int vertex, int size, Random random) const {
    patch::GrowthPlan plan;
    plan.start = vertex;
    plan.most = std::max(4, static_cast<int>(static_cast<std::uint64_t>(size) * (70 + random() % 60) / 100));
    switch (random() % 4) {
    case 0:
        plan.nearness = patch::Nearness::ellipse;
        plan.direction = static_cast<double>(random() % 180) * std::numbers::pi / 180;
        break;
    case 1:
        plan.nearness = patch::Nearness::rings;
        break;
    case 2:
        plan.other = partner(vertex);
        if (plan.other >= 0)
            plan.nearness = patch::Nearness::path;
        break;
    default:
        break;
    }
    return plan;
}

// Of a window that gets other vertices on the boundary, and as many faces as go with them.
refill::Goal Sweep::respaced(refill::Goal goal, std::int64_t now, double target_count) {
    goal.respace = goal.forbid_old = true;
    goal.faces = std::max<std::int64_t>(1, std::llround(target_count));
    goal.fewest = std::max<std::int64_t>(1, std::min(now, goal.faces) / 2);
    goal.most = 2 * std::max(now, goal.faces);
    return goal;
}

std::optional<refill::Goal> Sweep::goal_of(const Pass &pass, const std::vector<int> &faces) const {
    double target_count = 0;
    for (const int f : faces)
        target_count += target_counts_[at(f)];
    const auto now = static_cast<std::int64_t>(faces.size());
    refill::Goal goal;
    goal.any_count = true;
    goal.most_added = pass.most_added;
    if (pass.purpose == Purpose::mend) {
        goal.faces = goal.fewest = goal.most = now;
        goal.forbid_old = true;
        return goal;
    }
    if (pass.purpose == Purpose::collapse) {
        const std::int64_t fewest =
            std::max<std::int64_t>({std::llround(collapse_to * target_count), now / 2, 1});
        if (static_cast<double>(now - fewest) < even_enough * static_cast<double>(now))
            return std::nullopt;
        goal.any_count = false;
        goal.collapse = true;
        goal.most_added = refill::Goal().most_added;
        goal.faces = goal.fewest = goal.most = fewest;
        return goal;
    }
    if (pass.purpose == Purpose::respace)
        return respaced(goal, now, target_count);
    if (pass.purpose != Purpose::fewer_singularities && pass.purpose != Purpose::wander &&
        pass.purpose != Purpose::turn) {
        const bool spread = pass.purpose == Purpose::spread;
        const std::int64_t lacking = spread ? std::llround(target_count) - now : missing();
        if (spread && static_cast<double>(std::abs(lacking)) < even_enough * static_cast<double>(now))
            return std::nullopt;
        const std::int64_t step = std::max<std::int64_t>(1, now / (spread ? 2 : 4));
        const std::int64_t aim = std::clamp(lacking, -step, step), least = spread ? aim / 3 : 0;
        goal.faces = now + aim; // or any that is nearer to what is wanted
        goal.fewest = std::max<std::int64_t>(1, aim > 0 ? now + std::max<std::int64_t>(1, least) : now + aim);
        goal.most = aim > 0 ? now + aim : now + std::min<std::int64_t>(-1, least);
        return goal;
    }
    if (pass.purpose == Purpose::wander || pass.purpose == Purpose::turn) {
        goal.most_added = 0;
        goal.forbid_old = true;
        goal.turn = pass.purpose == Purpose::turn;
    }
    // What a commit may do to the total; see welcome.
    const auto slack = std::max<std::int64_t>(8, std::llround(pass.slack * static_cast<double>(wanted_)));
    const std::int64_t low = std::min<std::int64_t>(0, missing() - slack),
                       high = std::max<std::int64_t>(0, missing() + slack);
    goal.fewest = std::max({now / 2, now + low, std::int64_t{1}});
    goal.most = std::min(2 * now, now + high);
    if (sizing_) { // nor may faces gather where they are not wanted
        goal.fewest = std::max<std::int64_t>(
            goal.fewest, std::min<std::int64_t>(now, std::llround(target_count * (1 - crowding))));
        goal.most = std::max(
            goal.fewest,
            std::min(goal.most, std::max<std::int64_t>(now, std::llround(target_count * (1 + crowding)))));
    }
    goal.faces = std::clamp<std::int64_t>(std::llround(target_count), goal.fewest, goal.most);
    return goal;
}

// A commit brings the number of faces nearer to what is wanted, or leaves it within the slack.
bool Sweep::welcome(const Pass &pass, const refill::Replacement &found) const {
    if (found.singular_change > std::max(0, most_singular_ - singular_))
        return false;
    const auto more = static_cast<std::int64_t>(found.filling.quads.size()) -
                      static_cast<std::int64_t>(found.window.faces.size());
    const std::int64_t miss = std::abs(missing() - more);
    if (miss < std::abs(missing()))
        return true;
    return pass.purpose != Purpose::count &&
           static_cast<double>(miss) <= std::max(8.0, pass.slack * static_cast<double>(wanted_));
}

// The next windows whose seeds are still worth it, grown.
Sweep::Round Sweep::plan_round(const Pass &pass) {
    Round round;
    while (!waiting_.empty() && round.seeds.size() < most_windows) {
        const int next = waiting_.front(), vertex = vertices_.now(seeds_[at(next)]);
        waiting_.pop_front();
        if (vertex < 0 || mesh_.isolated(vertex) ||
            (pass.purpose == Purpose::fewer_singularities && !mesh_.on_boundary(vertex) &&
             !mesh_.singular(vertex)))
            continue;
        round.seeds.push_back(next);
        round.luck.emplace_back(random_());
    }
    grow_windows(pass, round);
    choose_windows(pass, round);
    return round;
}

void Sweep::grow_windows(const Pass &pass, Round &round) {
    round.places.resize(round.seeds.size());
    round.goals.resize(round.seeds.size());
    workers_.run(round.seeds.size(), [&](std::size_t i, std::size_t worker) {
        patch::Growth &growth = growths_[worker];
        refill::Place &place = round.places[i];
        place.faces =
            growth.disk(plan_window(vertices_.now(seeds_[at(round.seeds[i])]), pass.size, round.luck[i]));
        if (place.faces.empty())
            return;
        const std::vector<int> all = growth.surround(place.faces, buffer_layers);
        place.buffer.assign(all.begin() + static_cast<std::ptrdiff_t>(place.faces.size()), all.end());
        round.goals[i] = goal_of(pass, place.faces);
        if (round.goals[i])
            round.goals[i]->most_added =
                std::min(round.goals[i]->most_added, std::max(0, most_singular_ - singular_));
    });
}

// Marks the faces of a window and its buffer as taken, unless one is already.
bool Sweep::take(const refill::Place &place) {
    for (const auto *faces : {&place.faces, &place.buffer})
        for (const int f : *faces)
            if (taken_[at(f)] == epoch_)
                return false;
    for (const auto *faces : {&place.faces, &place.buffer})
        for (const int f : *faces)
            taken_[at(f)] = epoch_;
    return true;
}

// Leaves those with a goal in the round; those that would stand in the way of others wait.
void Sweep::choose_windows(const Pass &pass, Round &round) {
    taken_.resize(std::max(taken_.size(), at(mesh_.n_faces())), 0);
    ++epoch_;
    const bool apart = pass.purpose == Purpose::count || refilled_ * seldom >= tried_;
    Round chosen;
    std::vector<int> later;
    for (std::size_t i = 0; i < round.seeds.size(); ++i) {
        if (!round.goals[i])
            continue;
        if (apart && !take(round.places[i])) {
            later.push_back(round.seeds[i]);
            continue;
        }
        chosen.seeds.push_back(round.seeds[i]);
        chosen.places.push_back(std::move(round.places[i]));
        chosen.goals.push_back(round.goals[i]);
    }
    waiting_.insert(waiting_.begin(), later.begin(), later.end());
    round = std::move(chosen);
}

// Target counts and seeds go with what a commit renumbers.
void Sweep::follow(const refill::Replacement &taken, const mesh::QuadMesh::Replaced &replaced) {
    double target_count = 0;
    for (const int f : taken.window.faces)
        target_count += target_counts_[at(f)];
    target_counts_.resize(std::max(target_counts_.size(), at(mesh_.n_faces())));
    std::vector<double> weights(replaced.faces.size(), 1);
    if (sizing_)
        weights = sizing_->weights(mesh_, replaced.faces);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (std::size_t i = 0; i < weights.size(); ++i)
        target_counts_[at(replaced.faces[i])] = target_count * weights[i] / sum;
    for (const auto &[from, to] : replaced.moved_faces)
        target_counts_[at(to)] = target_counts_[at(from)];
    target_counts_.resize(at(mesh_.n_faces()));
    for (const int v : taken.window.interior)
        vertices_.remove(v);
    for (const int v : replaced.vertices)
        vertices_.add(v);
    for (const auto &[from, to] : replaced.moved_vertices)
        vertices_.move(from, to);
}

// In parallel. What is known to be in vain counts as tried, so the search ends as it would without that.
void Sweep::try_windows(const Pass &pass, Round &round) {
    const std::size_t windows = round.places.size();
    round.found.resize(windows);
    round.traces.resize(windows);
    const double tolerance = reference_.surface_distance ? reference_.surface_distance->tolerance() : 0;
    std::vector<std::uint64_t> fingerprints(windows);
    for (std::size_t i = 0; i < windows; ++i) {
        effort_ += static_cast<std::int64_t>(round.places[i].faces.size());
        fingerprints[i] = fingerprint(mesh_, round.places[i], *round.goals[i], pass.shape, tolerance);
    }
    workers_.run(windows, [&](std::size_t i, std::size_t) {
        if (!failed_.hold(fingerprints[i]))
            round.found[i] = refill::refill_window(mesh_, round.places[i], *round.goals[i], pass.shape,
                                                   settings_, reference_, round.traces[i]);
    });
    for (std::size_t i = 0; i < windows; ++i)
        if (!round.found[i])
            failed_.add(fingerprints[i]);
}

// In order; a window that overlaps one refilled before it waits for another round.
void Sweep::commit_round(const Pass &pass, const char *stage, Round &round) {
    Commits commits(mesh_, reference_);
    std::vector<int> later;
    ++epoch_;
    for (std::size_t i = 0; i < round.found.size(); ++i) {
        auto &found = round.found[i];
        ++tried_;
        const bool taken = found && welcome(pass, *found);
        if (taken && !take(round.places[i])) {
            later.push_back(round.seeds[i]);
            continue;
        }
        log_window(settings_, mesh_, stage, vertices_.now(seeds_[at(round.seeds[i])]), round.places[i],
                   round.traces[i], taken ? &*found : nullptr);
        if (!taken)
            continue;
        follow(*found, commits.put(*found, round.places[i].buffer));
        singular_ += found->singular_change;
        ++refilled_;
    }
    waiting_.insert(waiting_.begin(), later.begin(), later.end());
}

// The first corners of faces whose scaled Jacobians are smaller.
std::vector<int> Sweep::misshapen(double scaled_jacobian) const {
    std::vector<int> vertices;
    const std::vector<double> quality = reference_.scaled_jacobians(mesh_);
    for (int f = 0; f < mesh_.n_faces(); ++f)
        if (quality[at(f)] < scaled_jacobian)
            vertices.push_back(mesh_.corners(f)[0]);
    return vertices;
}

// Vertices of the boundary that may go and from which an edge is not as long as is wanted.
std::vector<int> Sweep::misspaced() const {
    std::vector<int> vertices;
    for (int e = 0; reference_.boundary && e < mesh_.n_edges(); ++e) {
        const auto [left, right] = mesh_.edge_faces(e);
        if (left >= 0 && right >= 0)
            continue;
        const auto [v, w] = mesh_.edge_vertices(e);
        const std::vector<surface::CurvePlace> &places = reference_.boundary->places;
        if (places[at(v)].curve < 0 || places[at(w)].curve < 0)
            continue;
        const Eigen::Vector3d a = reference::point_of(mesh_, v), b = reference::point_of(mesh_, w);
        if (std::abs(std::log2((b - a).norm() / reference_.edge_length(places[at(v)]))) > uneven)
            vertices.push_back(reference_.boundary->may_go(v) ? v : w);
    }
    return vertices;
}

// In random order.
std::vector<int> Sweep::choose_seeds(const Pass &pass) {
    std::vector<int> seeds;
    if (pass.purpose == Purpose::respace)
        seeds = misspaced();
    else if (pass.purpose != Purpose::collapse && pass.purpose != Purpose::turn)
        seeds = pass.purpose == Purpose::mend ? misshapen(pass.shape.scaled_jacobian) : irregular();
    const bool everywhere =
        pass.purpose == Purpose::spread || pass.purpose == Purpose::collapse || pass.purpose == Purpose::turn;
    const int elsewhere = pass.purpose == Purpose::count ? most_elsewhere
                          : everywhere                   ? 2 * mesh_.n_faces() / std::max(1, pass.size)
                                                         : 0;
    for (int k = 0; k < elsewhere && mesh_.n_vertices() > 0; ++k)
        seeds.push_back(static_cast<int>(random_() % static_cast<std::uint64_t>(mesh_.n_vertices())));
    std::sort(seeds.begin(), seeds.end());
    seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
    for (std::size_t i = seeds.size(); i > 1; --i)
        std::swap(seeds[i - 1], seeds[random_() % i]);
    if (pass.purpose == Purpose::count)
        seeds.resize(std::min(seeds.size(), most_for_count));
    return seeds;
}

int Sweep::run(const Pass &pass, const char *stage, const std::function<void(double)> &between) {
    seeds_ = choose_seeds(pass);
    vertices_ = mesh::Renumbered(mesh_.n_vertices());
    waiting_.resize(seeds_.size());
    std::iota(waiting_.begin(), waiting_.end(), 0);
    tried_ = refilled_ = 0;
    while (!waiting_.empty() && !(pass.purpose == Purpose::count && missing() == 0)) {
        between(1 - static_cast<double>(waiting_.size()) / static_cast<double>(seeds_.size()));
        Round round = plan_round(pass);
        try_windows(pass, round);
        commit_round(pass, stage, round);
    }
    log_stage(settings_, stage, {pass.size, tried_, refilled_, singular_, missing()});
    return refilled_;
}

} // namespace alphamst::adapt
