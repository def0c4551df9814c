// Verdict quadrilateral metrics (Stimpson et al., Verdict Geometric Quality
// Library, SAND2007-1751; Pebay 2004 for the aspect ratio).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace alphamst::quality {

// Numbers equal those of enum amst_metric.
enum class Metric : std::int32_t {
    area = 0,
    aspect_ratio = 1,
    condition = 2,
    distortion = 3,
    edge_ratio = 4,
    jacobian = 5,
    max_angle = 6,
    min_angle = 7,
    oddy = 8,
    radius_ratio = 9,
    relative_size = 10,
    scaled_jacobian = 11,
    shape = 12,
    shape_and_size = 13,
    shear = 14,
    shear_and_size = 15,
    skew = 16,
    stretch = 17,
    taper = 18,
    warpage = 19
};

using Corners = std::array<Eigen::Vector3d, 4>; // counter-clockwise

// mean_area is the mean face area of the mesh; only the size metrics read it.
double measure(Metric metric, const Corners &quad, double mean_area);

struct Range {
    double low, high; // acceptable values, ends included
};
Range acceptable_range(Metric metric);

struct Summary {
    std::int64_t count = 0, acceptable = 0;
    double min = 0, max = 0, mean = 0, stddev = 0;
};
Summary summarise(Metric metric, std::span<const double> values);

} // namespace alphamst::quality
