#include "adapt/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "index.h"
#include "meshes.h"
#include "reference/statistics.h"

namespace alphamst::adapt {
namespace {

const auto silent = [](double) {};

// Singular vertices and mismatches on the mesh boundary, counted anew.
int irregular(const mesh::QuadMesh &mesh) {
    int sum = static_cast<int>(mesh.singularities().size());
    for (int v = 0; v < mesh.n_vertices(); ++v)
        sum += !mesh.isolated(v) && mesh.on_boundary(v) && reference::mismatch(mesh, v) != 0;
    return sum;
}

// A mesh in the plane under a sweep that wants so many faces, evenly.
struct Swept {
    mesh::QuadMesh mesh;
    Settings settings;
    reference::Reference reference;
    const std::optional<reference::SizingField> sizing;
    std::optional<Sweep> sweep;

    Swept(mesh::QuadMesh of, int wanted, int threads = 1) : mesh(std::move(of)) {
        settings.threads = threads;
        settings.patient = false;
        settings.candidates = 3;
        settings.node_limit = 200;
        reference = reference::reference_of(mesh);
        start(std::vector<double>(at(mesh.n_faces()), static_cast<double>(wanted) / mesh.n_faces()));
    }
    Swept(const Swept &) = delete;
    Swept &operator=(const Swept &) = delete;

