#include "adapt/schedule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

#include "adapt/expected_gain.h"
#include "adapt/levels.h"
#include "adapt/mend_sizes.h"
#include "adapt/respace.h"
#include "adapt/sweep.h"
#include "reference/sizing_field.h"
#include "reference/statistics.h"
#include "smooth/align.h"
#include "smooth/relax.h"

namespace alphamst::adapt {
namespace {

// Smallest scaled Jacobian that windows keep, by what the mesh has; and smallest shape.
constexpr double best_quality = 0.5, least_quality = 0.3, least_shape = 0.1;
constexpr double poor_price = 3; // quads that may become poor for one singularity less

constexpr std::array<int, 8> sizes = {16, 30, 60, 100, 160, 250, 400, 600};
constexpr double most_misshapen = 100; // poor quads that a better worst one may cost
constexpr int large = 160, large_on_surface = 100;
constexpr int most_of_mesh = 12;    // larger windows than such a part of the mesh hardly ever come right
constexpr int repeats = 3;          // with windows of one size
constexpr int conclusive = 100;     // windows in vain that end the search with larger ones on a surface
constexpr double worthwhile = 0.05; // of the singular vertices; those that save less end the search
constexpr double slack = 0.03;      // of the wanted faces, while singularities come first
constexpr double drift = 90;        // faces, likewise at the end: the count would add what was saved
constexpr double far = 0.1;         // of the wanted faces; fewer that are missing are left to the count
constexpr int more = 2;             // rounds for what the count made singular
constexpr int collapses = 3;        // rounds, with windows of so many faces
constexpr int collapsed_window = 60;
constexpr double collapsed_shape = 0.4; // of the shape that windows keep
constexpr double many = 0.1;            // singular vertices, for each face

constexpr int tries = 4, tries_at_features = 16;
constexpr double good_way = 0.7; // of what was missing, or less, is what shall be left
constexpr int large_on_way = 60;
constexpr std::size_t most_sizes = 3; // of windows, the most promising

// Of the fillings to try that a patch has, a window has so many.
constexpr int window_candidates = 3, patch_candidates = 16;

// A filling that does not come right soon gives way to another window.
Settings hasty(Settings settings) {
    settings.patient = false;
    settings.candidates = std::max(1, settings.candidates * window_candidates / patch_candidates);
    settings.least_area = 0.5;
    settings.smooth_steps = std::min(settings.smooth_steps, 10);
    return settings;
}

// What all but one in a hundred faces of the mesh exceed, and some room to move.
double working_quality(const mesh::QuadMesh &mesh, const reference::Reference &reference) {
    std::vector<double> quality = reference.scaled_jacobians(mesh);
    const auto nth = quality.begin() + static_cast<std::ptrdiff_t>(quality.size() / 100);
    std::nth_element(quality.begin(), nth, quality.end());
    return std::clamp(0.75 * *nth, least_quality, best_quality);
}

// Faces that each face is to become.
std::vector<double> target_counts(const mesh::QuadMesh &mesh,
                                  const std::optional<reference::SizingField> &density, std::int64_t wanted) {
    const auto faces = static_cast<std::size_t>(mesh.n_faces());
    std::vector<int> all(faces);
    std::iota(all.begin(), all.end(), 0);
    std::vector<double> target_count = density ? density->weights(mesh, all) : std::vector<double>(faces, 1);
    const double sum = std::accumulate(target_count.begin(), target_count.end(), 0.0);
    for (double &s : target_count)
        s *= static_cast<double>(wanted) / sum;
    return target_count;
}

class Search {
public:
    Search(mesh::QuadMesh &mesh, reference::Reference &reference, std::int64_t wanted,
           const std::optional<reference::CrossField> &cross_field, const Settings &settings,
           const Progress &progress)
        : mesh_(mesh), reference_(reference), settings_(hasty(settings)), patient_(settings),
          progress_(progress), cross_field_(cross_field),
          sizing_(reference::SizingField::of(mesh, reference, wanted)),
          sweep_(mesh, reference, target_counts(mesh, sizing_, wanted), sizing_, settings_),
          quality_(std::max(working_quality(mesh, reference), settings.min_quality)),
          near_(reference.surface_distance ? reference.surface_distance->tolerance() : 0),
          singular_before_(sweep_.singular()) {
        reference_.cross_field = cross_field_ ? &*cross_field_ : nullptr;
        want_sizes();
    }

