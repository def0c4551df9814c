#include "adapt/trial.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "adapt/align.h"
#include "adapt/locate.h"
#include "adapt/obstacle.h"
#include "adapt/rails.h"
#include "adapt/shaping.h"
#include "adapt/site.h"
#include "patch/region.h"

namespace alphamst::adapt {
namespace {

Shapeliness shape_of(const geometry::Judgement &quads) {
    return {quads.min_scaled_jacobian, quads.min_shape, static_cast<double>(quads.poor), quads.inverted};
}

Shapeliness both(const Shapeliness &a, const Shapeliness &b) {
    return {std::min(a.scaled_jacobian, b.scaled_jacobian), std::min(a.shape, b.shape), a.poor + b.poor,
            a.inverted + b.inverted};
}

bool reaches(const Shapeliness &reached, const Shapeliness &wanted) {
    return reached.scaled_jacobian >= wanted.scaled_jacobian && reached.shape >= wanted.shape &&
           reached.poor <= wanted.poor && reached.inverted <= wanted.inverted;
}

// What moving the rim has hardly ever mended (8 of 1,300 tries on two meshes).
constexpr double least_gain = 0.05; // of the scaled Jacobian
constexpr double hopeless_poor = 20, hopeless_shape = 0.4;
// Part of the tolerance by which the surface is missed before vertices move, where it hardly ever is not
// missed afterwards (4 of 4,255 tries).
constexpr double hopeless_distance = 1.25;
// Degrees: what a window that turns gains at least. Fillings that are compared for that.
constexpr double least_turn = 2, right_angle = 90;
constexpr int most_compared = 4;

// The faces around the window, with a filling in their middle.
class Rim {
public:
    Rim(const mesh::QuadMesh &mesh, const Site &site, const std::vector<int> &faces)
        : site_(site), faces_(faces) {
        for (std::size_t i = 0; i < site.window.loop.size(); ++i)
            number_.emplace(site.window.loop[i], static_cast<int>(i));
        vertices_ = site.window.loop;
        std::vector<int> found(vertices_.size(), 0); // faces of the rim at each vertex
        for (const int f : faces) {
            std::array<int, 4> quad = mesh.corners(f);
            for (int &v : quad) {
                const auto [it, fresh] = number_.emplace(v, static_cast<int>(vertices_.size()));
                if (fresh) {
                    vertices_.push_back(v);
                    found.push_back(0);
                }
                v = it->second;
                ++found[static_cast<std::size_t>(v)];
            }
            quads_.push_back(quad);
        }
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const int v = vertices_[i];
            const int inside = i < site.window.loop.size() ? site.window.inside[i] : 0;
            fixed_.push_back(found[i] + inside != mesh.valence(v) || patch::pinned(mesh, v));
        }
        if (site.curved()) {
            draped_ = site.draped(vertices_);
            if (mesh.curves) {
                geometry::Drape judged = draped_;
                forget_normals(mesh, vertices_, quads_, judged);
                normals_ = std::move(judged.normals);
            }
        } else {
            flat_ = site.flat(vertices_);
        }
        if (!quads_.empty())
            shape_ =
                shape_of(site.curved() ? geometry::judge(quads_, draped_) : geometry::judge(quads_, flat_));
    }

    const Shapeliness &shape() const { return shape_; }
    const std::vector<int> &faces() const { return faces_; }

    // Filling and rim; with the rim where it is if laid knows no places for it.
    std::vector<Quad> quads(const fill::Filling &filling, const Laid &laid) const {
        const std::vector<Eigen::Vector3d> &points = laid.draped.points;
        const auto n = static_cast<std::size_t>(filling.vertices);
        const auto loop = static_cast<std::size_t>(filling.boundary);
        const auto inside = [&](std::size_t v) { return points[v]; };
        const auto around = [&](std::size_t v) {
            return v < loop ? points[v] : points.size() > n ? points[v + n - loop] : draped_.points[v];
        };
        std::vector<Quad> all;
        const auto add = [&](const std::array<int, 4> &quad, const auto &place) {
            Quad &corners = all.emplace_back();
            for (std::size_t k = 0; k < 4; ++k)
                corners[k] = place(static_cast<std::size_t>(quad[k]));
        };
        for (const auto &quad : filling.quads)
            add(quad, inside);
        for (const auto &quad : quads_)
            add(quad, around);
        return all;
    }

    // Quads with a corner that is not positive against the quads around it, those of the filling and of the
    // rim, which lies across features, too; with the rim where it is if the drape knows no places for it.
    // Only for meshes with features.
    int turned(const fill::Filling &filling, geometry::Drape drape) const {
        const auto n = static_cast<std::size_t>(filling.vertices);
        if (drape.points.size() == n) {
            append(draped_.points, filling.boundary, drape.points);
            append(draped_.anchors, filling.boundary, drape.anchors);
        }
        drape.normals.resize(n);
        std::copy_n(normals_.begin(), filling.boundary, drape.normals.begin());
        append(normals_, filling.boundary, drape.normals);
        return geometry::judge(join(filling), drape).inverted;
    }

