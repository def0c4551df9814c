#include "refill/trial.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "patch/region.h"
#include "reference/feature_line.h"
#include "reference/locate.h"
#include "refill/cavity.h"
#include "refill/obstacle.h"
#include "smooth/align.h"
#include "smooth/shaping.h"

namespace alphamst::refill {
namespace {

ShapeBounds shape_of(const geometry::Judgement &quads) {
    return {quads.min_scaled_jacobian, quads.min_shape, static_cast<double>(quads.poor), quads.inverted};
}

ShapeBounds both(const ShapeBounds &a, const ShapeBounds &b) {
    return {std::min(a.scaled_jacobian, b.scaled_jacobian), std::min(a.shape, b.shape), a.poor + b.poor,
            a.inverted + b.inverted};
}

bool reaches(const ShapeBounds &reached, const ShapeBounds &wanted) {
    return reached.scaled_jacobian >= wanted.scaled_jacobian && reached.shape >= wanted.shape &&
           reached.poor <= wanted.poor && reached.inverted <= wanted.inverted;
}

// What moving the buffer has hardly ever mended (8 of 1,300 tries on two meshes).
constexpr double least_gain = 0.05; // of the scaled Jacobian
constexpr double hopeless_poor = 20, hopeless_shape = 0.4;
// Part of the tolerance by which the surface is missed before vertices move, where it hardly ever is not
// missed afterwards (4 of 4,255 tries).
constexpr double hopeless_distance = 1.25;
// Degrees: what a window that turns gains at least. Fillings that are compared for that.
constexpr double least_turn = 2, right_angle = 90;
constexpr int most_compared = 4;

// The faces around the window, with a filling in their middle.
class BufferRing {
public:
    BufferRing(const mesh::QuadMesh &mesh, const Cavity &cavity, const std::vector<int> &faces)
        : cavity_(cavity), faces_(faces) {
        for (std::size_t i = 0; i < cavity.window.loop.size(); ++i)
            number_.emplace(cavity.window.loop[i], static_cast<int>(i));
        vertices_ = cavity.window.loop;
        std::vector<int> found(vertices_.size(), 0); // faces of the buffer at each vertex
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
            const int inside = i < cavity.window.loop.size() ? cavity.window.inside[i] : 0;
            fixed_.push_back(found[i] + inside != mesh.valence(v) || patch::constrained(mesh, v));
        }
        if (cavity.curved()) {
            on_surface_ = cavity.on_surface(vertices_);
            if (mesh.curves) {
                geometry::SurfacePositions judged = on_surface_;
                reference::forget_normals(mesh, vertices_, quads_, judged);
                normals_ = std::move(judged.normals);
            }
        } else {
            flat_ = cavity.flat(vertices_);
        }
        if (!quads_.empty())
            shape_ = shape_of(cavity.curved() ? geometry::judge(quads_, on_surface_)
                                              : geometry::judge(quads_, flat_));
    }

    const ShapeBounds &shape() const { return shape_; }
    const std::vector<int> &faces() const { return faces_; }

