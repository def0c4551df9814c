// Whole meshes: a start by chords, then the stages; once or twice more with less room where there would be
// more singular vertices than before.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <tuple>

#include "adapt/chord_prepass.h"
#include "adapt/columns.h"
#include "adapt/divide.h"
#include "adapt/layers.h"
#include "adapt/off_size.h"
#include "adapt/pieces.h"
#include "adapt/schedule.h"
#include "adapt/starts.h"
#include "index.h"
#include "mesh/components.h"
#include "reference/feature_line.h"
#include "reference/size_error.h"
#include "reference/statistics.h"
#include "refill/choice.h"
#include "refill/patch.h"

namespace alphamst::adapt {
namespace {

// Singular vertices that there may be on the way, for each at first, where a first try left more.
constexpr double some_room = 1.5, no_room = 1;

// Singular vertices that windows are not asked to save: a square whose border stays needs four to get other
// sizes inside; and one in so many faces.
constexpr std::int64_t most_singular = 4, seldom = 100;

// In singular vertices, of twice the largest aspect ratio, where the boundary may change: rows can leave at
// the boundary then, and of a wall that is refined in one place few singular vertices leave a bundle of long
// faces right across the mesh, of the right areas.
constexpr double price_of_aspect = 6;

bool rose(const Outcome &outcome) { return outcome.singular_after > outcome.singular_before; }

std::int64_t missing_of(const Outcome &outcome, bool exact) {
    return exact ? std::abs(outcome.faces_after - outcome.faces_wanted) : 0;
}

// The number of faces comes first, where it is wanted; where it cannot be had, no singular vertices are made
// for it; then what choices of fillings weigh.
Price price_of(const Outcome &outcome, bool exact, bool edit_boundary) {
    const std::int64_t missing = missing_of(outcome, exact);
    const double aspect = edit_boundary ? price_of_aspect * std::log2(outcome.aspect_ratio_after) : 0;
    return {missing != 0, missing != 0 && rose(outcome), missing, refill::price_of(outcome) + aspect};
}

class Rework {
public:
    Rework(mesh::QuadMesh &mesh, double alpha, bool exact, const Settings &settings, const Progress &progress)
        : mesh_(mesh), exact_(exact), settings_(settings),
          // Stages come more than once; what was told does not fall.
          tell_([&progress, told = 0.0](double fraction, const char *stage) mutable {
              told = std::max(told, fraction);
              progress(told, stage);
          }) {
        begin_.faces_before = begin_.faces_after = mesh.n_faces();
        begin_.faces_wanted = refill::wanted_faces(alpha, at(mesh.n_faces()));
    }

    Outcome run() {
        const auto start = std::chrono::steady_clock::now();
        reference::straighten(mesh_);
        std::optional<mesh::QuadMesh> before;
        if (may_stay())
            before = mesh_;
        Outcome outcome = mesh_.n_faces() == 0 ? begin_ : search_around_layers();
        if (before && !gained(outcome)) {
            mesh_ = std::move(*before);
            outcome = begin_;
            outcome.singular_after = begin_.singular_before;
            outcome.valences_after = begin_.valences_before;
            outcome.quality_after = begin_.quality_before;
        }
        outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return outcome;
    }

private:
    // The mesh has its count, and nothing is said of sizes and directions that it may not have.
    bool may_stay() const {
        return begin_.faces_wanted == begin_.faces_before && !settings_.align &&
               mesh_.field(Entity::vertex, "size") == nullptr;
    }

    // Else it stays bit for bit: who calls again gets what is there.
    bool gained(const Outcome &of) const {
        // Of the smallest scaled Jacobian: less is what smoothing adds each time.
        constexpr double least_gain = 0.1;
        return missing(of) == 0 && (of.singular_after < begin_.singular_before ||
                                    of.quality_after >= begin_.quality_before + least_gain);
    }

    void note_begin() {
        reference::count(mesh_, begin_.valences_before, begin_.singular_before);
        begin_.quality_before = reference::least_quality(mesh_);
        begin_.aspect_ratio_before = begin_.aspect_ratio_after = reference::largest_aspect_ratio(mesh_);
        // The reference gives a curved mesh its surface.
        sizes_.emplace(mesh_, reference::reference_of(mesh_), begin_.faces_wanted);
        reference::tell_sizes_before(sizes_->error(mesh_), begin_);
    }