    // Lets the vertices of filling and rim move together. Places are those of the filling, then
    // of the rim's own vertices.
    Laid improve(const fill::Filling &filling, Laid laid, geometry::EmbedOptions options) const {
        const int loop = filling.boundary;
        const std::vector<std::array<int, 4>> quads = join(filling);
        std::vector<char> fixed(fixed_.begin(), fixed_.begin() + loop);
        fixed.resize(static_cast<std::size_t>(filling.vertices), 0);
        fixed.insert(fixed.end(), fixed_.begin() + loop, fixed_.end());
        if (site_.curved()) {
            append(draped_.points, loop, laid.draped.points);
            append(draped_.normals, loop, laid.draped.normals);
            append(draped_.anchors, loop, laid.draped.anchors);
            const std::vector<double> areas = site_.ground().areas(quads, laid.draped);
            options.area = areas;
            static_cast<geometry::Judgement &>(laid) =
                geometry::improve(site_.surface(), quads, fixed, laid.draped, options);
        } else {
            append(flat_, loop, laid.flat);
            geometry::Embedding embedding = geometry::improve(quads, fixed, std::move(laid.flat), options);
            static_cast<geometry::Judgement &>(laid) = embedding;
            laid.flat = std::move(embedding.positions);
        }
        return laid;
    }

    // The vertices of the mesh that the places of the whole move.
    void collect(const fill::Filling &filling, const Laid &laid, Trial &trial) const {
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            if (fixed_[i])
                continue;
            const std::size_t at = i < static_cast<std::size_t>(filling.boundary)
                                       ? i
                                       : i + static_cast<std::size_t>(filling.vertices - filling.boundary);
            if (site_.curved()) {
                const Eigen::Vector3d &p = laid.draped.points[at];
                trial.moved.emplace_back(vertices_[i], OpenMesh::Vec3d(p.x(), p.y(), p.z()));
                trial.moved_anchors.push_back(laid.draped.anchors[at]);
            } else {
                trial.moved.emplace_back(vertices_[i], site_.lift(laid.flat[at]));
            }
        }
    }

private:
    template <class Values> static void append(const Values &from, int start, Values &to) {
        to.insert(to.end(), from.begin() + start, from.end());
    }

    // Quads of the filling and then of the rim, whose own vertices come after those of the filling.
    std::vector<std::array<int, 4>> join(const fill::Filling &filling) const {
        std::vector<std::array<int, 4>> quads = filling.quads;
        for (std::array<int, 4> quad : quads_) {
            for (int &v : quad)
                v += v >= filling.boundary ? filling.vertices - filling.boundary : 0;
            quads.push_back(quad);
        }
        return quads;
    }

    const Site &site_;
    const std::vector<int> &faces_;
    std::unordered_map<int, int> number_;
    std::vector<int> vertices_; // of the mesh: the loop, then others
    std::vector<std::array<int, 4>> quads_;
    std::vector<char> fixed_;
    geometry::Points flat_;
    geometry::Drape draped_;
    std::vector<Eigen::Vector3d> normals_; // of draped_, but none on features
    Shapeliness shape_;
};

// Vertices of the window as its filling numbers them.
std::vector<int> all_of(const patch::Window &window) {
    std::vector<int> vertices = window.loop;
    vertices.insert(vertices.end(), window.interior.begin(), window.interior.end());
    return vertices;
}

std::vector<Quad> quads_of(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
    std::vector<Quad> quads;
    for (const int f : faces)
        quads.push_back(quad_of(mesh, f));
    return quads;
}

// Whether filling and rim stay near the surface, and the surface near them.
bool stays_near(const Site &site, const Rim &rim, const fill::Filling &filling, const Laid &laid,
                const Coverage &coverage, bool rim_moved, Trial &trial) {
    const std::vector<Quad> quads = rim.quads(filling, laid);
    for (std::size_t q = 0; q < filling.quads.size(); ++q) {
        const Quad &c = quads[q];
        const int anchor = laid.draped.anchors[static_cast<std::size_t>(filling.quads[q][0])];
        if (site.surface().follow((c[0] + c[1] + c[2] + c[3]) / 4, anchor).distance > coverage.tolerance())
            return false;
    }
    std::vector<int> faces = site.window.faces;
    if (rim_moved)
        faces.insert(faces.end(), rim.faces().begin(), rim.faces().end());
    auto owners = coverage.cover(faces, quads);
    if (owners)
        trial.owners = std::move(*owners);
    return owners.has_value();
}

// Forgets the places of the rim.
void cut(Laid &laid, const fill::Filling &filling) {
    const auto n = static_cast<std::size_t>(filling.vertices);
    laid.flat.resize(std::min(laid.flat.size(), n));
    laid.draped.points.resize(std::min(laid.draped.points.size(), n));
    laid.draped.anchors.resize(std::min(laid.draped.anchors.size(), n));
}

// Quads that may be turned over, see Rim::turned, where the rim stays as it is and where it moves, too.
struct Turned {
    int alone, with_rim;
};

