#include "adapt/coverage.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "adapt/locate.h"
#include "fill/random.h"

namespace alphamst::adapt {
namespace {

namespace index = boost::geometry::index;
using Eigen::Vector3d;
using Point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<Point>;
using Entry = std::pair<Box, int>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Point corner(const Vector3d &p) { return {p.x(), p.y(), p.z()}; }

Box box_of(const Quad &quad, double margin) {
    const Vector3d around = Vector3d::Constant(margin);
    return {corner(quad[0].cwiseMin(quad[1]).cwiseMin(quad[2].cwiseMin(quad[3])) - around),
            corner(quad[0].cwiseMax(quad[1]).cwiseMax(quad[2].cwiseMax(quad[3])) + around)};
}

// Some of n things, in order, spread without regard to their order.
std::vector<int> choose(std::size_t n, std::size_t most) {
    std::vector<int> all(n);
    std::iota(all.begin(), all.end(), 0);
    if (n > most) {
        fill::Random random(n);
        for (std::size_t i = 0; i < most; ++i)
            std::swap(all[i], all[i + random() % (n - i)]);
        all.resize(most);
        std::sort(all.begin(), all.end());
    }
    return all;
}

} // namespace

Coverage::Coverage(const surface::Surface &surface, const mesh::QuadMesh &mesh, std::size_t most,
                   double tolerance)
    : tolerance_(tolerance) {
    samples_.resize(at(mesh.n_faces()));
    std::vector<int> all(at(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    const Faces faces(mesh, std::move(all));
    for (const int p : choose(surface.points().size(), most)) {
        const Faces::Place place = faces.nearest(surface.points()[at(p)]);
        samples_[at(place.face)].push_back(static_cast<int>(points_.size()));
        points_.push_back(surface.points()[at(p)]);
        distance_.push_back(static_cast<float>(std::sqrt(place.spot.distance)));
    }
}

std::optional<std::vector<Coverage::Owner>>
Coverage::cover(std::span<const int> faces, std::span<const Quad> quads, std::vector<int> *missed) const {
    double reach = tolerance_;
    for (const int f : faces)
        for (const int s : samples(f))
            reach = std::max(reach, allowed(s));
    std::vector<Entry> entries;
    for (std::size_t q = 0; q < quads.size(); ++q)
        entries.emplace_back(box_of(quads[q], reach), static_cast<int>(q));
    const index::rtree<Entry, index::rstar<16>> tree(entries.begin(), entries.end());
    std::vector<Owner> owners;
    for (const int f : faces)
        for (const int s : samples(f)) {
            Owner owner{s, -1, 0};
            double nearest = std::numeric_limits<double>::infinity();
            for (auto e = tree.qbegin(index::intersects(corner(point(s)))); e != tree.qend(); ++e) {
                const double d = nearest_spot(quads[at(e->second)], point(s)).distance;
                if (std::pair(d, e->second) < std::pair(nearest, owner.quad)) {
                    nearest = d;
                    owner.quad = e->second;
                }
            }
            owner.distance = static_cast<float>(std::sqrt(nearest));
            if (std::sqrt(nearest) <= allowed(s)) {
                owners.push_back(owner);
            } else {
                if (missed == nullptr)
                    return std::nullopt;
                if (missed->empty() || missed->back() != f)
                    missed->push_back(f);
            }
        }
    return owners;
}

void Coverage::assign(std::span<const int> faces, std::span<const Owner> owners,
                      std::span<const int> of_quad) {
    for (const int f : faces)
        samples_[at(f)].clear();
    for (const Owner &owner : owners) {
        samples_[at(of_quad[at(owner.quad)])].push_back(owner.sample);
        distance_[at(owner.sample)] = owner.distance;
    }
}

} // namespace alphamst::adapt