    // In the end no more singular vertices than there are now; meanwhile so many times as many.
    void limit(double room) {
        room_ = room;
        sweep_.limit(singular_before_);
    }

    void run(bool exact) {
        respace();
        spread();
        collapse();
        reduce(0);
        if (reference_.surface) {
            mend();
            persist();
        }
        if (cross_field_)
            turn();
        if (exact && count() && !reference_.surface) {
            reduce(60);
            count();
        }
        for (int k = 0; exact && reference_.surface && k < more && rose() && sweep_.missing() == 0; ++k) {
            reduce(60);
            persist();
            count();
        }
        finish();
    }

private:
    void want_sizes() {
        if (!sizing_)
            return;
        reference_.sizes = &*sizing_;
        reference_.face_weight = sizing_->total(mesh_) / static_cast<double>(sweep_.wanted());
    }

    void respace() {
        if (!settings_.edit_boundary || !sizing_ || reference_.surface)
            return;
        want_boundary(mesh_, reference_, *sizing_, sweep_.wanted());
        for (const RespacingPass &pass : respacings(sizing_->wished()))
            if (run(pass_of(pass, wish(pass.shape)), "respace", 0, 0) > 0)
                smooth::relax_by_sizes(mesh_, reference_, sizing_, settings_);
    }

    // Faces go to where a size field wants them, before singularities are saved.
    void spread() {
        if (!sizing_ || !sizing_->wished())
            return;
        for (const int size : {60, 100, 60, 100, 160}) {
            Pass pass;
            pass.purpose = Purpose::spread;
            pass.size = size;
            pass.slack = 0.2;
            pass.shape = wish(1);
            pass.most_added = 8;
            if (run(pass, "spread", 0, 0) > 0)
                smooth::relax_by_sizes(mesh_, reference_, sizing_, settings_);
        }
    }

    // Windows grow; what a filling strains spreads far beyond its window, so all is relaxed between.
    void reduce(int smallest) {
        const double part = 0.8 / static_cast<double>(sizes.size());
        int idle = 0; // sizes in a row that saved little
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            if (sizes[i] < smallest || sizes[i] > largest())
                continue;
            if (is_far())
                approach(sizes[i], part * static_cast<double>(i));
            Pass pass;
            pass.size = sizes[i];
            pass.slack = sizes[i] <= large ? slack : slack * large / (2 * sizes[i]);
            pass.shape = wish(1);
            const int before = sweep_.singular();
            for (int k = 0; k < repeats * std::max(1.0, settings_.effort); ++k)
                if (const int now = sweep_.singular();
                    run(pass, "reduce", part * static_cast<double>(i), part) == 0 ||
                    now - sweep_.singular() < worthwhile / settings_.effort * now)
                    break;
            if (sweep_.singular() < before)
                smooth::relax_by_sizes(mesh_, reference_, sizing_, settings_);
            idle = before - sweep_.singular() < worthwhile / settings_.effort * before ? idle + 1 : 0;
            if (sizes[i] >= large_enough() && idle > 1)
                break;
            if (reference_.surface && sweep_.refilled() == 0 && sweep_.tried() >= conclusive)
                break;
        }
    }

    // Far too many faces of a surface go where they are, and the surface stays covered; singularities are
    // left to the windows that come then, so a mesh that has few of them is spared that.
    void collapse() {
        if (!reference_.surface || sweep_.singular() < many * mesh_.n_faces())
            return;
        for (int k = 0; k < collapses && crowded(); ++k) {
            Pass pass;
            pass.purpose = Purpose::collapse;
            pass.size = collapsed_window;
            pass.slack = far;
            pass.shape = wish(collapsed_shape);
            if (run(pass, "collapse", 0, 0) == 0)
                break;
            smooth::relax_by_sizes(mesh_, reference_, sizing_, settings_);
        }
    }