    // Boundary layers stay as they are, unless the mesh cannot have its count so.
    Outcome search_around_layers() {
        note_begin();
        if (mesh_.dim() != 2 || mesh_.field(Entity::vertex, "size") != nullptr)
            return search();
        if (settings_.edit_boundary && exact_ && adapt_columns(mesh_, begin_.faces_wanted, settings_))
            if (const Outcome outcome = outcome_of(mesh_); missing(outcome) == 0) {
                tell_(1, "columns");
                return outcome;
            }
        if (hold_layers(mesh_, begin_.faces_wanted) == 0)
            return search();
        mesh::QuadMesh begun = mesh_;
        Outcome outcome = search();
        release_layers(mesh_);
        if (missing(outcome) == 0)
            return outcome;
        release_layers(begun);
        std::swap(mesh_, begun);
        const Outcome without = search();
        if (rank(without) < rank(outcome))
            return without;
        mesh_ = std::move(begun);
        return outcome;
    }

    Outcome search() {
        if (settings_.align && mesh_.surface)
            cross_field_.emplace(mesh_);
        chord_prepass(mesh_, begin_.faces_wanted, settings_, tell_);
        if (!is_small(mesh_))
            return by_windows();
        mesh::QuadMesh other = mesh_;
        bool suffices = false;
        const std::optional<Outcome> of_pieces = by_pieces(suffices);
        if (suffices)
            return *of_pieces;
        if (of_pieces)
            std::swap(mesh_, other);
        const Outcome of_windows = by_windows();
        if (!of_pieces || price(of_windows) <= price(*of_pieces))
            return of_windows;
        std::swap(mesh_, other);
        return *of_pieces;
    }

    // Nothing else is tried. Where the boundary changes as well, few singular vertices say less of the rest.
    bool does(const Outcome &outcome, std::int64_t few) const {
        if (missing(outcome) != 0 || outcome.singular_after > few)
            return false;
        return !settings_.edit_boundary ||
               (mesh_.field(Entity::vertex, "size") == nullptr &&
                outcome.quality_after >= std::min(refill::enough, outcome.quality_before));
    }

    // Of small meshes, with what windows then gain.
    std::optional<Outcome> by_pieces(bool &suffices) {
        const std::optional<std::size_t> pieces = refill_pieces(
            mesh_, begin_.faces_wanted, settings_, [this](double, const char *stage) { tell_(0, stage); });
        if (!pieces)
            return std::nullopt;
        Outcome outcome = outcome_of(mesh_);
        const std::int64_t few =
            most_singular * static_cast<std::int64_t>(*pieces) + begin_.faces_wanted / seldom;
        suffices = does(outcome, few);
        if (suffices) {
            tell_(1, "pieces");
            return outcome;
        }
        mesh::QuadMesh tried = mesh_;
        const Outcome result = attempt(tried, std::nullopt);
        if (price(result) < price(outcome)) {
            outcome = result;
            mesh_ = std::move(tried);
        }
        suffices = does(outcome, std::max(begin_.singular_before, few));
        return outcome;
    }

    Outcome by_windows() {
        // Sizes that are asked for need singular vertices, and in a plane the boundary does.
        std::optional<mesh::QuadMesh> begun;
        if (mesh_.surface && mesh_.dim() == 3 && mesh_.field(Entity::vertex, "size") == nullptr)
            begun = mesh_;
        Outcome outcome = attempt(mesh_, std::nullopt);
        std::string limit;
        for (const double room : {some_room, no_room}) {
            if (!begun || !rose(outcome) || (room == no_room && missing(outcome) == 0))
                break;
            mesh::QuadMesh tried = *begun;
            const Outcome result = attempt(tried, room);
            if (rank(result) < rank(outcome)) {
                outcome = result;
                mesh_ = std::move(tried);
                limit = " that would not leave more singular vertices than there were";
                if (mesh_.curves && !settings_.edit_boundary)
                    limit += ", features having all their vertices but where they are straight";
            }
        }
        if (missing(outcome) != 0)
            by_regions(outcome);
        if (missing(outcome) != 0)
            outcome.text = "the mesh has " + std::to_string(outcome.faces_after) + " faces where " +
                           std::to_string(outcome.faces_wanted) + " were wanted; " + why_missing(limit);
        return outcome;
    }

