#include "surface/boundary_curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>

#include "index.h"
#include "surface/angle.h"
#include "surface/boxes.h"
#include "surface/curve.h"

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;

// Between two straight lines; they may cross.
double distance(const Line &a, const Line &b) {
    double least = std::min({a.distance(b.start), a.distance(b.end), b.distance(a.start), b.distance(a.end)});
    // Where the lines come nearest inside both (after Eberly, Robust computation of distance between line
    // segments).
    const Vector3d u = a.end - a.start, v = b.end - b.start, w = a.start - b.start;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), wu = w.dot(u), wv = w.dot(v);
    const double crossing = uu * vv - uv * uv;
    if (crossing > 0) {
        const double s = (uv * wv - vv * wu) / crossing, t = (uu * wv - uv * wu) / crossing;
        if (s > 0 && s < 1 && t > 0 && t < 1)
            least = std::min(least, (a.at(s) - b.at(t)).norm());
    }
    return least;
}

} // namespace

struct BoundaryCurves::Tree {
    BoxTree boxes;
    std::vector<std::array<int, 2>> segments; // curve and point where it begins
};

BoundaryCurves::BoundaryCurves(std::vector<std::vector<Vector3d>> curves) {
    std::vector<BoxEntry> entries;
    std::vector<std::array<int, 2>> segments;
    for (std::vector<Vector3d> &points : curves) {
        Curve &curve = curves_.emplace_back();
        double length = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::array ends{points[i], points[(i + 1) % points.size()]};
            curve.lengths.push_back(length);
            length += (ends[1] - ends[0]).norm();
            entries.emplace_back(box_of(ends), static_cast<int>(segments.size()));
            segments.push_back({static_cast<int>(curves_.size()) - 1, static_cast<int>(i)});
        }
        curve.lengths.push_back(length);
        curve.points = std::move(points);
        extent_ = std::max(extent_, length);
    }
    tree_.reset(new Tree{BoxTree(entries), std::move(segments)});
}

BoundaryCurves::~BoundaryCurves() = default;

double BoundaryCurves::length(int curve) const { return curves_[alphamst::at(curve)].lengths.back(); }

std::size_t BoundaryCurves::segment(CurvePlace place) const {
    const std::vector<double> &lengths = curves_[alphamst::at(place.curve)].lengths;
    const auto after = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, place.along);
    return static_cast<std::size_t>(after - lengths.begin()) - 1;
}

Vector3d BoundaryCurves::at(CurvePlace place) const {
    const Curve &curve = curves_[alphamst::at(place.curve)];
    const std::size_t i = segment(place);
    const double length = curve.lengths[i + 1] - curve.lengths[i];
    const double part = length > 0 ? (place.along - curve.lengths[i]) / length : 0;
    const Vector3d &start = curve.points[i], &end = curve.points[(i + 1) % curve.points.size()];
    return part > 0 ? Vector3d(start + part * (end - start)) : start;
}

CurvePlace BoundaryCurves::find(const Vector3d &point, double tolerance) const {
    CurvePlace found;
    double nearest = tolerance;
    std::vector<CurvePlace> places;
    const Box box = box_of(std::span(&point, 1), tolerance);
    tree_->boxes.query(
        spatial_index::intersects(box), boost::make_function_output_iterator([&](const BoxEntry &entry) {
            const auto [c, i] = tree_->segments[alphamst::at(entry.second)];
            const Curve &curve = curves_[alphamst::at(c)];
            const std::size_t first = alphamst::at(i);
            const Line line{curve.points[first], curve.points[(first + 1) % curve.points.size()]};
            const double part = std::clamp(line.place(point), 0.0, 1.0);
            const double away = (line.at(part) - point).norm();
            if (away > tolerance)
                return;
            const double length = curve.lengths[first + 1] - curve.lengths[first];
            double along = curve.lengths[first] + part * length;
            if (along >= curve.lengths.back())
                along = 0;
            places.push_back({c, along});
            if (found.curve < 0 || away < nearest) {
                nearest = away;
                found = places.back();
            }
        }));
    // The same point is found on two segments that meet in it.
    for (const CurvePlace &place : places) {
        const double round = found.curve < 0 ? 0 : length(found.curve);
        const double apart = std::abs(place.along - found.along);
        if (place.curve != found.curve || std::min(apart, round - apart) > 4 * tolerance)
            return {};
    }
    return found;
}

double BoundaryCurves::way(CurvePlace from, CurvePlace to) const {
    const double ahead = to.along - from.along;
    return ahead > 0 ? ahead : ahead + length(from.curve);
}

CurvePlace BoundaryCurves::advance(CurvePlace from, double length) const {
    const double round = this->length(from.curve);
    const double along = from.along + length;
    return {from.curve, along < round ? along : std::max(0.0, along - round)};
}

std::vector<BoundaryCurves::Bend> BoundaryCurves::between(CurvePlace from, double length) const {
    const Curve &curve = curves_[alphamst::at(from.curve)];
    const std::size_t n = curve.points.size();
    std::vector<Bend> bends;
    const std::size_t first = segment(from);
    for (std::size_t k = 1; k <= n; ++k) {
        const std::size_t i = first + k;
        const double along = curve.lengths[i % n] + (i >= n ? curve.lengths.back() : 0) - from.along;
        if (along >= length)
            break;
        if (along <= 0)
            continue;
        const Vector3d &point = curve.points[i % n];
        bends.push_back(
            {point, along,
             degrees_between(point - curve.points[(i + n - 1) % n], curve.points[(i + 1) % n] - point)});
    }
    return bends;
}

bool BoundaryCurves::others_near(CurvePlace from, double length, double distance_wanted) const {
    const std::array ends{at(from), at(advance(from, length))};
    const Line chord{ends[0], ends[1]};
    bool near = false;
    tree_->boxes.query(
        spatial_index::intersects(box_of(ends, distance_wanted)),
        boost::make_function_output_iterator([&](const BoxEntry &entry) {
            const auto [c, i] = tree_->segments[alphamst::at(entry.second)];
            const Curve &curve = curves_[alphamst::at(c)];
            const std::size_t first = alphamst::at(i);
            if (c == from.curve) {
                // What meets the way, or a piece as long at either end, belongs to it.
                const double round = curve.lengths.back();
                const double start = way({c, from.along}, {c, curve.lengths[first]});
                const double own = curve.lengths[first + 1] - curve.lengths[first];
                const double ahead = start >= round ? 0 : start;
                if (ahead <= 2 * length || ahead + own >= round - length)
                    return;
            }
            const Line line{curve.points[first], curve.points[(first + 1) % curve.points.size()]};
            near = near || distance(chord, line) < distance_wanted;
        }));
    return near;
}

} // namespace alphamst::surface
