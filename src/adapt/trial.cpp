#include "adapt/trial.h"

#include <algorithm>
#include <unordered_map>

#include "adapt/obstacle.h"
#include "adapt/site.h"
#include "patch/region.h"

namespace alphamst::adapt {
namespace {

Shapeliness shape_of(const geometry::Embedding &embedding) {
    return {embedding.min_scaled_jacobian, embedding.min_shape, static_cast<double>(embedding.poor)};
}

Shapeliness both(const Shapeliness &a, const Shapeliness &b) {
    return {std::min(a.scaled_jacobian, b.scaled_jacobian), std::min(a.shape, b.shape), a.poor + b.poor};
}

bool reaches(const Shapeliness &reached, const Shapeliness &wanted) {
    return reached.scaled_jacobian >= wanted.scaled_jacobian && reached.shape >= wanted.shape &&
           reached.poor <= wanted.poor;
}

// What moving the rim has hardly ever mended (8 of 1,300 tries on two meshes).
constexpr double hopeless_poor = 20, hopeless_shape = 0.4;

// The faces around the window, in its plane, with a filling in their middle.
class Rim {
public:
    Rim(const mesh::QuadMesh &mesh, const Site &site, const std::vector<int> &faces) : site_(site) {
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
        positions_ = site.flat(vertices_);
        if (!quads_.empty())
            shape_ = shape_of(geometry::judge(quads_, positions_));
    }

    const Shapeliness &shape() const { return shape_; }

    // Lets the vertices of filling and rim move together. Positions are those of the filling, then
    // of the rim's own vertices.
    geometry::Embedding improve(const fill::Filling &filling, const geometry::Points &positions,
                                const geometry::EmbedOptions &options) const {
        const int loop = filling.boundary, fresh = filling.vertices - loop;
        std::vector<std::array<int, 4>> quads = filling.quads;
        for (std::array<int, 4> quad : quads_) {
            for (int &v : quad)
                v += v >= loop ? fresh : 0;
            quads.push_back(quad);
        }
        geometry::Points all = positions;
        all.insert(all.end(), positions_.begin() + loop, positions_.end());
        std::vector<char> fixed(fixed_.begin(), fixed_.begin() + loop);
        fixed.resize(static_cast<std::size_t>(filling.vertices), 0);
        fixed.insert(fixed.end(), fixed_.begin() + loop, fixed_.end());
        return geometry::improve(quads, fixed, std::move(all), options);
    }

    // The vertices of the mesh that an embedding of the whole moves.
    void collect(const fill::Filling &filling, const geometry::Points &positions,
                 std::vector<std::pair<int, OpenMesh::Vec3d>> &moved) const {
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            if (fixed_[i])
                continue;
            const std::size_t at = i < static_cast<std::size_t>(filling.boundary)
                                       ? i
                                       : i + static_cast<std::size_t>(filling.vertices - filling.boundary);
            moved.emplace_back(vertices_[i], site_.lift(positions[at]));
        }
    }

private:
    const Site &site_;
    std::unordered_map<int, int> number_;
    std::vector<int> vertices_; // of the mesh: the loop, then others
    std::vector<std::array<int, 4>> quads_;
    std::vector<char> fixed_;
    geometry::Points positions_;
    Shapeliness shape_;
};

std::optional<Trial> judge(const Site &site, const Rim &rim, const Shape &shape, const Shapeliness &wanted,
                           const Settings &settings, Obstacles &obstacles) {
    geometry::Embedding embedding = site.embed(shape);
    const fill::Filling &filling = shape.filling;
    if (embedding.stuck >= 0)
        obstacles.learn(filling, embedding.stuck);
    if (!embedding.valid)
        return std::nullopt;
    Trial trial;
    const Shapeliness first = both(shape_of(embedding), rim.shape());
    if (!reaches(first, wanted)) {
        if (first.poor > wanted.poor + hopeless_poor || first.shape < hopeless_shape * wanted.shape)
            return std::nullopt;
        geometry::EmbedOptions options;
        options.steps = settings.smooth_steps;
        options.least_area = settings.least_area;
        embedding = rim.improve(filling, embedding.positions, options);
        if (!reaches(shape_of(embedding), wanted))
            return std::nullopt;
        rim.collect(filling, embedding.positions, trial.moved);
        embedding.positions.resize(static_cast<std::size_t>(filling.vertices));
    }
    trial.proposal.window = site.window;
    trial.proposal.points = site.lift(embedding.positions);
    trial.proposal.filling = filling;
    return trial;
}

} // namespace

std::optional<Trial> attempt(const mesh::QuadMesh &mesh, const Place &place, const Goal &goal,
                             const Shapeliness &wanted, const Settings &settings) {
    try {
        Region region;
        region.faces = place.faces;
        const Site site(mesh, region, goal, settings);
        const Rim rim(mesh, site, place.rim);
        const Shapeliness before = both(shape_of(site.old_embedding), rim.shape());
        Shapeliness least = {std::min(wanted.scaled_jacobian, before.scaled_jacobian),
                             std::min(wanted.shape, before.shape), 0};
        Obstacles obstacles;
        int tried = 0;
        for (const Site::Source &source : site.sources())
            for (Site::Group group = source(); !group.empty(); group = source())
                for (const Site::Offer &offer : group) {
                    const Shape shape = offer.build();
                    const auto faces = static_cast<std::int64_t>(shape.filling.quads.size());
                    const int change = site.singular_all(shape.filling) - site.old_singular_all;
                    if (change > goal.most_added || (!goal.any_count && faces != goal.faces) ||
                        !site.fits(shape.filling) || obstacles.met_by(shape.filling))
                        continue;
                    least.poor = before.poor + std::max(0.0, -change * wanted.poor);
                    if (auto trial = judge(site, rim, shape, least, settings, obstacles)) {
                        trial->singular_change = change;
                        return trial;
                    }
                    if (++tried >= settings.candidates)
                        return std::nullopt;
                }
    } catch (const Refusal &) {
    }
    return std::nullopt;
}

} // namespace alphamst::adapt