    // Far from the wanted count every part of the mesh takes its share of the way, and more may be
    // lost where it hardly goes on.
    void approach(int size, double start) {
        if (room_)
            sweep_.limit(static_cast<int>(*room_ * singular_before_));
        for (const Level &level : on_way) {
            const auto before = static_cast<double>(std::abs(sweep_.missing()));
            allow(level);
            Pass pass;
            pass.purpose = Purpose::spread;
            pass.size = std::clamp(size, 30, large_on_way);
            pass.slack = far;
            pass.shape = wish(level.shape);
            pass.most_added = level.added;
            if (run(pass, "approach", start, 0) > 0)
                smooth::relax_by_sizes(mesh_, reference_, sizing_, settings_);
            const auto now = static_cast<double>(std::abs(sweep_.missing()));
            if (now < good_way * before || !is_far())
                break;
        }
        if (room_)
            sweep_.limit(singular_before_);
        allow(levels[0]);
    }

    // Windows just large enough to take up what is missing come first; singularities are added, and
    // quality is lost, only where it cannot be had without.
    // True if it changed anything.
    bool count() {
        const auto missing = sweep_.missing();
        for (const Level &level : levels) {
            if (sweep_.missing() == 0)
                break;
            allow(level);
            std::vector<int> order = {40, 60, 100, 160, 250, 400, 600};
            const bool many = reference_.surface && std::abs(sweep_.missing()) > order[most_sizes - 1];
            const auto rank = [&](int size) {
                return many || size >= 4 * std::abs(sweep_.missing()) ? size : 2000 - size;
            };
            std::sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) < rank(b); });
            std::erase_if(order, [&](int size) { return size > largest(); });
            order.resize(std::min(order.size(), most_sizes));
            for (const int size : order) {
                Pass pass;
                pass.size = size;
                pass.shape = wish(level.shape);
                pass.purpose = Purpose::count;
                pass.most_added = level.added;
                for (int done = 1; done > 0 && sweep_.missing() != 0;)
                    done = run(pass, "count", 0.8, 0.15);
            }
        }
        allow(levels[0]);
        return sweep_.missing() != missing;
    }

    // What is left of bad shapes, most often of the input: around them any filling that is better, the
    // more so the worse they are.
    void mend() {
        const int most = mesh_.curves ? tries_at_features : tries;
        for (const Level &level : mending) {
            allow(level);
            for (const int size : {16, 30, 60}) {
                Pass pass;
                pass.purpose = Purpose::mend;
                pass.size = size;
                pass.most_added = level.added;
                pass.shape = {level.shape * least_quality, 0, most_misshapen};
                for (int k = 0; k < (level.added > 0 ? most : 1); ++k) {
                    run(pass, "mend", 0, 0);
                    if (sweep_.tried() == 0)
                        break;
                }
            }
        }
        allow(levels[0]);
    }

    // Between windows that find none singularities wander, as no more of them, so that others come within
    // reach.
    void persist() {
        ExpectedGain expected_gain(sweep_.singular(), singular_before_, mesh_.n_faces(), largest(),
                                   settings_.effort);
        while (!regular() && expected_gain.worthwhile(sweep_.singular())) {
            ExpectedGain::Search &search = expected_gain.best();
            const int before = sweep_.singular();
            const auto effort = sweep_.effort();
            for (const bool wander : {true, false}) {
                Pass pass;
                pass.purpose = wander ? Purpose::wander : Purpose::fewer_singularities;
                pass.size = wander ? search.wander : search.size;
                pass.slack = std::min(slack, drift / static_cast<double>(sweep_.wanted()));
                pass.shape = wish(1);
                run(pass, "reduce", 0.8, 0);
            }
            auto spent = sweep_.effort() - effort;
            if (spent == 0)
                break; // no window fits around those that are left
            if (sweep_.singular() < before) {
                smooth::relax_by_sizes(mesh_, reference_, sizing_, settings_);
                spent += mesh_.n_faces(); // about what that takes
            }
            expected_gain.learn(search, before - sweep_.singular(), static_cast<double>(spent));
        }
    }

    // Where edges stray from the cross field, singularities move so that they follow it.
    void turn() {
        for (const int size : {60, 100, 160, 60, 100, 160}) {
            Pass pass;
            pass.purpose = Purpose::turn;
            pass.size = size;
            pass.slack = std::min(slack, drift / static_cast<double>(sweep_.wanted()));
            pass.shape = wish(1);
            if (run(pass, "turn", 0.8, 0) > 0)
                smooth::relax_by_sizes(mesh_, reference_, sizing_, settings_);
        }
    }

    // There are more singular vertices than at first.
    bool rose() const { return sweep_.singular() > singular_before_; }

    void finish() {
        tell(0.9, "relax");
        smooth::settle_by_sizes(mesh_, reference_, sizing_, settings_);
        if (reference_.surface)
            smooth::fit_to_surface(mesh_, reference_, sizing_, settings_);
        if (cross_field_) // who asks for the field gets it, at some distance to the surface
            smooth::align_to_field(mesh_, reference_, *cross_field_, settings_);
        mend();
        // Without a field those of a curved mesh are a matter of its curvature, not of a wish.
        const bool asked = sizing_ && (!reference_.surface || sizing_->wished());
        if (asked && mend_sizes(mesh_, reference_, patient_) > 0)
            smooth::settle_by_sizes(mesh_, reference_, sizing_, settings_);
        tell(1, "mend");
    }

    // Windows of this size or more that save little twice end the search. On a small surface larger ones
    // seldom fit a chart.
    int large_enough() const {
        return reference_.surface ? std::clamp(mesh_.n_faces() / 40, large_on_surface, large) : large;
    }

    int largest() const { return std::max(large, mesh_.n_faces() / most_of_mesh); }

    bool regular() const {
        std::map<int, std::int64_t> valences;
        std::int64_t singular = 0;
        reference::count(mesh_, valences, singular);
        return reference::fewest_singular(valences);
    }

    bool is_far() const {
        return static_cast<double>(std::abs(sweep_.missing())) > far * static_cast<double>(sweep_.wanted());
    }

    bool crowded() const {
        return static_cast<double>(mesh_.n_faces()) > collapse_to * static_cast<double>(sweep_.wanted());
    }

    void allow(const Level &level) {
        if (reference_.surface_distance)
            reference_.surface_distance->set_tolerance(level.tolerance * near_);
    }

    refill::ShapeBounds wish(double part) const { return {part * quality_, part * least_shape, poor_price}; }

    void tell(double fraction, const char *stage) { progress_(fraction, stage); }
    int run(const Pass &pass, const char *stage, double start, double part) {
        return sweep_.run(pass, stage, [&](double fraction) { tell(start + part * fraction, stage); });
    }

    mesh::QuadMesh &mesh_;
    reference::Reference &reference_;
    const Settings settings_, patient_; // of windows, of patches
    const Progress &progress_;
    const std::optional<reference::CrossField> &cross_field_;
    const std::optional<reference::SizingField> sizing_;
    Sweep sweep_;
    const double quality_, near_; // near_: usual tolerance of the distance to the surface
    const int singular_before_;
    std::optional<double> room_; // see limit
};

} // namespace

void run_schedule(mesh::QuadMesh &mesh, reference::Reference &reference, const Aim &aim,
                  const std::optional<reference::CrossField> &cross_field, const Settings &settings,
                  const Progress &progress) {
    Search search(mesh, reference, aim.faces, cross_field, settings, progress);
    if (aim.room)
        search.limit(*aim.room);
    search.run(aim.exact);
}

} // namespace alphamst::adapt
