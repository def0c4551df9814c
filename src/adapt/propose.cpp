#include "adapt/propose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <unordered_map>

#include "fill/exact.h"
#include "fill/plan.h"
#include "geometry/embed.h"
#include "geometry/plane.h"

namespace alphamst::adapt {
namespace {

Eigen::Vector3d vector(const OpenMesh::Vec3d &p) { return {p[0], p[1], p[2]}; }

// A fault of the patch and its sentence, on the way to the outcome.
struct Refusal {
    Fault fault;
    std::string text;
};

std::string name_defects(std::int32_t bits) {
    struct Name {
        std::int32_t bit;
        const char *text;
    };
    constexpr Name names[] = {{patch::empty, "it has no face"},
                              {patch::not_connected, "its faces are not connected through edges"},
                              {patch::not_disk, "it has a hole or closes up"},
                              {patch::pinched, "its boundary touches itself"},
                              {patch::crosses_feature, "a flagged entity or region border lies inside"},
                              {patch::odd_boundary, "its boundary has an odd number of edges"}};
    std::string text = "the patch cannot be refilled:";
    for (const Name &name : names)
        if ((bits & name.bit) != 0)
            text += std::string(text.back() == ':' ? " " : ", ") + name.text;
    return text;
}

// Everything about the patch that its fillings are judged against.
class Site {
public:
    Site(const mesh::QuadMesh &mesh, const Region &patch, const Goal &goal, const Settings &settings)
        : mesh_(mesh), goal_(goal), settings_(settings) {
        const std::int32_t bits = patch::defects(mesh, patch.faces);
        if (bits != 0)
            throw Refusal{Fault::patch, name_defects(bits)};
        window = patch::make_window(mesh, patch.faces);
        if (!patch.corners.empty())
            use_corners(patch.corners);
        flatten();
        read_old_filling();
    }

    // Fillings to try, best first; entries are different in numbers or shape.
    std::vector<fill::Candidate> candidates() const {
        fill::Request request;
        request.word = window.wanted;
        for (std::size_t i = 0; i < window.loop.size(); ++i)
            request.regular.push_back(mesh_.on_boundary(window.loop[i]) ? window.wanted[i] : 4 - window.outside[i]);
        request.angles = patch::loop_angles(mesh_, window);
        request.faces = goal_.faces;
        request.any_count = goal_.any_count;
        request.most = settings_.candidates;
        request.node_limit = settings_.node_limit;
        request.seed = settings_.seed;
        std::vector<fill::Candidate> list = fill::plan(request);
        if (!goal_.forbid_old && old_is_simple() &&
            (goal_.any_count || goal_.faces == static_cast<std::int64_t>(old.quads.size()))) {
            // Between those that have fewer singularities and those that have not.
            const auto faces = static_cast<std::int64_t>(old.quads.size());
            const auto place = std::find_if(list.begin(), list.end(), [&](const fill::Candidate &c) {
                return (!goal_.any_count && c.faces != goal_.faces) || c.singularities >= old_singular_all_;
            });
            const bool last = place == list.end() && static_cast<int>(list.size()) >= settings_.candidates;
            list.insert(last ? place - 1 : place, {faces, old_singular_all_, 0, [this] { return old; }});
        }
        return list;
    }

    // No edge of the filling may double one outside.
    bool fits(const fill::Filling &filling) const {
        const int length = filling.boundary;
        for (const auto &quad : filling.quads)
            for (std::size_t k = 0; k < 4; ++k) {
                const int a = quad[k], b = quad[(k + 1) % 4];
                if (a >= length || b >= length || (a + 1) % length == b || (b + 1) % length == a)
                    continue;
                const int edge = mesh_.find_edge(window.loop[static_cast<std::size_t>(a)],
                                                 window.loop[static_cast<std::size_t>(b)]);
                if (edge >= 0 && !inside(edge))
                    return false;
            }
        return true;
    }

    // Singular vertices of the mesh in the patch with this filling.
    std::map<int, std::int64_t> valences(const fill::Filling &filling) const {
        std::vector<int> faces(static_cast<std::size_t>(filling.vertices), 0);
        for (const auto &quad : filling.quads)
            for (const int v : quad)
                ++faces[static_cast<std::size_t>(v)];
        std::map<int, std::int64_t> count;
        for (std::size_t v = 0; v < faces.size(); ++v) {
            if (v < window.loop.size() && mesh_.on_boundary(window.loop[v]))
                continue;
            ++count[faces[v] + (v < window.loop.size() ? window.outside[v] : 0)];
        }
        return count;
    }

    geometry::Embedding embed(const fill::Filling &filling) const {
        geometry::EmbedOptions options;
        options.steps = settings_.smooth_steps;
        if (&filling == &old || filling.quads == old.quads) {
            std::vector<char> fixed(static_cast<std::size_t>(filling.vertices), 0);
            std::fill_n(fixed.begin(), window.loop.size(), 1);
            geometry::Embedding kept = geometry::improve(old.quads, fixed, old_positions_, options);
            if (kept.valid)
                return kept;
        }
        const std::span<const Eigen::Vector2d> loop(old_positions_.data(), window.loop.size());
        return geometry::embed(filling.quads, filling.boundary, filling.vertices, loop, options);
    }

