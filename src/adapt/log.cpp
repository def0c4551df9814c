#include "adapt/log.h"

#include <locale>
#include <sstream>
#include <string>

namespace alphamst::adapt {
namespace {

// Numbers look the same whatever the host program's locale is.
struct Line : std::ostringstream {
    Line() { imbue(std::locale::classic()); }
};

// "5 candidates: 2 bad shape, 3 double edge"
std::string candidates_of(const refill::Trace &trace) {
    Line text;
    text << trace.candidates << " candidates laid out";
    const char *separator = "; refused: ";
    for (std::size_t i = 0; i < trace.refused.size(); ++i)
        if (trace.refused[i] > 0) {
            text << separator << trace.refused[i] << ' ' << refill::reason_names[i];
            separator = ", ";
        }
    return text.str();
}

} // namespace

void log_patch(const Settings &settings, const char *stage, std::size_t patch,
               const refill::Proposal &proposal) {
    if (!settings.tells(log_cavities))
        return;
    const Outcome &outcome = proposal.outcome;
    Line text;
    text << stage << " patch " << patch << ", " << outcome.faces_before << " faces, "
         << candidates_of(proposal.trace);
    if (outcome.fault)
        text << "; left: " << outcome.text;
    else if (proposal.unchanged)
        text << "; nothing is better than what is there";
    else
        text << "; taken: " << outcome.faces_after << " faces, " << outcome.singular_before << " -> "
             << outcome.singular_after << " singular, scaled Jacobian " << outcome.quality_after;
    settings.log->say(log_cavities, text.str());
}

void log_window(const Settings &settings, const mesh::QuadMesh &mesh, const char *stage, int seed,
                const refill::Place &place, const refill::Trace &trace, const refill::Replacement *taken) {
    if (!settings.tells(log_cavities))
        return;
    Line text;
    text << stage << " window";
    if (seed >= 0)
        text << " at " << mesh.point(seed);
    text << ", " << place.faces.size() << " faces, " << candidates_of(trace);
    if (taken != nullptr)
        text << "; taken: " << taken->filling.quads.size() << " faces, " << std::showpos
             << taken->singular_change << " irregular vertices";
    settings.log->say(log_cavities, text.str());
}

void log_stage(const Settings &settings, const char *stage, const StageCount &count) {
    if (!settings.tells(log_stages))
        return;
    Line text;
    text << stage << ": windows of " << count.size << " faces, " << count.windows << " tried, "
         << count.refilled << " refilled; " << count.irregular << " irregular vertices, " << count.missing
         << " faces missing";
    settings.log->say(log_stages, text.str());
}

void log_starts(const Settings &settings, const std::vector<Outcome> &outcomes, std::size_t kept) {
    if (!settings.tells(log_stages))
        return;
    for (std::size_t k = 0; k < outcomes.size(); ++k) {
        Line text;
        text << "start " << k << ": " << outcomes[k].faces_after << " faces, " << outcomes[k].singular_after
             << " singular, scaled Jacobian " << outcomes[k].quality_after << ", size error "
             << outcomes[k].size_error_after << (k == kept ? ", kept" : "");
        settings.log->say(log_stages, text.str());
    }
}

} // namespace alphamst::adapt