// most_turned: nothing where there are no features.
std::optional<Trial> judge(const Site &site, const Rim &rim, const Shape &shape, const Shapeliness &wanted,
                           const std::optional<Turned> &most_turned, const Settings &settings,
                           const std::optional<Coverage> &coverage, Obstacles &obstacles) {
    const fill::Filling &filling = shape.filling;
    Laid laid;
    if (site.curved()) {
        laid = site.place(shape);
        if (coverage && !laid.draped.points.empty() &&
            !coverage->covers(site.window.faces, rim.quads(filling, laid), hopeless_distance))
            return std::nullopt;
        laid = site.smooth(filling, std::move(laid));
    } else {
        laid = site.lay(shape);
    }
    if (laid.stuck >= 0)
        obstacles.learn(filling, laid.stuck);
    // In space the faces around may be what keeps a corner turned over.
    if (!laid.valid && laid.draped.points.empty())
        return std::nullopt;
    Trial trial;
    const Shapeliness first = both(shape_of(laid), rim.shape());
    if (!reaches(first, wanted)) {
        if (first.poor > wanted.poor + hopeless_poor ||
            (laid.valid && first.shape < hopeless_shape * wanted.shape))
            return std::nullopt;
        laid = rim.improve(filling, std::move(laid), shaping(settings));
        if (!reaches(shape_of(laid), wanted))
            return std::nullopt;
        rim.collect(filling, laid, trial);
    }
    // Where the rim moves as well, quads that stay turned over have come nearer to being mended.
    if (most_turned &&
        rim.turned(filling, laid.draped) > (trial.moved.empty() ? most_turned->alone : most_turned->with_rim))
        return std::nullopt;
    if (coverage && !stays_near(site, rim, filling, laid, *coverage, !trial.moved.empty(), trial))
        return std::nullopt;
    if (const Crosses *crosses = site.ground().crosses) {
        const std::vector<Quad> quads = rim.quads(filling, laid);
        trial.straying = crosses->straying(std::span(quads).first(filling.quads.size()));
    }
    cut(laid, filling);
    trial.proposal.window = site.window;
    trial.proposal.points = site.lift(laid);
    if (site.curved())
        trial.anchors.assign(laid.draped.anchors.begin() + filling.boundary, laid.draped.anchors.end());
    trial.proposal.filling = filling;
    return trial;
}

} // namespace

std::optional<Trial> attempt(const mesh::QuadMesh &mesh, const Place &place, const Goal &goal,
                             const Shapeliness &wanted, const Settings &settings, const Ground &ground) {
    try {
        Region region;
        region.faces = place.faces;
        const Site site(mesh, region, goal, settings, ground);
        const Rim rim(mesh, site, place.rim);
        const Shapeliness before = both(shape_of(site.old_shape), rim.shape());
        // Where the old filling is no answer, it is to be bettered.
        const double gain = goal.forbid_old ? least_gain : 0;
        Shapeliness least = {std::min(wanted.scaled_jacobian, before.scaled_jacobian + gain),
                             std::min(wanted.shape, before.shape), 0, before.inverted};
        const Crosses *crosses = ground.crosses;
        double straying = crosses != nullptr && goal.turn
                              ? crosses->straying(quads_of(mesh, place.faces)) - least_turn
                              : right_angle;
        std::optional<Trial> best;
        std::optional<Turned> most_turned;
        int turned = 0;
        if (mesh.curves && site.curved()) {
            turned = rim.turned(site.old, site.draped(all_of(site.window)));
            most_turned = {goal.forbid_old ? std::max(0, turned - 1) : turned, turned};
        }
        Obstacles obstacles;
        int tried = 0, among = 0;
        for (const Site::Source &source : site.sources())
            for (Site::Group group = source(); !group.empty(); group = source())
                for (const Site::Offer &offer : group) {
                    const Shape shape = offer.build();
                    const auto faces = static_cast<std::int64_t>(shape.filling.quads.size());
                    const int change = site.singular_all(shape.filling) - site.old_singular_all;
                    if (best && change > best->singular_change)
                        return best;
                    if (change > goal.most_added || (!goal.any_count && faces != goal.faces) ||
                        !site.fits(shape.filling) || obstacles.met_by(shape.filling))
                        continue;
                    // To be rid of an inverted quad is worth as much as to be rid of a singularity.
                    const int gain = std::max(0, -change) + std::max(before.inverted, turned);
                    least.poor = before.poor + gain * wanted.poor;
                    if (auto trial = judge(site, rim, shape, least, most_turned, settings, ground.coverage,
                                           obstacles)) {
                        trial->singular_change = change;
                        if (crosses == nullptr)
                            return trial;
                        if (trial->straying < straying) {
                            straying = trial->straying;
                            best = std::move(trial);
                        }
                        if (++among >= most_compared)
                            return best;
                        continue;
                    }
                    if (++tried >= settings.candidates)
                        return best;
                }
        return best;
    } catch (const Refusal &) {
    }
    return std::nullopt;
}

} // namespace alphamst::adapt