    std::string why_missing(const std::string &limit) const {
        if (const int lone = mesh::count_lone_faces(mesh_); lone > 1 && lone == mesh_.n_faces())
            return std::to_string(lone) +
                   " components of one face, whose four edges are boundary and stay, have no room for "
                   "others; "
                   "if faces lie side by side, make one vertex of those at the same place (weld them) first";
        return "no valid filling with more or fewer was found" + limit +
               "; the boundary stays, but with AMST_OPT_STRATEGY 1 and AMST_OPT_EDIT_BOUNDARY 1 chords may "
               "end "
               "on it";
    }

    // From what windows came to.
    void by_regions(Outcome &outcome) {
        mesh::QuadMesh tried = mesh_;
        std::vector<Patch> all(1);
        all[0].faces.resize(at(tried.n_faces()));
        std::iota(all[0].faces.begin(), all[0].faces.end(), 0);
        Outcome of_parts;
        refill_in_parts(
            tried, all, 0, begin_.faces_wanted, settings_,
            [this](double, const char *stage) { tell_(0.9, stage); }, of_parts);
        const Outcome result = outcome_of(tried);
        if (rank(result) < rank(outcome)) {
            outcome = result;
            mesh_ = std::move(tried);
        }
    }

    Outcome outcome_of(mesh::QuadMesh &tried) {
        Outcome result = begin_;
        result.faces_after = tried.n_faces();
        reference::count(tried, result.valences_after, result.singular_after);
        result.quality_after = reference::least_quality(tried);
        result.aspect_ratio_after = reference::largest_aspect_ratio(tried);
        reference::tell_sizes_after(sizes_->error(tried), result);
        return result;
    }

    Outcome attempt(mesh::QuadMesh &tried, std::optional<double> room) {
        reference::Reference reference = reference::reference_of(tried);
        if (reference.surface)
            reference.surface_distance = reference::surface_distance_of(
                tried, *reference.surface, begin_.faces_wanted, settings_.tolerance);
        run_schedule(tried, reference, {begin_.faces_wanted, exact_, room}, cross_field_, settings_, tell_);
        return outcome_of(tried);
    }

    std::int64_t missing(const Outcome &of) const { return missing_of(of, exact_); }

    // As price, but no singular vertices are made for anything else.
    std::tuple<bool, bool, std::int64_t, std::int64_t> rank(const Outcome &of) const {
        return {missing(of) != 0, rose(of), missing(of), of.singular_after};
    }

    Price price(const Outcome &of) const { return price_of(of, exact_, settings_.edit_boundary); }

    mesh::QuadMesh &mesh_;
    const bool exact_;
    const Settings &settings_;
    const Progress tell_;
    std::optional<reference::CrossField> cross_field_;
    std::optional<reference::WholeSizes> sizes_; // that the mesh at first is wanted to get
    Outcome begin_;                              // what there was
};

Outcome rework(mesh::QuadMesh &mesh, double alpha, bool exact, const Settings &settings,
               const Progress &progress) {
    return best_of_starts(
        mesh, settings, progress,
        [&](mesh::QuadMesh &of_start, const Settings &settings_of_start, const Progress &progress_of_start) {
            return Rework(of_start, alpha, exact, settings_of_start, progress_of_start).run();
        },
        [&](const Outcome &outcome) { return price_of(outcome, exact, settings.edit_boundary); });
}

} // namespace

Outcome adapt_whole(mesh::QuadMesh &mesh, double alpha, const Settings &settings, const Progress &progress) {
    if (goes_by_band(mesh, settings))
        return adapt_off_size(mesh, alpha, settings, progress);
    return rework(mesh, alpha, true, settings, progress);
}

Outcome reduce_whole(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress) {
    return rework(mesh, 1, false, settings, progress);
}

} // namespace alphamst::adapt