    // Filling and buffer; with the buffer where it is if laid knows no places for it.
    std::vector<geometry::Quad> quads(const fill::Filling &filling, const CavityEmbedding &laid) const {
        const std::vector<Eigen::Vector3d> &points = laid.on_surface.points;
        const auto n = static_cast<std::size_t>(filling.vertices);
        const auto loop = static_cast<std::size_t>(filling.boundary);
        const auto inside = [&](std::size_t v) { return points[v]; };
        const auto around = [&](std::size_t v) {
            return v < loop ? points[v] : points.size() > n ? points[v + n - loop] : on_surface_.points[v];
        };
        std::vector<geometry::Quad> all;
        const auto add = [&](const std::array<int, 4> &quad, const auto &place) {
            geometry::Quad &corners = all.emplace_back();
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
    // buffer, which lies across features, too; with the buffer where it is if the on_surface knows no places
    // for it. Only for meshes with features.
    int turned(const fill::Filling &filling, geometry::SurfacePositions on_surface) const {
        const auto n = static_cast<std::size_t>(filling.vertices);
        if (on_surface.points.size() == n) {
            append(on_surface_.points, filling.boundary, on_surface.points);
            append(on_surface_.surface_triangles, filling.boundary, on_surface.surface_triangles);
        }
        on_surface.normals.resize(n);
        std::copy_n(normals_.begin(), filling.boundary, on_surface.normals.begin());
        append(normals_, filling.boundary, on_surface.normals);
        return geometry::judge(join(filling), on_surface).inverted;
    }

    // Lets the vertices of filling and buffer move together. Places are those of the filling, then
    // of the buffer's own vertices.
    CavityEmbedding improve(const fill::Filling &filling, CavityEmbedding laid,
                            geometry::EmbedOptions options) const {
        const int loop = filling.boundary;
        const std::vector<std::array<int, 4>> quads = join(filling);
        std::vector<char> fixed(fixed_.begin(), fixed_.begin() + loop);
        fixed.resize(static_cast<std::size_t>(filling.vertices), 0);
        fixed.insert(fixed.end(), fixed_.begin() + loop, fixed_.end());
        if (cavity_.curved()) {
            append(on_surface_.points, loop, laid.on_surface.points);
            append(on_surface_.normals, loop, laid.on_surface.normals);
            append(on_surface_.surface_triangles, loop, laid.on_surface.surface_triangles);
            const std::vector<double> areas = cavity_.reference().areas(quads, laid.on_surface);
            options.area = areas;
            static_cast<geometry::Judgement &>(laid) =
                geometry::improve(cavity_.surface(), quads, fixed, laid.on_surface, options);
        } else {
            append(flat_, loop, laid.flat);
            geometry::Embedding embedding = geometry::improve(quads, fixed, std::move(laid.flat), options);
            static_cast<geometry::Judgement &>(laid) = embedding;
            laid.flat = std::move(embedding.positions);
        }
        return laid;
    }

    // The vertices of the mesh that the places of the whole move.
    void collect(const fill::Filling &filling, const CavityEmbedding &laid, Trial &trial) const {
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            if (fixed_[i])
                continue;
            const std::size_t at = i < static_cast<std::size_t>(filling.boundary)
                                       ? i
                                       : i + static_cast<std::size_t>(filling.vertices - filling.boundary);
            if (cavity_.curved()) {
                const Eigen::Vector3d &p = laid.on_surface.points[at];
                trial.moved.emplace_back(vertices_[i], OpenMesh::Vec3d(p.x(), p.y(), p.z()));
                trial.moved_surface_triangles.push_back(laid.on_surface.surface_triangles[at]);
            } else {
                trial.moved.emplace_back(vertices_[i], cavity_.lift(laid.flat[at]));
            }
        }
    }

private:
    template <class Values> static void append(const Values &from, int start, Values &to) {
        to.insert(to.end(), from.begin() + start, from.end());
    }

    // Quads of the filling and then of the buffer, whose own vertices come after those of the filling.
    std::vector<std::array<int, 4>> join(const fill::Filling &filling) const {
        std::vector<std::array<int, 4>> quads = filling.quads;
        for (std::array<int, 4> quad : quads_) {
            for (int &v : quad)
                v += v >= filling.boundary ? filling.vertices - filling.boundary : 0;
            quads.push_back(quad);
        }
        return quads;
    }

    const Cavity &cavity_;
    const std::vector<int> &faces_;
    std::unordered_map<int, int> number_;
    std::vector<int> vertices_; // of the mesh: the loop, then others
    std::vector<std::array<int, 4>> quads_;
    std::vector<char> fixed_;
    geometry::Points flat_;
    geometry::SurfacePositions on_surface_;
    std::vector<Eigen::Vector3d> normals_; // of on_surface_, but none on features
    ShapeBounds shape_;
};

// Vertices of the window as its filling numbers them.
std::vector<int> all_of(const patch::Window &window) {
    std::vector<int> vertices = window.loop;
    vertices.insert(vertices.end(), window.interior.begin(), window.interior.end());
    return vertices;
}

std::vector<geometry::Quad> quads_of(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
    std::vector<geometry::Quad> quads;
    for (const int f : faces)
        quads.push_back(reference::quad_of(mesh, f));
    return quads;
}

// Whether filling and buffer stay near the surface, and the surface near them.
bool stays_near(const Cavity &cavity, const BufferRing &buffer, const fill::Filling &filling,
                const CavityEmbedding &laid, const reference::SurfaceDistance &surface_distance,
                bool buffer_moved, Trial &trial) {
    const std::vector<geometry::Quad> quads = buffer.quads(filling, laid);
    for (std::size_t q = 0; q < filling.quads.size(); ++q) {
        const geometry::Quad &c = quads[q];
        const int surface_triangle =
            laid.on_surface.surface_triangles[static_cast<std::size_t>(filling.quads[q][0])];
        if (cavity.surface().follow((c[0] + c[1] + c[2] + c[3]) / 4, surface_triangle).distance >
            surface_distance.tolerance())
            return false;
    }
    std::vector<int> faces = cavity.window.faces;
    if (buffer_moved)
        faces.insert(faces.end(), buffer.faces().begin(), buffer.faces().end());
    auto owners = surface_distance.cover(faces, quads);
    if (owners)
        trial.owners = std::move(*owners);
    return owners.has_value();
}

// Forgets the places of the buffer.
void cut(CavityEmbedding &laid, const fill::Filling &filling) {
    const auto n = static_cast<std::size_t>(filling.vertices);
    laid.flat.resize(std::min(laid.flat.size(), n));
    laid.on_surface.points.resize(std::min(laid.on_surface.points.size(), n));
    laid.on_surface.surface_triangles.resize(std::min(laid.on_surface.surface_triangles.size(), n));
}

// Quads that may be inverted, see BufferRing::turned, where the buffer stays as it is and where it moves,
// too.
struct Turned {
    int alone, with_buffer;
};

// most_turned: nothing where there are no features.
std::optional<Trial> judge(const Cavity &cavity, const BufferRing &buffer, const PlacedFilling &shape,
                           const ShapeBounds &wanted, const std::optional<Turned> &most_turned,
                           const Settings &settings,
                           const std::optional<reference::SurfaceDistance> &surface_distance,
                           Obstacles &obstacles) {
    const fill::Filling &filling = shape.filling;
    CavityEmbedding laid;
    if (cavity.curved()) {
        laid = cavity.place(shape);
        if (surface_distance && !laid.on_surface.points.empty() &&
            !surface_distance->covers(cavity.window.faces, buffer.quads(filling, laid), hopeless_distance))
            return std::nullopt;
        laid = cavity.smooth(filling, std::move(laid));
    } else {
        laid = cavity.lay(shape);
    }
    if (laid.stuck >= 0)
        obstacles.learn(filling, laid.stuck);
    // In space the faces around may be what keeps a corner inverted.
    if (!laid.valid && laid.on_surface.points.empty())
        return std::nullopt;
    Trial trial;
    const ShapeBounds first = both(shape_of(laid), buffer.shape());
    if (!reaches(first, wanted)) {
        if (first.poor > wanted.poor + hopeless_poor ||
            (laid.valid && first.shape < hopeless_shape * wanted.shape))
            return std::nullopt;
        laid = buffer.improve(filling, std::move(laid), smooth::shaping(settings));
        if (!reaches(shape_of(laid), wanted))
            return std::nullopt;
        buffer.collect(filling, laid, trial);
    }
    // Where the buffer moves as well, quads that stay inverted have come nearer to being mended.
    if (most_turned && buffer.turned(filling, laid.on_surface) >
                           (trial.moved.empty() ? most_turned->alone : most_turned->with_buffer))
        return std::nullopt;
    if (surface_distance &&
        !stays_near(cavity, buffer, filling, laid, *surface_distance, !trial.moved.empty(), trial))
        return std::nullopt;
    if (const reference::CrossField *cross_field = cavity.reference().cross_field) {
        const std::vector<geometry::Quad> quads = buffer.quads(filling, laid);
        trial.alignment_error = cross_field->alignment_error(std::span(quads).first(filling.quads.size()));
    }
    cut(laid, filling);
    trial.proposal.window = cavity.window;
    trial.proposal.points = cavity.lift(laid);
    if (cavity.curved())
        trial.surface_triangles.assign(laid.on_surface.surface_triangles.begin() + filling.boundary,
                                       laid.on_surface.surface_triangles.end());
    trial.proposal.filling = filling;
    return trial;
}

} // namespace

std::optional<Trial> attempt(const mesh::QuadMesh &mesh, const Place &place, const Goal &goal,
                             const ShapeBounds &wanted, const Settings &settings,
                             const reference::Reference &reference) {
    try {
        Patch region;
        region.faces = place.faces;
        const Cavity cavity(mesh, region, goal, settings, reference);
        const BufferRing buffer(mesh, cavity, place.buffer);
        const ShapeBounds before = both(shape_of(cavity.old_shape), buffer.shape());
        // Where the old filling is no answer, it is to be bettered.
        const double gain = goal.forbid_old ? least_gain : 0;
        ShapeBounds least = {std::min(wanted.scaled_jacobian, before.scaled_jacobian + gain),
                             std::min(wanted.shape, before.shape), 0, before.inverted};
        const reference::CrossField *cross_field = reference.cross_field;
        double alignment_error = cross_field != nullptr && goal.turn
                                     ? cross_field->alignment_error(quads_of(mesh, place.faces)) - least_turn
                                     : right_angle;
        std::optional<Trial> best;
        std::optional<Turned> most_turned;
        int turned = 0;
        if (mesh.curves && cavity.curved()) {
            turned = buffer.turned(cavity.old, cavity.on_surface(all_of(cavity.window)));
            most_turned = {goal.forbid_old ? std::max(0, turned - 1) : turned, turned};
        }
        Obstacles obstacles;
        int tried = 0, among = 0;
        for (const Cavity::Generator &generator : cavity.generators())
            for (Cavity::Group group = generator(); !group.empty(); group = generator())
                for (const Cavity::Candidate &candidate : group) {
                    const PlacedFilling shape = candidate.build();
                    const auto faces = static_cast<std::int64_t>(shape.filling.quads.size());
                    const int change = cavity.singular_all(shape.filling) - cavity.old_singular_all;
                    if (best && change > best->singular_change)
                        return best;
                    if (change > goal.most_added || (!goal.any_count && faces != goal.faces) ||
                        !cavity.fits(shape.filling) || obstacles.met_by(shape.filling))
                        continue;
                    // To be rid of an inverted quad is worth as much as to be rid of a singularity.
                    const int gain = std::max(0, -change) + std::max(before.inverted, turned);
                    least.poor = before.poor + gain * wanted.poor;
                    if (auto trial = judge(cavity, buffer, shape, least, most_turned, settings,
                                           reference.surface_distance, obstacles)) {
                        trial->singular_change = change;
                        if (cross_field == nullptr)
                            return trial;
                        if (trial->alignment_error < alignment_error) {
                            alignment_error = trial->alignment_error;
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

} // namespace alphamst::refill