    void start(const std::vector<double> &target_counts) {
        sweep.emplace(mesh, reference, target_counts, sizing, settings);
    }
    double quality() const {
        const std::vector<double> each = reference.scaled_jacobians(mesh);
        return *std::min_element(each.begin(), each.end());
    }
};

Pass pass_of(Purpose purpose, int size, int most_added) {
    Pass pass;
    pass.purpose = purpose;
    pass.size = size;
    pass.slack = 0.03;
    pass.most_added = most_added;
    pass.shape = {0.3, 0.1, 3, 0};
    return pass;
}

TEST(Sweep, KnowsWhatIsIrregularAndMissing) {
    const Swept swept(samples::unstructured(12, 3), 160);
    EXPECT_EQ(swept.sweep->singular(), irregular(swept.mesh));
    EXPECT_GT(swept.sweep->singular(), 8);
    EXPECT_EQ(swept.sweep->wanted(), 160);
    EXPECT_EQ(swept.sweep->missing(), 16);
    EXPECT_EQ(swept.sweep->effort(), 0);
}

TEST(Sweep, NeverAddsSingularitiesWhereFewerAreThePurpose) {
    Swept swept(samples::unstructured(12, 3), 144);
    const int first = swept.sweep->singular();
    for (const int size : {16, 30, 30}) {
        const int before = swept.sweep->singular();
        const int refilled =
            swept.sweep->run(pass_of(Purpose::fewer_singularities, size, -1), "reduce", silent);
        EXPECT_EQ(refilled, swept.sweep->refilled());
        EXPECT_LE(refilled, swept.sweep->tried());
        EXPECT_LE(swept.sweep->singular(), before - refilled);
        EXPECT_EQ(swept.sweep->singular(), irregular(swept.mesh));
        EXPECT_LE(std::abs(swept.sweep->missing()), 8); // the slack
        EXPECT_NO_THROW(swept.mesh.check());
    }
    EXPECT_LT(swept.sweep->singular(), first);
    EXPECT_GT(swept.sweep->effort(), 0);
}

TEST(Sweep, OfARegularMeshTriesNothing) {
    Swept swept(samples::grid(10, 10), 100);
    const std::uint64_t before = swept.mesh.checksum();
    EXPECT_EQ(swept.sweep->run(pass_of(Purpose::fewer_singularities, 30, -1), "reduce", silent), 0);
    EXPECT_EQ(swept.sweep->tried(), 0);
    EXPECT_EQ(swept.mesh.checksum(), before);
}

TEST(Sweep, BringsTheCountThatIsWanted) {
    for (const int wanted : {148, 139}) {
        Swept swept(samples::unstructured(12, 3), wanted);
        for (int k = 0; k < 4 && swept.sweep->missing() != 0; ++k) {
            const std::int64_t before = std::abs(swept.sweep->missing());
            swept.sweep->run(pass_of(Purpose::count, 40, 4), "count", silent);
            EXPECT_LE(std::abs(swept.sweep->missing()), before);
        }
        EXPECT_EQ(swept.mesh.n_faces(), wanted);
        EXPECT_EQ(swept.sweep->singular(), irregular(swept.mesh));
        const auto effort = swept.sweep->effort(); // there is nothing left to do
        EXPECT_EQ(swept.sweep->run(pass_of(Purpose::count, 40, 4), "count", silent), 0);
        EXPECT_EQ(swept.sweep->effort(), effort);
    }
}

TEST(Sweep, TakesNothingBeyondTheLimit) {
    const auto run = [](bool limited) {
        Swept swept(samples::grid(12, 12), 130);
        if (limited)
            swept.sweep->limit(2);
        for (int k = 0; k < 2; ++k)
            swept.sweep->run(pass_of(Purpose::count, 40, 8), "count", silent);
        return swept.sweep->singular();
    };
    EXPECT_LE(run(true), 2);
    EXPECT_GT(run(false), 2); // what it costs otherwise
}

// Twice as many faces are wanted on the left as there are, and half as many on the right.
TEST(Sweep, SpreadsFacesToWhereTheyAreWanted) {
    Swept swept(samples::grid(16, 12), 192);
    std::vector<double> targets;
    for (int f = 0; f < 192; ++f)
        targets.push_back(f % 16 < 8 ? 1.5 : 0.5);
    swept.start(targets);
    EXPECT_EQ(swept.sweep->wanted(), 192);
    Pass pass = pass_of(Purpose::spread, 40, 8);
    pass.slack = 0.2;
    EXPECT_GT(swept.sweep->run(pass, "spread", silent), 0);
    int left = 0, right = 0;
    for (int f = 0; f < swept.mesh.n_faces(); ++f)
        ++(samples::centre(swept.mesh, f)[0] < 8 ? left : right);
    EXPECT_GT(left, 100);
    EXPECT_LT(right, 92);
    EXPECT_EQ(swept.sweep->singular(), irregular(swept.mesh));
}

TEST(Sweep, CollapsesWhereThereAreTooManyFaces) {
    Swept swept(samples::grid(14, 14), 98);
    Pass pass = pass_of(Purpose::collapse, 40, -1);
    pass.shape = {0.1, 0.02, 3, 0};
    EXPECT_GT(swept.sweep->run(pass, "collapse", silent), 0);
    EXPECT_LT(swept.mesh.n_faces(), 180);
    EXPECT_GE(swept.mesh.n_faces(), 98);
    EXPECT_NO_THROW(swept.mesh.check());
}

TEST(Sweep, MendsTheWorstShapes) {
    mesh::QuadMesh mesh = samples::grid(10, 10);
    mesh.set_point(5 * 11 + 5, OpenMesh::Vec3d(5.8, 5.8, 0));
    Swept swept(std::move(mesh), 100);
    const double before = swept.quality();
    ASSERT_LT(before, 0.5);
    Pass pass = pass_of(Purpose::mend, 16, 0);
    pass.shape = {0.5, 0, 100, 0};
    EXPECT_GT(swept.sweep->run(pass, "mend", silent), 0);
    EXPECT_GT(swept.quality(), before);
    EXPECT_LE(swept.sweep->singular(), 0);
    pass.shape.scaled_jacobian = 0; // nothing is worse than that
    EXPECT_EQ(swept.sweep->run(pass, "mend", silent), 0);
    EXPECT_EQ(swept.sweep->tried(), 0);
}

TEST(Sweep, WanderingOnesAreAsManyAsBefore) {
    Swept swept(samples::unstructured(12, 3), 144);
    const int before = swept.sweep->singular();
    const std::vector<int> places = swept.mesh.singularities();
    EXPECT_GT(swept.sweep->run(pass_of(Purpose::wander, 30, -1), "reduce", silent), 0);
    EXPECT_LE(swept.sweep->singular(), before);
    EXPECT_EQ(swept.sweep->singular(), irregular(swept.mesh));
    EXPECT_NE(swept.mesh.singularities(), places);
}

TEST(Sweep, TellsHowFarItIs) {
    Swept swept(samples::unstructured(12, 3), 144);
    std::vector<double> told;
    swept.sweep->run(pass_of(Purpose::fewer_singularities, 16, -1), "reduce",
                     [&](double part) { told.push_back(part); });
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told.front(), 0);
    for (const double part : told) {
        EXPECT_GE(part, 0);
        EXPECT_LT(part, 1);
    }
    EXPECT_THROW(swept.sweep->run(pass_of(Purpose::fewer_singularities, 16, -1), "reduce",
                                  [](double) { throw Failure(Fault::cancelled, "enough"); }),
                 Failure);
}

TEST(Sweep, EqualOnAnyNumberOfThreads) {
    std::set<std::uint64_t> digests;
    for (const int threads : {1, 2}) {
        Swept swept(samples::unstructured(12, 3), 150, threads);
        swept.sweep->run(pass_of(Purpose::fewer_singularities, 30, -1), "reduce", silent);
        swept.sweep->run(pass_of(Purpose::count, 40, 4), "count", silent);
        digests.insert(swept.mesh.checksum());
    }
    EXPECT_EQ(digests.size(), 1u);
}

TEST(Sweep, SaysALineForEachWindowAndOneForTheStage) {
    std::vector<std::pair<int, std::string>> lines;
    auto log = std::make_shared<Log>();
    log->level = log_cavities;
    log->say = [&](int level, const std::string &text) { lines.emplace_back(level, text); };
    Swept swept(samples::unstructured(10, 3), 100);
    swept.settings.log = log;
    swept.start(std::vector<double>(100, 1));
    swept.sweep->run(pass_of(Purpose::fewer_singularities, 16, -1), "reduce", silent);
    const auto of = [&](int level) {
        return std::count_if(lines.begin(), lines.end(), [&](const auto &l) { return l.first == level; });
    };
    EXPECT_EQ(of(log_stages), 1);
    EXPECT_GT(of(log_cavities), 0);
    EXPECT_LE(of(log_cavities), swept.sweep->tried()); // some wait for another round
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                            [](const auto &l) { return l.second.find("taken") != std::string::npos; }),
              swept.sweep->refilled());
}

} // namespace
} // namespace alphamst::adapt
