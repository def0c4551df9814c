#include "reference/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "index.h"
#include "random.h"
#include "reference/locate.h"
#include "surface/boxes.h"

namespace alphamst::reference {
namespace {

namespace spatial_index = surface::spatial_index;

// Some of n things, in order, spread without regard to their order.
std::vector<int> choose(std::size_t n, std::size_t most) {
    std::vector<int> all(n);
    std::iota(all.begin(), all.end(), 0);
    if (n > most) {
        Random(n).shuffle_front(all, most);
        all.resize(most);
        std::sort(all.begin(), all.end());
    }
    return all;
}

} // namespace

SurfaceDistance::SurfaceDistance(const surface::Surface &surface, const mesh::QuadMesh &mesh,
                                 std::size_t most, double tolerance)
    : tolerance_(tolerance) {
    samples_.resize(at(mesh.n_faces()));
    std::vector<int> all(at(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    const FaceTree faces(mesh, std::move(all));
    for (const int p : choose(surface.points().size(), most)) {
        const FaceTree::Place place = faces.nearest(surface.points()[at(p)]);
        samples_[at(place.face)].push_back(static_cast<int>(points_.size()));
        points_.push_back(surface.points()[at(p)]);
        distance_.push_back(static_cast<float>(std::sqrt(place.spot.distance)));
    }
}

SurfaceDistance::Owner SurfaceDistance::owner_of(int sample, std::span<const geometry::Quad> quads,
                                                 const surface::BoxTree &tree) const {
    std::pair nearest(std::numeric_limits<double>::infinity(), -1);
    const auto holds = spatial_index::intersects(surface::box_corner(point(sample)));
    for (auto e = tree.qbegin(holds); e != tree.qend(); ++e)
        nearest = std::min(
            nearest, {geometry::closest_point(quads[at(e->second)], point(sample)).distance, e->second});
    return {sample, nearest.second, static_cast<float>(std::sqrt(nearest.first))};
}

surface::BoxTree SurfaceDistance::boxes(std::span<const int> faces, std::span<const geometry::Quad> quads,
                                        double part) const {
    double reach = tolerance_;
    for (const int f : faces)
        for (const int s : samples(f))
            reach = std::max(reach, allowed(s));
    std::vector<surface::BoxEntry> entries;
    for (std::size_t q = 0; q < quads.size(); ++q)
        entries.emplace_back(surface::box_of(quads[q], part * reach), static_cast<int>(q));
    return surface::BoxTree(entries);
}

bool SurfaceDistance::covers(std::span<const int> faces, std::span<const geometry::Quad> quads,
                             double part) const {
    const surface::BoxTree tree = boxes(faces, quads, part);
    std::size_t last = 0; // the quad that covered the sample before
    for (const int f : faces)
        for (const int s : samples(f)) {
            const double most = part * allowed(s) * part * allowed(s);
            const auto near = [&](std::size_t q) {
                return geometry::closest_point(quads[q], point(s)).distance <= most;
            };
            if (near(last))
                continue;
            const auto holds = spatial_index::intersects(surface::box_corner(point(s)));
            const auto found = std::find_if(tree.qbegin(holds), tree.qend(),
                                            [&](const auto &entry) { return near(at(entry.second)); });
            if (found == tree.qend())
                return false;
            last = at(found->second);
        }
    return true;
}

// Of some of the faces.
struct SurfaceDistance::Found {
    std::vector<Owner> owners;
    std::vector<int> missed;
};

std::optional<std::vector<SurfaceDistance::Owner>>
SurfaceDistance::cover(std::span<const int> faces, std::span<const geometry::Quad> quads,
                       std::vector<int> *missed, const geometry::Run &run) const {
    const surface::BoxTree tree = boxes(faces, quads, 1);
    const std::size_t piece = run ? 256 : faces.size(); // faces
    std::vector<Found> found(run ? (faces.size() + piece - 1) / piece : 1);
    const auto look = [&](std::size_t i) {
        for (const int f : faces.subspan(i * piece, std::min(piece, faces.size() - i * piece)))
            for (const int s : samples(f)) {
                const Owner owner = owner_of(s, quads, tree);
                if (static_cast<double>(owner.distance) <= allowed(s)) {
                    found[i].owners.push_back(owner);
                } else {
                    found[i].missed.push_back(f);
                    if (missed == nullptr)
                        return;
                    break;
                }
            }
    };
    if (run)
        run(found.size(), look);
    else
        look(0);
    std::vector<Owner> owners;
    for (const Found &part : found) {
        if (missed == nullptr && !part.missed.empty())
            return std::nullopt;
        owners.insert(owners.end(), part.owners.begin(), part.owners.end());
        if (missed != nullptr)
            missed->insert(missed->end(), part.missed.begin(), part.missed.end());
    }
    return owners;
}

SurfaceDistance surface_distance_of(const mesh::QuadMesh &mesh, const surface::Surface &surface,
                                    std::int64_t wanted, double edges) {
    constexpr std::size_t samples = 5; // for each wanted face
    const double edge = std::sqrt(surface.area() / static_cast<double>(std::max<std::int64_t>(1, wanted)));
    return SurfaceDistance(surface, mesh, samples * static_cast<std::size_t>(wanted), edges * edge);
}

double SurfaceDistance::largest() const {
    return distance_.empty() ? 0 : static_cast<double>(*std::max_element(distance_.begin(), distance_.end()));
}

void SurfaceDistance::assign(std::span<const int> faces, std::span<const Owner> owners,
                             std::span<const int> of_quad) {
    for (const int f : faces)
        samples_[at(f)].clear();
    for (const Owner &owner : owners) {
        samples_[at(of_quad[at(owner.quad)])].push_back(owner.sample);
        distance_[at(owner.sample)] = owner.distance;
    }
}

} // namespace alphamst::reference
