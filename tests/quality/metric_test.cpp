#include "quality/metric.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace alphamst::quality {
namespace {

struct Reference {
    const char *name;
    Corners corners;
    std::array<double, 20> values; // by number of the metric
};

const double mean_area = 1.5;

// Computed with vtkMeshQuality of VTK 9.1. That version predates Verdict 1.4 in three
// things, which are given here after 1.4: the area in the aspect ratio of warped elements,
// 1e30 instead of 5e29 for an infinite condition number, and the size metrics, which
// it always relates to the element's own area (here: from its area, shape and shear).
// clang-format off
const Reference references[] = {
    {"unit square",
     {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
     {1, 1, 1, 1, 1, 1, 90, 90, 0, 1, 0.444444444444444, 1, 1, 0.444444444444444, 1, 0.444444444444444, 0, 1, 0, 1}},
    {"rectangle",
     {{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}}},
     {3, 2, 1.66666666666667, 1, 3, 3, 90, 90, 3.55555555555556, 1.66666666666667, 0.25, 1, 0.6, 0.15, 1, 0.25, 0, 0.447213595499958, 0, 1}},
    {"rhombus",
     {{{0, 0, 0}, {2, 1, 0}, {3, 3, 0}, {1, 2, 0}}},
     {3, 1.66666666666667, 1.66666666666667, 1, 1, 3, 143.130102354156, 36.869897645844, 3.55555555555556, 2.23606797749979, 0.25, 0.6, 0.6, 0.15, 0.6, 0.15, 0.8, 0.74535599249993, 0, 1}},
    {"trapezium",
     {{{0, 0, 0}, {4, 0, 0}, {3, 1.5, 0}, {0.5, 1.5, 0}}},
     {4.875, 2.02746963442383, 1.60416666666667, 0.769230769230769, 2.5298221281347, 3.75, 123.69006752598, 56.3099324740202, 3.14670138888889, 1.99555060627944, 0.0946745562130178, 0.832050294337844, 0.623376623376623, 0.0590179051717513, 0.832050294337844, 0.0787739923633462, 0.164398987305357, 0.587220219514703, 0.493196961916072, 1}},
    {"convex",
     {{{0.1, -0.2, 0}, {2.3, 0.4, 0}, {1.9, 2.1, 0}, {-0.3, 1.4, 0}}},
     {3.89, 1.18471112942878, 1.05921052631579, 0.966580976863753, 1.39984242810733, 3.76, 93.6138807520037, 85.5903956952571, 0.243853878116343, 1.10875471416531, 0.148690532047766, 0.997039878058435, 0.944099378881988, 0.140378638951928, 0.997039878058435, 0.148250389941348, 0.049425380504096, 0.798591961360927, 0.029450003202688, 1}},
    {"tilted",
     {{{1, 0, 0}, {0, 1, 0}, {-0.5, 0.5, 1}, {0.5, -0.5, 1}}},
     {1.73205080756888, 1.07735026918963, 1.01036297108184, 1, 1.15470053837925, 1.73205080756888, 90, 90, 0.0416666666666667, 1.01036297108184, 0.75, 1, 0.989743318610787, 0.74230748895809, 1, 0.75, 0, 0.925820099772551, 0, 1}},
    {"large",
     {{{100, 100, 0}, {350, 120, 0}, {330, 290, 0}, {90, 310, 0}}},
     {46550, 1.17592679812982, 1.08044554455446, 0.867883995703545, 1.46518179048911, 40400, 101.473478498483, 82.5100473153676, 0.334725149495148, 1.24254220699464, 1.03834851821898e-09, 0.980016884565357, 0.925544100801833, 9.610373456139e-10, 0.980016884565357, 1.01759907991802e-09, 0.0787024854200107, 0.751725754790042, 0.108166220128446, 1}},
    {"slightly warped",
     {{{0, 0, 0}, {1, 0, 0.05}, {1.1, 0.9, 0}, {0.05, 1, 0.04}}},
     {0.97752583086075, 1.07052392032017, 1.01386416539132, 0.922906261404272, 1.16384228973686, 0.900492828128031, 96.1638937792799, 87.0290870254216, 0.0470420740165814, 1.10525622070919, 0.424691888888889, 0.991676711331693, 0.986325421230402, 0.418884406201469, 0.991676711331693, 0.421157055702578, 0.0300112576896517, 0.902416996539606, 0.0753051747875073, 0.973883052651955}},
    {"warped",
     {{{0, 0, 0}, {1, 0, 0.6}, {1, 1, 0}, {0, 1, 0.6}}},
     {1, 1.36, 1.36, 0.849030246544373, 1, 1, 74.6505229829919, 74.6505229829919, 0.150697674418605, 0.8892118276421, 0.444444444444444, 0.735294117647059, 0.735294117647059, 0.326797385620915, 0.735294117647059, 0.326797385620915, 0, 1.16619037896906, 0.6, 0.00431408555221553}},
    {"twisted",
     {{{0, 0, 0}, {1.2, 0.1, 0.4}, {1, 1, -0.3}, {-0.2, 0.8, 0.7}}},
     {1.08218528912567, 1.84916858418573, 1.65291747913266, 0.738157038869446, 1.45590457093112, 0.840937322974757, 84.9840534892156, 62.7479663251258, 0.904783708355137, 1.05877658828776, 0.5205, 0.612713937108891, 0.604990879837954, 0.314897752955655, 0.612713937108891, 0.318917604265178, 0.103399108427798, 0.959822818294963, 0.803680060312723, -9.36983421263401e-06}},
    {"concave",
     {{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}},
     {1, 3.58113883008419, 1e+30, -1.46410161513775, 1.26491106406735, -2, 233.130102354156, 18.434948822922, 19.125, 3.60555127546399, 0.444444444444444, -0.8, 0, 0, 0, 0, 0.88235294117647, 0.790569415042095, 0.727606875108999, -1}},
    {"concave and warped",
     {{{0, 0, 0}, {2, 0, 0.1}, {0.6, 0.5, -0.1}, {0, 2, 0.2}}},
     {1.10929031366906, 3.24141045526722, 1e+30, -1.34236803419255, 1.33998341614945, -1.70014105122949, 231.628912740849, 20.1444766484515, 16.3102513783758, 3.48763284230508, 0.5469, -0.689781929406619, 0, 0, 0, 0, 0.857331084263539, 0.749531688995862, 0.72957364954446, -0.898823134432359}},
};
// clang-format on

const Corners unit_square = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};

