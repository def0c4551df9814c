#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <complex>

#include "geometry/corner.h"
#include "geometry/parametrise.h"
#include "geometry/star.h"
#include "index.h"
#include "quality/corner.h"

namespace alphamst::geometry {
namespace {

using Complex = std::complex<double>;
using Triplets = std::vector<Eigen::Triplet<Complex>>;

// Of the loop: the farthest from its first vertex, and the farthest from that.
std::array<int, 2> far_apart(const Disk &disk) {
    const auto farthest = [&](int from) {
        int best = 0;
        double most = 0;
        for (int i = 0; i < disk.boundary; ++i)
            if (const double d = (disk.points[at(i)] - disk.points[at(from)]).squaredNorm(); d > most) {
                most = d;
                best = i;
            }
        return best;
    };
    const int first = farthest(0);
    return {first, farthest(first)};
}

// Positions as complex numbers: those of the free vertices are wanted, those of the constrained ones are
// given. The sum over the triangles of | sum of w_j u_j |^2 / d, where w_j is the side opposite to corner j
// and d twice the area, both in the plane of the triangle: 0 where every triangle keeps its angles.
class Equations {
public:
    Equations(const Disk &disk, const std::array<int, 2> &constrained) : pinned_(constrained) {
        int free = 0;
        for (int v = 0; v < static_cast<int>(disk.points.size()); ++v)
            index_.push_back(v == constrained[0] || v == constrained[1] ? -1 : free++);
        right_ = Eigen::VectorXcd::Zero(free);
        place_ = {Complex(0, 0),
                  Complex((disk.points[at(constrained[1])] - disk.points[at(constrained[0])]).norm(), 0)};
        for (const auto &quad : disk.quads)
            for (std::size_t k = 0; k < 4; ++k)
                add(corner_of(quad, k), disk);
    }

    Points solve() const {
        Eigen::SparseMatrix<Complex> matrix(right_.size(), right_.size());
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Complex>> factor(matrix);
        if (factor.info() != Eigen::Success)
            return {};
        const Eigen::VectorXcd solution = factor.solve(right_);
        if (!solution.allFinite())
            return {};
        Points positions;
        for (std::size_t v = 0; v < index_.size(); ++v) {
            const Complex u =
                index_[v] >= 0 ? solution[index_[v]] : place_[static_cast<int>(v) == pinned_[0] ? 0 : 1];
            positions.emplace_back(u.real(), u.imag());
        }
        return positions;
    }

private:
    void add(const std::array<int, 3> &corners, const Disk &disk) {
        const FlatTriangle flat(disk.points[at(corners[0])], disk.points[at(corners[1])],
                                disk.points[at(corners[2])]);
        if (!(flat.twice_area > 0))
            return; // without area it has no angles to keep
        const Complex second(flat.second.x(), 0), third(flat.third.x(), flat.third.y());
        const std::array<Complex, 3> sides{third - second, -third, second};
        for (std::size_t i = 0; i < 3; ++i) {
            const int row = index_[at(corners[i])];
            for (std::size_t j = 0; j < 3 && row >= 0; ++j) {
                const Complex value = std::conj(sides[i]) * sides[j] / flat.twice_area;
                if (const int column = index_[at(corners[j])]; column >= 0)
                    entries_.emplace_back(row, column, value);
                else
                    right_[row] -= value * place_[corners[j] == pinned_[0] ? 0 : 1];
            }
        }
    }

    std::array<int, 2> pinned_;
    std::array<Complex, 2> place_;
    std::vector<int> index_; // unknown by vertex, -1 if constrained
    Triplets entries_;
    Eigen::VectorXcd right_;
};

} // namespace

Points conformal(const Disk &disk) {
    const std::array<int, 2> constrained = far_apart(disk);
    if (constrained[0] == constrained[1])
        return {};
    Points positions = Equations(disk, constrained).solve();
    if (positions.empty())
        return positions;
    double area = 0, flat_area = 0;
    for (const auto &quad : disk.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const auto [a, b, c] = corner_of(quad, k);
            area += FlatTriangle(disk.points[at(a)], disk.points[at(b)], disk.points[at(c)]).twice_area;
            flat_area += quality::determinant(positions[at(b)] - positions[at(a)],
                                              positions[at(c)] - positions[at(a)]);
        }
    if (!(flat_area > 0))
        return {};
    for (Eigen::Vector2d &p : positions)
        p *= std::sqrt(area / flat_area);
    return positions;
}

} // namespace alphamst::geometry
