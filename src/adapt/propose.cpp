#include "adapt/propose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "adapt/coarsen.h"
#include "fill/plan.h"
#include "geometry/embed.h"
#include "geometry/plane.h"
#include "patch/patches.h"

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
        regular_ = window.wanted;
        if (!patch.corners.empty())
            use_corners(patch.corners);
        flatten();
        read_old_filling();
        if (goal.keep_quality && patch.corners.empty())
            keep_angles();
    }

    // A filling by its numbers, made when asked for.
    struct Offer {
        std::int64_t faces = 0;
        int singularities = 0;
        std::function<Shape()> build;
    };
    using Group = std::vector<Offer>;
    using Source = std::function<Group()>; // the next group each time, empty at the end

    // Where fillings come from, best first, all made only when asked for.
    std::vector<Source> sources() const {
        std::vector<Source> list;
        if (goal_.keep_quality) {
            // A smallest scaled Jacobian that is already good is seldom reached again next to
            // a boundary that cannot move: there a rim of faces stays.
            constexpr double good = 0.6;
            if (old_quality < good)
                list.push_back(templates(request()));
            list.push_back(inner(1));
            list.push_back(inner(2));
        } else if (goal_.any_count) {
            list.push_back(templates(request()));
        } else {
            const bool late = ragged(); // templates seldom follow a ragged boundary
            if (!late)
                list.push_back(templates(request()));
            list.push_back(inner(1));
            list.push_back(collapsed());
            if (late)
                list.push_back(templates(request()));
            fill::Request near = request();
            near.tolerance = 2;
            list.push_back(templates(std::move(near)));
        }
        return list;
    }

    // The filling that is there, if it has the wanted numbers.
    std::optional<Offer> present() const {
        const auto faces = static_cast<std::int64_t>(old.quads.size());
        if (goal_.forbid_old || (!goal_.any_count && goal_.faces != faces))
            return std::nullopt;
        return Offer{faces, old_singular_all_, [this] { return Shape{old, old_positions_}; }};
    }

    // The boundary is so long for the faces, present or wanted, that templates seldom follow its turns.
    bool ragged() const {
        const auto length = static_cast<std::int64_t>(window.loop.size());
        return length * length > 64 * static_cast<std::int64_t>(window.faces.size()) || length * length > 52 * goal_.faces;
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

    geometry::Embedding embed(const Shape &shape) const {
        geometry::EmbedOptions options;
        options.steps = settings_.smooth_steps;
        const fill::Filling &filling = shape.filling;
        if (!shape.positions.empty()) {
            std::vector<char> fixed(static_cast<std::size_t>(filling.vertices), 0);
            std::fill_n(fixed.begin(), window.loop.size(), 1);
            geometry::Embedding kept = geometry::improve(filling.quads, fixed, shape.positions, options);
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
    // The inside of the patch and the faces around it, which stay.
    struct Inner {
        Inner(const Site &site, patch::Window inside) : window(std::move(inside)) {
            rim.boundary = static_cast<int>(site.window.loop.size());
            rim.vertices = rim.boundary;
            std::vector<int> name(static_cast<std::size_t>(site.old.vertices), -1);
            for (int v = 0; v < rim.boundary; ++v)
                name[static_cast<std::size_t>(v)] = v;
            auto renamed = [&](int v) {
                int &number = name[static_cast<std::size_t>(v)];
                if (number < 0)
                    number = rim.vertices++;
                return number;
            };
            for (const int v : window.loop)
                loop.push_back(renamed(site.local_.at(v)));
            for (std::size_t q = 0; q < site.old.quads.size(); ++q) {
                if (std::binary_search(window.faces.begin(), window.faces.end(), site.window.faces[q]))
                    continue;
                rim.quads.push_back({});
                for (std::size_t k = 0; k < 4; ++k)
                    rim.quads.back()[k] = renamed(site.old.quads[q][k]);
            }
            singular_outside = site.old_singular_all_;
            for (const auto *list : {&window.loop, &window.interior})
                for (const int v : *list)
                    singular_outside -= site.mesh_.singular(v);
        }
        fill::Filling complete(const fill::Filling &inside) const {
            fill::Filling whole = rim;
            fill::append(whole, inside, loop);
            return whole;
        }

        patch::Window window;
        fill::Filling rim;     // boundary of the patch, kept faces
        std::vector<int> loop; // of the inside, as vertices of rim
        int singular_outside = 0;
    };

    static Source templates(fill::Request request) {
        return [plan = std::make_shared<fill::Plan>(std::move(request))] {
            Group group;
            for (fill::Candidate &candidate : plan->next())
                group.push_back({candidate.faces, candidate.singularities,
                                 [make = std::move(candidate.build)] { return Shape{make(), {}}; }});
            return group;
        };
    }

    // Quads of the present filling collapsed, for when nothing more regular is valid.
    Source collapsed() const {
        return [this, round = std::uint64_t{0}]() mutable {
            Group group;
            for (; group.empty() && round < 8 && goal_.faces < static_cast<std::int64_t>(old.quads.size()); ++round)
                if (auto coarse = coarsen(request(), {old, old_positions_}, settings_.seed + 1000003 * round))
                    group.push_back({goal_.faces, coarse->singularities,
                                     [shape = std::move(coarse->shape)] { return shape; }});
            return group;
        };
    }

    // New fillings of what lies at least so many layers of faces off the boundary; the
    // faces in between stay as they are.
    Source inner(int layers) const {
        return [this, layers, source = Source()]() mutable {
            if (!source)
                source = start_inner(layers);
            return source();
        };
    }

    Source start_inner(int layers) const {
        std::vector<int> faces = window.faces;
        for (int layer = 0; layer < layers; ++layer) {
            std::vector<int> rim = layer == 0 ? window.loop : border(faces);
            std::sort(rim.begin(), rim.end());
            std::erase_if(faces, [&](int f) {
                const auto corners = mesh_.corners(f);
                return std::any_of(corners.begin(), corners.end(),
                                   [&](int v) { return std::binary_search(rim.begin(), rim.end(), v); });
            });
        }
        const std::vector<char> none(static_cast<std::size_t>(mesh_.n_faces()), 0);
        faces = patch::repair(mesh_, std::move(faces), none);
        const auto kept = static_cast<std::int64_t>(window.faces.size() - faces.size());
        if (faces.size() < 4 || goal_.faces <= kept)
            return [] { return Group{}; };
        const auto inside = std::make_shared<const Inner>(*this, patch::make_window(mesh_, faces));
        fill::Request request = this->request();
        request.word = inside->window.wanted;
        request.regular.clear();
        for (const int outside : inside->window.outside)
            request.regular.push_back(4 - outside);
        request.angles.clear(); // its boundary can move
        request.faces = goal_.faces - kept;
        return [inside, kept, next = templates(std::move(request))] {
            Group group = next();
            for (Offer &offer : group) {
                offer.faces += kept;
                offer.singularities += inside->singular_outside;
                offer.build = [inside, make = std::move(offer.build)] {
                    return Shape{inside->complete(make().filling), {}};
                };
            }
            return group;
        };
    }

    // Vertices at which both a face of the set and another face of the patch lie, or the loop.
    std::vector<int> border(const std::vector<int> &faces) const {
        std::vector<int> vertices;
        for (const int f : window.faces)
            if (!std::binary_search(faces.begin(), faces.end(), f))
                for (const int v : mesh_.corners(f))
                    vertices.push_back(v);
        return vertices;
    }

    fill::Request request() const {
        fill::Request request;
        request.word = window.wanted;
        for (std::size_t i = 0; i < window.loop.size(); ++i)
            request.regular.push_back(mesh_.on_boundary(window.loop[i]) ? regular_[i] : 4 - window.outside[i]);
        request.angles = patch::loop_angles(mesh_, window);
        request.least_sine = least_sine_;
        request.faces = goal_.faces;
        request.any_count = goal_.any_count;
        request.most = settings_.candidates;
        request.node_limit = settings_.node_limit;
        request.seed = settings_.seed;
        request.tolerance = 0;
        return request;
    }

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

    // A vertex stays singular where the regular letter would split its angle worse than the
    // worst corner there is.
    void keep_angles() {
        least_sine_ = std::min(0.95, old_quality + 0.01);
        const std::vector<double> angles = patch::loop_angles(mesh_, window);
        for (std::size_t i = 0; i < angles.size(); ++i) {
            auto sine = [&](int letter) {
                constexpr double degree = 3.14159265358979323846 / 180;
                return angles[i] < 175 * letter ? std::sin(angles[i] / letter * degree) : -1;
            };
            int best = window.wanted[i];
            for (int away = 1; away < 3 && sine(best) < least_sine_; ++away)
                for (const int letter : {window.wanted[i] - away, window.wanted[i] + away})
                    if (letter >= 1 && letter <= 4 && sine(letter) > sine(best))
                        best = letter;
            window.wanted[i] = best;
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
        auto &local = local_;
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
            old_singular_all_ += mesh_.on_boundary(window.loop[i]) && window.inside[i] != regular_[i];
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
    double least_sine_ = 0;
    std::unordered_map<int, int> local_; // vertex of the mesh -> of old
    std::vector<int> regular_; // letters that the mesh wants, whatever this goal makes of them
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

// A smallest scaled Jacobian (Verdict's acceptable one) above which other fillings of the same
// numbers are not tried.
constexpr double comfortable = 0.3;

// Tries fillings in their order and keeps the best shape. The first that fits sets the numbers
// that were predicted.
class Choice {
public:
    Choice(const Site &site, const Goal &goal, const Settings &settings)
        : site_(site), goal_(goal), settings_(settings), present_(site.present()) {}

    Best run() {
        each([&](Shape shape) { return !try_one(std::move(shape)); });
        if (first_faces_ < 0)
            refuse_count(site_, goal_);
        if (best_.number < 0)
            throw Refusal{Fault::geometry, "none of " + std::to_string(tried_) +
                                               " fillings could be given a valid shape; try another alpha, a rounder "
                                               "patch or a larger number of candidates"};
        return std::move(best_);
    }

    Prediction first() {
        std::optional<Prediction> found;
        each([&](const Shape &shape) {
            found = {static_cast<std::int64_t>(shape.filling.quads.size()), singular(site_.valences(shape.filling))};
            return false;
        });
        if (!found)
            refuse_count(site_, goal_);
        return *found;
    }

private:
    // Visits the fillings that fit until one is refused; the present one comes before the
    // first that has at least as many singularities.
    template <class Visit> void each(const Visit &visit) {
        auto visit_one = [&](const Site::Offer &offer) {
            Shape shape = offer.build();
            return !site_.fits(shape.filling) || visit(std::move(shape));
        };
        bool present_left = present_.has_value();
        for (const Site::Source &source : site_.sources()) {
            tried_here_ = 0;
            for (Site::Group group = source(); !group.empty(); group = source())
                for (const Site::Offer &offer : group) {
                    if (present_ && offer.singularities >= present_->singularities) {
                        if (goal_.keep_quality)
                            continue;
                        if (std::exchange(present_left, false) && !visit_one(*present_))
                            return;
                    }
                    if (!visit_one(offer))
                        return;
                }
        }
        if (present_left)
            visit_one(*present_);
    }

    // Whether the search is over. Fillings with other numbers than the first are tried only if none
    // with the same is valid, or, where the old quality is to be kept, good enough.
    bool try_one(Shape shape) {
        const fill::Filling &filling = shape.filling;
        auto valences = site_.valences(filling);
        const auto faces = static_cast<std::int64_t>(filling.quads.size());
        const std::int64_t singular_now = singular(valences);
        if (first_faces_ < 0) {
            first_faces_ = faces;
            first_singular_ = singular_now;
        }
        const bool as_predicted = faces == first_faces_ && singular_now == first_singular_;
        if (faces != first_faces_ && !goal_.any_count)
            return false; // the predicted count is kept, come what may
        if (best_.number >= 0 && !as_predicted && !goal_.keep_quality)
            return true;
        if (tried_here_ >= settings_.candidates && !(present_ && filling.quads == site_.old.quads))
            return false;
        later_ += as_predicted ? 0 : 1;
        ++tried_;
        ++tried_here_;
        return judge(std::move(shape), std::move(valences), as_predicted ? 0 : later_);
    }

    // Whether the filling is good enough to end the search.
    bool judge(Shape shape, std::map<int, std::int64_t> valences, std::int64_t number) {
        geometry::Embedding embedding = site_.embed(shape);
        const double quality = embedding.min_scaled_jacobian;
        if (!embedding.valid || quality <= settings_.min_quality)
            return false;
        if (best_.number < 0 || quality > best_.embedding.min_scaled_jacobian)
            best_ = {std::move(shape.filling), std::move(embedding), std::move(valences), number};
        return quality >= (goal_.keep_quality ? site_.old_quality : std::min(site_.old_quality, comfortable));
    }

    const Site &site_;
    const Goal &goal_;
    const Settings &settings_;
    const std::optional<Site::Offer> present_;
    Best best_;
    std::int64_t first_faces_ = -1, first_singular_ = -1, later_ = 0, tried_ = 0, tried_here_ = 0;
};

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
        Best best = Choice(site, goal, settings).run();
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
        return Choice(site, goal, settings).first();
    } catch (const Refusal &refusal) {
        throw Failure(refusal.fault, refusal.text);
    }
}

mesh::QuadMesh::Replaced commit(mesh::QuadMesh &mesh, const Proposal &proposal) {
    return mesh.replace_disk(proposal.window.faces, proposal.window.loop, proposal.filling.quads, proposal.points);
}

} // namespace alphamst::adapt