double value(Metric metric, const Corners &quad) { return measure(metric, quad, mean_area); }

Metric metric_of(int i) { return static_cast<Metric>(i); }

Corners random_quad(std::mt19937 &random, double spread) {
    std::uniform_real_distribution<double> shift(-spread, spread);
    Corners quad = unit_square;
    for (auto &p : quad)
        p += Eigen::Vector3d(shift(random), shift(random), shift(random));
    return quad;
}

TEST(Metric, AgreesWithVerdict) {
    for (const Reference &r : references)
        for (int i = 0; i < 20; ++i) {
            const double expected = r.values[static_cast<std::size_t>(i)];
            EXPECT_NEAR(value(metric_of(i), r.corners), expected, 1e-10 * std::max(1.0, std::abs(expected)))
                << r.name << ", metric " << i;
        }
}

TEST(Metric, UnitSquareIsIdeal) {
    const double ideal[20] = {1, 1, 1, 1, 1, 1, 90, 90, 0, 1, 1, 1, 1, 1, 1, 1, 0, 1, 0, 1};
    for (int i = 0; i < 20; ++i) {
        EXPECT_NEAR(measure(metric_of(i), unit_square, 1), ideal[i], 1e-13) << "metric " << i;
        const double values[] = {measure(metric_of(i), unit_square, 1)};
        EXPECT_EQ(summarise(metric_of(i), values).acceptable, 1) << "metric " << i;
    }
}

TEST(Metric, Identities) {
    std::mt19937 random(1);
    for (int n = 0; n < 500; ++n) {
        const Corners quad = random_quad(random, 0.35);
        const double shape = value(Metric::shape, quad), shear = value(Metric::shear, quad);
        const double size = value(Metric::relative_size, quad);
        if (shape > 0) {
            EXPECT_NEAR(value(Metric::condition, quad) * shape, 1, 1e-12);
        } else {
            EXPECT_EQ(value(Metric::condition, quad), 1e30);
        }
        EXPECT_EQ(shear, std::max(0.0, value(Metric::scaled_jacobian, quad)));
        EXPECT_NEAR(value(Metric::shape_and_size, quad), shape * size, 1e-15);
        EXPECT_NEAR(value(Metric::shear_and_size, quad), shear * size, 1e-15);
        EXPECT_LE(shape, shear + 1e-15);
        double longest = 0, perimeter = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const double length = (quad[(k + 1) % 4] - quad[k]).norm();
            longest = std::max(longest, length);
            perimeter += length;
        }
        EXPECT_NEAR(value(Metric::aspect_ratio, quad) * 4 * value(Metric::area, quad), longest * perimeter,
                    1e-10);
    }
}

TEST(Metric, PlanarConvexShearIsSineOfWorstAngle) {
    std::mt19937 random(2);
    const double radians = std::acos(-1.0) / 180;
    for (int n = 0; n < 200; ++n) {
        Corners quad = random_quad(random, 0.2);
        for (auto &p : quad)
            p.z() = 0;
        const double low = value(Metric::min_angle, quad), high = value(Metric::max_angle, quad);
        EXPECT_NEAR(value(Metric::shear, quad), std::min(std::sin(radians * low), std::sin(radians * high)),
                    1e-12);
        EXPECT_NEAR(value(Metric::warpage, quad), 1, 1e-12);
    }
}

