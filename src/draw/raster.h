// What is nearest to the eye at each cell of a coarse grid over a drawing (a depth buffer, Catmull 1974).
#pragma once

#include <cstdint>
#include <vector>

#include "draw/view.h"

namespace alphamst::draw {

class Raster {
public:
    // The points are those of a drawing: 0..width to the right, 0..height up, and to the eye.
    Raster(const io::Arrays &mesh, const std::vector<Vector3> &points, double width, double height,
           double cell);

    // Cells that show a face.
    std::int64_t covered() const;
    // The faces that are nearest in some cell.
    std::vector<bool> nearest(std::size_t n_faces) const;
    // Whether nothing is in front of that point, to within the size of a few cells.
    bool shows(const Vector3 &point) const;

private:
    void lay(const std::array<Vector3, 3> &triangle, std::int32_t face);
    std::int64_t column(double x) const;
    std::int64_t row(double y) const;

    double cell_;
    std::int64_t columns_, rows_;
    std::vector<double> depths_;
    std::vector<std::int32_t> faces_; // -1: none
};

} // namespace alphamst::draw
