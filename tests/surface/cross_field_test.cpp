#include "surface/cross_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

Vector3d direction(double degrees) { return {std::cos(degrees * degree), std::sin(degrees * degree), 0}; }

// 0..45 degrees
double apart(const Vector3d &u, const Vector3d &v) {
    const double angle = std::acos(std::min(1.0, std::abs(u.normalized().dot(v.normalized())))) / degree;
    return std::min(angle, 90 - angle);
}

// n x n nodes in a plane, each beside two to four others; nothing beside the last one when `lone`.
Links plane(int n, const Vector3d &normal, bool lone = false) {
    Links links;
    const auto near = [&](int i, int j) {
        return i >= 0 && j >= 0 && i < n && j < n && !(lone && i == n - 1 && j == n - 1);
    };
    links.begin.push_back(0);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            links.frames.emplace_back(normal);
            for (const auto &[k, l] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}})
                if (near(i, j) && near(k, l)) {
                    links.neighbours.push_back(l * n + k);
                    links.weights.push_back(1);
                }
            links.begin.push_back(links.neighbours.size());
        }
    return links;
}

TEST(CrossField, OneGuideIsFollowedEverywhere) {
    const Links links = plane(33, Vector3d::UnitZ(), true);
    const std::vector<Guide> guides{{500, direction(20) * 7, 1}};
    const auto crosses = solve_cross_field(links, guides, 20);
    ASSERT_EQ(crosses.size(), 33u * 33);
    for (std::size_t i = 0; i < crosses.size(); ++i) {
        EXPECT_NEAR(crosses[i].norm(), 1, 1e-14);
        EXPECT_NEAR(crosses[i].z(), 0, 1e-14);
        if (i + 1 < crosses.size()) { // the last one has no neighbour, so any direction is good
            EXPECT_LT(apart(crosses[i], direction(20)), 1e-5) << i;
        }
    }
}

TEST(CrossField, AnyOfTheFourDirectionsGuides) {
    const Vector3d normal = Vector3d(1, 2, 3).normalized();
    const Links links = plane(9, normal);
    const Vector3d first = normal.unitOrthogonal(), second = normal.cross(first);
    const Vector3d one = first + 0.4 * second, other = 0.4 * first - second;
    const auto crosses = solve_cross_field(links, std::vector<Guide>{{0, one, 1}, {80, one, 2}}, 10);
    const auto turned = solve_cross_field(links, std::vector<Guide>{{0, other, 1}, {80, -one, 2}}, 10);
    for (std::size_t i = 0; i < crosses.size(); ++i) {
        EXPECT_LT(apart(crosses[i], one), 1e-5);
        EXPECT_LT(apart(crosses[i], turned[i]), 1e-5);
    }
}

TEST(CrossField, GuidesTakeTheShorterWayBetween) {
    // 10 and 70 degrees as crosses are 30 apart: the way is by 90, not by 40.
    const int n = 17;
    const Links links = plane(n, Vector3d::UnitZ());
    std::vector<Guide> guides;
    for (int j = 0; j < n; ++j) {
        guides.push_back({n * j, direction(10), 100});
        guides.push_back({n * j + n - 1, direction(70), 100});
    }
    const auto crosses = solve_cross_field(links, guides, 200);
    for (int i = 0; i < n; ++i) {
        const double wanted = 10 - 30.0 * i / (n - 1);
        EXPECT_LT(apart(crosses[static_cast<std::size_t>(8 * n + i)], direction(wanted)), 0.5) << i;
    }
}

TEST(CrossField, HeavierGuidesHaveMoreToSay) {
    const Links links = plane(2, Vector3d::UnitZ());
    const auto mean = [&](double weight) {
        const std::vector<Guide> guides{{0, direction(0), weight}, {0, direction(20), 1}};
        return apart(solve_cross_field(links, guides, 50)[3], direction(0));
    };
    EXPECT_NEAR(mean(1), 10, 1e-6);
    EXPECT_LT(mean(3), 6);
    EXPECT_GT(mean(0.3), 14);
}

TEST(CrossField, OfNoNodesIsNone) {
    Links links;
    links.begin.push_back(0);
    EXPECT_TRUE(solve_cross_field(links, {}, 20).empty());
}

} // namespace
} // namespace alphamst::surface