    std::vector<OpenMesh::Vec3d> lift(const geometry::Points &positions) const {
        std::vector<OpenMesh::Vec3d> points;
        for (std::size_t v = window.loop.size(); v < positions.size(); ++v) {
            if (mesh_.dim() == 2) {
                points.emplace_back(positions[v].x(), positions[v].y(), 0.0);
                continue;
            }
            const Eigen::Vector3d p = plane_.to_space(positions[v]);
            points.emplace_back(p.x(), p.y(), p.z());
        }
        return points;
    }

    patch::Window window;
    fill::Filling old;
    double old_quality = 0;

private:
    // The caller's corners have one face, all other boundary vertices are flat.
    void use_corners(const std::vector<int> &corners) {
        std::fill(window.wanted.begin(), window.wanted.end(), 2);
        for (const int corner : corners) {
            const auto at = std::find(window.loop.begin(), window.loop.end(), corner);
            if (at == window.loop.end())
                throw Refusal{Fault::patch, "a corner of the patch is not on its boundary; set the corners anew"};
            window.wanted[static_cast<std::size_t>(at - window.loop.begin())] = 1;
        }
    }

    void flatten() {
        std::vector<Eigen::Vector3d> points;
        for (const int v : window.loop)
            points.push_back(vector(mesh_.point(v)));
        for (const int v : window.interior)
            points.push_back(vector(mesh_.point(v)));
        if (mesh_.dim() == 2) {
            for (const Eigen::Vector3d &p : points)
                old_positions_.push_back(p.head<2>());
            return;
        }
        Eigen::Vector3d normal = Eigen::Vector3d::Zero(), low = points[0], high = points[0];
        for (std::size_t i = 0; i < window.loop.size(); ++i)
            normal += (points[i] - points[0]).cross(points[(i + 1) % window.loop.size()] - points[0]);
        for (const Eigen::Vector3d &p : points) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        plane_ = geometry::Plane::fit(points, normal);
        constexpr double flat = 1e-7; // of the patch's size: rounding in files, not curvature
        if (plane_.deviation(points) > flat * (high - low).norm())
            throw Refusal{Fault::unsupported, "the patch is curved; this version adapts patches that lie in a plane"};
        for (const Eigen::Vector3d &p : points)
            old_positions_.push_back(plane_.to_plane(p));
    }

    void read_old_filling() {
        std::unordered_map<int, int> local;
        for (const int v : window.loop)
            local.emplace(v, static_cast<int>(local.size()));
        for (const int v : window.interior)
            local.emplace(v, static_cast<int>(local.size()));
        old.boundary = static_cast<int>(window.loop.size());
        old.vertices = static_cast<int>(local.size());
        for (const int f : window.faces) {
            const auto corners = mesh_.corners(f);
            old.quads.push_back({local.at(corners[0]), local.at(corners[1]), local.at(corners[2]), local.at(corners[3])});
        }
        const geometry::Embedding judged = geometry::judge(old.quads, old_positions_);
        old_quality = judged.min_scaled_jacobian;
        for (const auto &[valence, count] : valences(old))
            old_singular_all_ += valence != 4 ? static_cast<int>(count) : 0;
        for (std::size_t i = 0; i < window.loop.size(); ++i)
            old_singular_all_ += mesh_.on_boundary(window.loop[i]) && window.inside[i] != window.wanted[i];
    }

    // Nothing that a new filling could not have: valences 3 to 5 or what the outside forces.
    bool old_is_simple() const {
        std::vector<int> faces(static_cast<std::size_t>(old.vertices), 0);
        for (const auto &quad : old.quads)
            for (const int v : quad)
                ++faces[static_cast<std::size_t>(v)];
        return std::all_of(faces.begin() + old.boundary, faces.end(), [](int f) { return f >= 3 && f <= 5; });
    }

    bool inside(int edge) const {
        const auto sides = mesh_.edge_faces(edge);
        auto mine = [&](int f) { return f >= 0 && std::binary_search(window.faces.begin(), window.faces.end(), f); };
        return mine(sides[0]) && mine(sides[1]);
    }

