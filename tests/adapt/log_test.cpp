#include "adapt/log.h"

#include <gtest/gtest.h>

#include <locale>
#include <string>
#include <utility>
#include <vector>

#include "mesh/grids.h"

namespace alphamst::adapt {
namespace {

// Settings with somebody who looks, and what is heard.
struct Heard {
    std::vector<std::pair<int, std::string>> lines;
    Settings settings;

    explicit Heard(int level) {
        auto log = std::make_shared<Log>();
        log->level = level;
        log->say = [this](int of, const std::string &text) { lines.emplace_back(of, text); };
        settings.log = log;
    }
    Heard(const Heard &) = delete;
    Heard &operator=(const Heard &) = delete;
};

refill::Proposal refilled() {
    refill::Proposal proposal;
    proposal.outcome.faces_before = 12345;
    proposal.outcome.faces_after = 1234;
    proposal.outcome.singular_before = 7;
    proposal.outcome.singular_after = 5;
    proposal.outcome.quality_after = 0.5;
    proposal.trace.candidates = 1500;
    proposal.trace.refuse(refill::Refused::edge);
    for (int i = 0; i < 2; ++i)
        proposal.trace.refuse(refill::Refused::shape);
    return proposal;
}

void say_all(const Settings &settings) {
    const mesh::QuadMesh mesh = mesh::plane(2, 2).build();
    refill::Place place;
    place.faces = {0, 1};
    log_patch(settings, "adapt", 3, refilled());
    log_window(settings, mesh, "reduce", 4, place, {}, nullptr);
    log_stage(settings, "count", {60, 1000, 3, 12, -2});
}

TEST(Log, SaysNothingBelowTheLevel) {
    say_all({}); // nobody looks
    Heard heard(log_stages - 1);
    say_all(heard.settings);
    EXPECT_TRUE(heard.lines.empty());
}

TEST(Log, SaysStagesAtTheirLevelAndCavitiesAboveIt) {
    Heard stages(log_stages), cavities(log_cavities);
    say_all(stages.settings);
    ASSERT_EQ(stages.lines.size(), 1u);
    EXPECT_EQ(stages.lines[0].first, log_stages);
    say_all(cavities.settings);
    ASSERT_EQ(cavities.lines.size(), 3u);
    EXPECT_EQ(cavities.lines[0].first, log_cavities);
    EXPECT_EQ(cavities.lines[1].first, log_cavities);
    EXPECT_EQ(cavities.lines[2], stages.lines[0]);
}

TEST(Log, TellsWhatBecameOfAPatch) {
    Heard heard(log_cavities);
    refill::Proposal proposal = refilled();
    log_patch(heard.settings, "adapt", 3, proposal);
    EXPECT_EQ(heard.lines.at(0).second,
              "adapt patch 3, 12345 faces, 1500 candidates laid out; refused: 1 double edge, 2 bad shape; "
              "taken: 1234 faces, 7 -> 5 singular, scaled Jacobian 0.5");
    proposal.trace = {};
    proposal.unchanged = true;
    log_patch(heard.settings, "reduce", 0, proposal);
    EXPECT_EQ(heard.lines.at(1).second, "reduce patch 0, 12345 faces, 0 candidates laid out; nothing is "
                                        "better than what is there");
    proposal.outcome.fault = Fault::no_filling;
    proposal.outcome.text = "none was found";
    log_patch(heard.settings, "reduce", 0, proposal);
    EXPECT_EQ(heard.lines.at(2).second,
              "reduce patch 0, 12345 faces, 0 candidates laid out; left: none was found");
}

TEST(Log, TellsWhatBecameOfAWindow) {
    Heard heard(log_cavities);
    const mesh::QuadMesh mesh = mesh::plane(2, 2).build();
    refill::Place place;
    place.faces = {0, 1, 2};
    place.buffer = {3};
    refill::Trace trace;
    trace.candidates = 2;
    trace.refuse(refill::Refused::distance);
    log_window(heard.settings, mesh, "reduce", 5, place, trace, nullptr);
    EXPECT_EQ(heard.lines.at(0).second,
              "reduce window at 2 1 0, 3 faces, 2 candidates laid out; refused: 1 off the surface");
    refill::Replacement taken;
    taken.filling.quads.resize(4);
    for (const auto &[change, text] : {std::pair(-2, "-2"), std::pair(0, "+0"), std::pair(3, "+3")}) {
        taken.singular_change = change;
        log_window(heard.settings, mesh, "mend", -1, place, {}, &taken);
        EXPECT_EQ(heard.lines.back().second,
                  std::string("mend window, 3 faces, 0 candidates laid out; taken: 4 faces, ") + text +
                      " irregular vertices");
    }
}

TEST(Log, TellsWhatCameOfAStage) {
    Heard heard(log_stages);
    log_stage(heard.settings, "count", {60, 1000, 3, 12, -2});
    EXPECT_EQ(heard.lines.at(0).second, "count: windows of 60 faces, 1000 tried, 3 refilled; 12 irregular "
                                        "vertices, -2 faces missing");
}

TEST(Log, TellsWhatStartsCameTo) {
    Heard heard(log_stages), below(log_stages - 1);
    std::vector<Outcome> outcomes(2);
    for (std::size_t k = 0; k < 2; ++k) {
        outcomes[k].faces_after = 1234;
        outcomes[k].singular_after = static_cast<std::int64_t>(20 - 7 * k);
        outcomes[k].quality_after = outcomes[k].size_error_after = 0.5;
    }
    log_starts(heard.settings, outcomes, 1);
    log_starts(below.settings, outcomes, 1);
    ASSERT_EQ(heard.lines.size(), 2u);
    EXPECT_TRUE(below.lines.empty());
    EXPECT_EQ(heard.lines[0].second, "start 0: 1234 faces, 20 singular, scaled Jacobian 0.5, size error 0.5");
    EXPECT_EQ(heard.lines[1].second,
              "start 1: 1234 faces, 13 singular, scaled Jacobian 0.5, size error 0.5, kept");
}

// A host program may group digits, and have a comma before the decimals.
struct Grouping : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(Log, WritesNumbersTheSameInEveryLocale) {
    Heard usual(log_cavities), grouped(log_cavities);
    say_all(usual.settings);
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Grouping));
    say_all(grouped.settings);
    std::locale::global(before);
    EXPECT_EQ(grouped.lines, usual.lines);
}

} // namespace
} // namespace alphamst::adapt