// Lengths only scale the areas; rotations and the choice of the first corner change nothing.
TEST(Metric, InvariantUnderSimilarity) {
    std::mt19937 random(3);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    for (int n = 0; n < 100; ++n) {
        const Corners quad = random_quad(random, 0.3);
        for (const double scale : {1e-9, 1.0, 1e6}) {
            Corners moved;
            for (std::size_t k = 0; k < 4; ++k)
                moved[k] = scale * (turn * quad[(k + 1) % 4] + Eigen::Vector3d(1, -2, 0.5));
            for (int i = 0; i < 20; ++i) {
                const bool squared = metric_of(i) == Metric::area || metric_of(i) == Metric::jacobian;
                const double unit = squared ? scale * scale : 1;
                const double expected = value(metric_of(i), quad);
                EXPECT_NEAR(measure(metric_of(i), moved, mean_area * scale * scale) / unit, expected,
                            1e-8 * std::max(1.0, std::abs(expected)))
                    << "metric " << i << ", scale " << scale;
            }
        }
    }
}

TEST(Metric, DegenerateElementsAreFinite) {
    const Corners degenerate[] = {
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},          // a point
        {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}},          // a line
        {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 0}}},          // a line, collapsed
        {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}}},          // a triangle
        {{{0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}},          // a triangle, other edge
        {{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}},          // a bow tie
        {{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}}},          // folded
        {{{1e-320, 0, 0}, {0, 0, 0}, {0, 1e-320, 0}, {0, 0, 0}}} // below what can be divided by
    };
    for (const Corners &quad : degenerate)
        for (int i = 0; i < 20; ++i)
            for (const double area : {0.0, 1.0}) {
                const double x = measure(metric_of(i), quad, area);
                EXPECT_TRUE(std::isfinite(x) && std::abs(x) <= 1e30) << "metric " << i;
            }
}

TEST(Metric, DegenerateValuesAreVerdicts) {
    const Corners triangle = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}}};
    EXPECT_NEAR(value(Metric::min_angle, triangle), 45, 1e-12);
    EXPECT_NEAR(value(Metric::max_angle, triangle), 90, 1e-12);
    EXPECT_NEAR(value(Metric::jacobian, triangle), 1, 1e-12);
    EXPECT_NEAR(value(Metric::scaled_jacobian, triangle), std::sqrt(2 / 3.0), 1e-12);
    EXPECT_NEAR(value(Metric::distortion, triangle), 2, 1e-12);
    EXPECT_EQ(value(Metric::edge_ratio, triangle), 1e30);
    EXPECT_EQ(value(Metric::shape, triangle), 0);
    EXPECT_EQ(value(Metric::stretch, triangle), 0);

    const Corners other = {{{0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
    EXPECT_EQ(value(Metric::min_angle, other), 360);
    EXPECT_EQ(value(Metric::max_angle, other), 0);
    EXPECT_EQ(value(Metric::condition, other), 1e30);
    EXPECT_EQ(value(Metric::scaled_jacobian, other), 0);

    const Corners line = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}};
    EXPECT_EQ(value(Metric::aspect_ratio, line), 1e30);
    EXPECT_EQ(value(Metric::oddy, line), 1e30);
    EXPECT_EQ(value(Metric::radius_ratio, line), 1e30);
    EXPECT_EQ(value(Metric::relative_size, line), 0);
}

TEST(Metric, RangesOfTheManual) {
    EXPECT_EQ(acceptable_range(Metric::aspect_ratio).high, 1.3);
    EXPECT_EQ(acceptable_range(Metric::min_angle).low, 45);
    EXPECT_EQ(acceptable_range(Metric::max_angle).high, 135);
    EXPECT_EQ(acceptable_range(Metric::scaled_jacobian).low, 0.3);
    EXPECT_EQ(acceptable_range(Metric::taper).high, 0.7);
    for (int i = 0; i < 20; ++i)
        EXPECT_LT(acceptable_range(metric_of(i)).low, acceptable_range(metric_of(i)).high);
}

TEST(Summary, CountsAndMoments) {
    const double values[] = {0.1, 0.3, 0.6, 1.0};
    const Summary s = summarise(Metric::scaled_jacobian, values);
    EXPECT_EQ(s.count, 4);
    EXPECT_EQ(s.acceptable, 3);
    EXPECT_EQ(s.min, 0.1);
    EXPECT_EQ(s.max, 1.0);
    EXPECT_NEAR(s.mean, 0.5, 1e-15);
    EXPECT_NEAR(s.stddev, std::sqrt((0.16 + 0.04 + 0.01 + 0.25) / 4), 1e-15);
    const Summary none = summarise(Metric::shape, {});
    EXPECT_EQ(none.count, 0);
    EXPECT_EQ(none.max, 0);
}

} // namespace
} // namespace alphamst::quality
