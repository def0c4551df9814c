// Random patches of unstructured meshes: how often the wanted, the predicted and the delivered
// filling agree. The patches are the same in every run.
#include <array>
#include <iostream>

#include "run.h"

namespace alphamst::adapt::samples {
namespace {

#ifdef ALPHAMST_FULL_CAMPAIGN
constexpr int n_runs = 5000, n_unchanged = 500; // for each mesh
constexpr double least = 20, most = 2000;
#else
constexpr int n_runs = 250, n_unchanged = 50;
constexpr double least = 20, most = 600;
#endif

constexpr std::array<double, 10> alphas{0.4, 0.5, 0.6, 0.8, 1, 1.25, 1.5, 2, 3, 4};

struct Tally {
    int runs = 0, refused = 0, done = 0, exact = 0, near = 0, nearest = 0, later = 0;
    int faces_as_predicted = 0, singularities_as_predicted = 0;
    int quality_kept = 0, more_singular = 0;
    std::map<std::string, int> reasons; // of refusals, numbers left out

    void add(const Run &run) {
        const Outcome &outcome = run.outcome;
        ++runs;
        if (outcome.fault) {
            ++refused;
            std::string reason = outcome.text;
            std::erase_if(reason, [](char c) { return c >= '0' && c <= '9'; });
            ++reasons[reason];
            return;
        }
        ++done;
        const std::int64_t miss = std::abs(outcome.faces_after - outcome.faces_wanted);
        exact += miss == 0;
        near += miss > 0 && miss <= 2;
        // Between what there was and what was wanted, as the boundary allows.
        const auto [few, many] = std::minmax(outcome.faces_before, outcome.faces_wanted);
        nearest += miss > 2 && few < outcome.faces_after && outcome.faces_after < many;
        faces_as_predicted += run.prediction && run.prediction->faces == outcome.faces_after;
        later += outcome.candidate > 0;
        singularities_as_predicted +=
            run.prediction && run.prediction->singularities == outcome.singular_after;
        quality_kept += outcome.quality_after >= outcome.quality_before - 1e-12;
        more_singular += outcome.singular_after > outcome.singular_before;
    }
};

std::ostream &operator<<(std::ostream &out, const Tally &tally) {
    const auto percent = [](int part, int whole) { return whole == 0 ? 0.0 : 100.0 * part / whole; };
    out << tally.runs << " runs, refused " << percent(tally.refused, tally.runs)
        << " %; of the others: exact count " << percent(tally.exact, tally.done) << " %, missed by 1 or 2 "
        << percent(tally.near, tally.done) << " %, the nearest that the boundary allows "
        << percent(tally.nearest, tally.done) << " %, faces as predicted "
        << percent(tally.faces_as_predicted, tally.done) << " %, a later candidate "
        << percent(tally.later, tally.done) << " %, quality kept " << percent(tally.quality_kept, tally.done)
        << " %";
    for (const auto &[reason, count] : tally.reasons)
        out << "\n  " << count << " refused: " << reason;
    return out;
}

struct Generator {
    const char *name;
    std::optional<mesh::QuadMesh> (*make)();
};

void PrintTo(const Generator &generator, std::ostream *out) { *out << generator.name; }

class AdaptCampaign : public ::testing::TestWithParam<Generator> {
protected:
    void SetUp() override {
        mesh = GetParam().make();
        if (!mesh)
            GTEST_SKIP() << "gmsh is not here";
        mesh->check();
    }

    Tally tally(int runs, unsigned seed, double alpha = 0) {
        std::mt19937 random(seed);
        Tally tally;
        for (int i = 0; i < runs; ++i) {
            const std::vector<int> patch = random_patch(*mesh, least, most, random);
            const double drawn = alphas[random() % alphas.size()];
            const double wanted = alpha > 0 ? alpha : drawn;
            SCOPED_TRACE(std::string(GetParam().name) + ", run " + std::to_string(i) + ": " +
                         std::to_string(patch.size()) + " faces, alpha " + std::to_string(wanted));
            const auto result = run(*mesh, patch, wanted);
            tally.add(result);
        }
        std::cout << GetParam().name << ": " << tally << '\n';
        return tally;
    }

    std::optional<mesh::QuadMesh> mesh;
};

TEST_P(AdaptCampaign, DeliversWhatIsWantedAndPredicted) {
    const Tally found = tally(n_runs, 1);
    EXPECT_LE(found.refused, 0.05 * found.runs) << found;
    EXPECT_GE(found.exact, 0.95 * found.done) << found;
    EXPECT_EQ(found.exact + found.near + found.nearest, found.done) << found;
    EXPECT_EQ(found.faces_as_predicted, found.done) << found;
    EXPECT_LE(found.later, 0.25 * found.done) << found; // the order of promise says something
    EXPECT_EQ(found.singularities_as_predicted, found.done) << found;
}

TEST_P(AdaptCampaign, KeepsQualityWhereTheCountStays) {
    const Tally found = tally(n_unchanged, 2, 1.0);
    EXPECT_GE(found.quality_kept, 0.9 * found.done) << found;
    EXPECT_EQ(found.more_singular, 0) << found;
    EXPECT_LE(found.refused, 0.05 * found.runs) << found;
}

INSTANTIATE_TEST_SUITE_P(Meshes, AdaptCampaign,
                         ::testing::Values(Generator{"square",
                                                     []() -> std::optional<mesh::QuadMesh> {
                                                         return unstructured(70, 1);
                                                     }},
                                           Generator{"coast", [] { return coast(); }}),
                         [](const auto &info) { return std::string(info.param.name); });

} // namespace
} // namespace alphamst::adapt::samples