    const mesh::QuadMesh &mesh_;
    const Goal &goal_;
    const Settings &settings_;
    geometry::Plane plane_;
    geometry::Points old_positions_; // loop, then interior
    int old_singular_all_ = 0;       // and mismatches on the mesh boundary
};

std::int64_t singular(const std::map<int, std::int64_t> &valences) {
    std::int64_t sum = 0;
    for (const auto &[valence, count] : valences)
        sum += valence != 4 ? count : 0;
    return sum;
}

[[noreturn]] void refuse_count(const Site &site, const Goal &goal) {
    const std::int64_t least = static_cast<std::int64_t>(site.window.loop.size()) / 2 - 1;
    std::string text = "no filling with " + std::to_string(goal.faces) + " faces was found";
    text += goal.faces < least ? "; the boundary of " + std::to_string(site.window.loop.size()) +
                                     " edges needs at least " + std::to_string(least)
                               : "; try another alpha or a rounder patch";
    throw Refusal{Fault::no_filling, text};
}

// Least number of singular vertices that any filling of this boundary has.
std::int64_t bound(const Site &site, const mesh::QuadMesh &mesh) {
    const auto &window = site.window;
    std::int64_t forced = 0;
    for (std::size_t i = 0; i < window.loop.size(); ++i)
        forced += !mesh.on_boundary(window.loop[i]) && window.outside[i] >= 4;
    return forced;
}

// The best embedding so far and where it came from.
struct Best {
    fill::Filling filling;
    geometry::Embedding embedding;
    std::map<int, std::int64_t> valences;
    std::int64_t number = -1;
};

Best choose(const Site &site, const Goal &goal, const Settings &settings) {
    const std::vector<fill::Candidate> candidates = site.candidates();
    Best best;
    std::int64_t first_faces = -1, first_singular = -1, number = 0;
    bool any_fits = false;
    for (const fill::Candidate &candidate : candidates) {
        fill::Filling filling = candidate.build();
        if (!site.fits(filling))
            continue;
        auto valences = site.valences(filling);
        const std::int64_t singular_now = singular(valences);
        const auto faces = static_cast<std::int64_t>(filling.quads.size());
        if (!any_fits) {
            first_faces = faces;
            first_singular = singular_now;
        }
        any_fits = true;
        // A valid filling with the predicted numbers is only given up for a better shape with the
        // same numbers.
        const bool as_predicted = faces == first_faces && singular_now == first_singular;
        if (best.number == 0 && !as_predicted)
            break;
        geometry::Embedding embedding = site.embed(filling);
        number += as_predicted ? 0 : 1;
        if (!embedding.valid || embedding.min_scaled_jacobian <= settings.min_quality)
            continue;
        const bool better = best.number < 0 ||
                            embedding.min_scaled_jacobian > best.embedding.min_scaled_jacobian;
        if (better)
            best = {std::move(filling), std::move(embedding), std::move(valences), as_predicted ? 0 : number};
        if (!goal.keep_quality || best.embedding.min_scaled_jacobian >= site.old_quality)
            break;
    }
    if (!any_fits)
        refuse_count(site, goal);
    if (best.number < 0)
        throw Refusal{Fault::geometry, "none of " + std::to_string(candidates.size()) +
                                           " fillings could be given a valid shape; try another alpha, a rounder "
                                           "patch or a larger number of candidates"};
    return best;
}

} // namespace

std::int64_t wanted_faces(double alpha, std::size_t faces) {
    return std::llround(std::min(alpha * static_cast<double>(faces), 4e18));
}

Proposal propose(const mesh::QuadMesh &mesh, const Region &patch, const Goal &goal, const Settings &settings) {
    const auto start = std::chrono::steady_clock::now();
    Proposal proposal;
    Outcome &outcome = proposal.outcome;
    outcome.faces_before = outcome.faces_after = static_cast<std::int64_t>(patch.faces.size());
    outcome.faces_wanted = goal.faces;
    try {
        const Site site(mesh, patch, goal, settings);
        outcome.valences_before = outcome.valences_after = site.valences(site.old);
        outcome.singular_before = outcome.singular_after = singular(outcome.valences_before);
        outcome.singular_bound = bound(site, mesh);
        outcome.quality_before = outcome.quality_after = site.old_quality;
        proposal.window = site.window;
        Best best = choose(site, goal, settings);
        proposal.points = site.lift(best.embedding.positions);
        proposal.filling = std::move(best.filling);
        outcome.faces_after = static_cast<std::int64_t>(proposal.filling.quads.size());
        outcome.valences_after = std::move(best.valences);
        outcome.singular_after = singular(outcome.valences_after);
        outcome.candidate = best.number;
        outcome.quality_after = best.embedding.min_scaled_jacobian;
    } catch (const Refusal &refusal) {
        outcome.fault = refusal.fault;
        outcome.text = refusal.text;
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return proposal;
}

Prediction first_choice(const mesh::QuadMesh &mesh, const Region &patch, const Goal &goal, const Settings &settings) {
    try {
        const Site site(mesh, patch, goal, settings);
        for (const fill::Candidate &candidate : site.candidates()) {
            const fill::Filling filling = candidate.build();
            if (site.fits(filling))
                return {static_cast<std::int64_t>(filling.quads.size()), singular(site.valences(filling))};
        }
        refuse_count(site, goal);
    } catch (const Refusal &refusal) {
        throw Failure(refusal.fault, refusal.text);
    }
}

mesh::QuadMesh::Replaced commit(mesh::QuadMesh &mesh, const Proposal &proposal) {
    return mesh.replace_disk(proposal.window.faces, proposal.window.loop, proposal.filling.quads, proposal.points);
}

} // namespace alphamst::adapt
