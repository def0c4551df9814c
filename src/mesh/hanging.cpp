#include "mesh/hanging.h"

#include <algorithm>
#include <limits>

#include "index.h"
#include "mesh/quad_mesh.h"

namespace alphamst::mesh {
namespace {

using Edge = std::array<std::int32_t, 2>;
using Point = OpenMesh::Vec3d;

Point point(Coordinates points, std::int32_t v) {
    return {points[3 * at(v)], points[3 * at(v) + 1], points[3 * at(v) + 2]};
}

// The way along a straight edge in steps of other edges.
class Way {
public:
    Way(Coordinates points, const std::vector<Edge> &directed, const Edge &edge)
        : points_(points), directed_(directed), edge_(edge), origin_(point(points, edge[0])),
          direction_(point(points, edge[1]) - origin_) {}

    // Empty if the others do not come to the end.
    std::vector<std::int32_t> walk() const {
        std::vector<std::int32_t> passed;
        if (!(direction_.sqrnorm() > 0))
            return passed;
        std::int32_t here = edge_[0];
        while (here != edge_[1]) {
            here = next(here);
            if (here < 0)
                return {};
            if (here != edge_[1])
                passed.push_back(here);
        }
        return passed;
    }

private:
    // How far along the edge a vertex is, 0 to 1; not a number if it is beside.
    double place(std::int32_t v) const {
        // Midpoints are written with some digits only, and faces on a curve bend away a little.
        constexpr double near = 1e-3;
        const Point offset = point(points_, v) - origin_;
        const double t = (offset | direction_) / direction_.sqrnorm();
        return (offset - t * direction_).sqrnorm() <= near * near * direction_.sqrnorm()
                   ? t
                   : std::numeric_limits<double>::quiet_NaN();
    }

    // The nearest vertex further along, -1 if there is none. The edge itself is no step.
    std::int32_t next(std::int32_t here) const {
        // Two for each slit at a vertex; where there are more than this, faces do not meet at edges at all.
        constexpr std::size_t most_edges = 32;
        const std::span<const Edge> steps(std::ranges::lower_bound(directed_, Edge{here, -1}),
                                          std::ranges::lower_bound(directed_, Edge{here + 1, -1}));
        if (steps.size() > most_edges)
            return -1;
        const double from = here == edge_[0] ? 0 : place(here);
        double nearest = 1;
        std::int32_t found = -1;
        for (const auto &[start, to] : steps) {
            const double t = to == edge_[1] ? 1 : place(to);
            if (t > from && t <= nearest && !(here == edge_[0] && to == edge_[1])) {
                nearest = t;
                found = to;
            }
        }
        return found;
    }

    Coordinates points_;
    const std::vector<Edge> &directed_;
    Edge edge_;
    Point origin_, direction_;
};

} // namespace

std::vector<Hanging> find_hanging(Coordinates points, const std::vector<Edge> &edges) {
    std::vector<Edge> directed;
    for (const auto &[v, w] : edges)
        directed.insert(directed.end(), {{v, w}, {w, v}});
    std::ranges::sort(directed);
    std::vector<Hanging> hanging;
    for (std::size_t e = 0; e < edges.size(); ++e)
        for (const std::int32_t vertex : Way(points, directed, edges[e]).walk())
            hanging.push_back({vertex, e});
    return hanging;
}

} // namespace alphamst::mesh
