#include "refill/window.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/cross_field.h"
#include "reference/locate.h"
#include "reference/size_error.h"
#include "refill/respacing.h"

namespace alphamst::refill {
namespace {

constexpr double least_gain = 0.05; // of the scaled Jacobian
// Degrees: what a window that turns gains at least. Fillings that are compared for that.
constexpr double least_turn = 2, right_angle = 90;
constexpr int most_compared = 4;
constexpr int most_spacings = 2; // of the boundary within a window, but for the present one
constexpr int most_weighed = 8;  // within a window densities hardly differ as much as areas in a web do

std::vector<geometry::Quad> quads_of(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
    std::vector<geometry::Quad> quads;
    for (const int f : faces)
        quads.push_back(reference::quad_of(mesh, f));
    return quads;
}

// Takes the candidates of a window in their order.
class Search {
public:
    Search(const mesh::QuadMesh &mesh, const Place &place, const Cavity &cavity, const Goal &goal,
           const ShapeBounds &wanted, const Settings &settings, Evaluator &evaluator, Trace &trace)
        : mesh_(mesh), cavity_(cavity), goal_(goal), wanted_(wanted), settings_(settings),
          evaluator_(evaluator), trace_(trace), cross_field_(cavity.reference().cross_field) {
        const ShapeBounds &before = evaluator.before();
        // Where the old filling is no answer, it is to be bettered.
        const double gain = goal.forbid_old ? least_gain : 0;
        bounds_ = {std::min(wanted.scaled_jacobian, before.scaled_jacobian + gain),
                   std::min(wanted.shape, before.shape), 0, before.inverted};
        if (goal.forbid_old)
            evaluator.demand_gain();
        if (cross_field_ != nullptr && goal.turn)
            alignment_error_ = cross_field_->alignment_error(quads_of(mesh, place.faces)) - least_turn;
    }

    std::optional<Replacement> run() {
        for (const Cavity::Generator &generator : cavity_.generators())
            for (Cavity::Group group = generator(); !group.empty(); group = generator())
                for (const Cavity::Candidate &candidate : group)
                    if (try_one(candidate.build()))
                        return std::move(best_);
        return std::move(best_);
    }

private:
    // Whether the search is over.
    bool try_one(const PlacedFilling &shape) {
        const auto faces = static_cast<std::int64_t>(shape.filling.quads.size());
        const int change = cavity_.singular_all(shape.filling) - cavity_.old_singular_all;
        if (best_ && change > best_->singular_change)
            return true;
        if (change > goal_.most_added || (!goal_.any_count && faces != goal_.faces))
            return trace_.refuse(Refused::numbers);
        if (!evaluator_.fits(shape.filling))
            return false;
        // To be rid of an inverted quad is worth as much as to be rid of a singularity.
        const ShapeBounds &before = evaluator_.before();
        const int gain = std::max(0, -change) + std::max(before.inverted, evaluator_.inverted_at_features());
        bounds_.poor = before.poor + gain * wanted_.poor;
        auto evaluation = evaluator_.evaluate(shape, bounds_);
        if (evaluation && shrinks(evaluation->replacement)) {
            trace_.refuse(Refused::size);
            evaluation.reset();
        }
        if (!evaluation)
            return ++tried_ >= settings_.candidates;
        if (cross_field_ == nullptr || evaluation->replacement.alignment_error < alignment_error_) {
            alignment_error_ = evaluation->replacement.alignment_error;
            best_ = std::move(evaluation->replacement);
        }
        return cross_field_ == nullptr || ++compared_ >= most_compared;
    }

    // Some face becomes far smaller than is wanted, and smaller than any is now.
    bool shrinks(const Replacement &replacement) const {
        const reference::Reference &reference = cavity_.reference();
        if (reference.sizes == nullptr || cavity_.curved())
            return false;
        std::vector<Eigen::Vector3d> points;
        points = loop_points(mesh_, replacement.window);
        for (const OpenMesh::Vec3d &p : replacement.points)
            points.emplace_back(p[0], p[1], p[2]);
        std::vector<geometry::Quad> quads;
        for (const auto &q : replacement.filling.quads)
            quads.push_back({points[at(q[0])], points[at(q[1])], points[at(q[2])], points[at(q[3])]});
        const double least = least_weight(quads);
        return least < settings_.least_size * reference.face_weight &&
               least < least_weight(quads_of(mesh_, replacement.window.faces));
    }

    // Of the quads that are smallest by area: densities take time.
    double least_weight(std::vector<geometry::Quad> quads) const {
        if (quads.size() > most_weighed) {
            const auto area = [](const geometry::Quad &quad) { return geometry::area_vector(quad).norm(); };
            std::ranges::nth_element(quads, quads.begin() + most_weighed, {}, area);
            quads.resize(most_weighed);
        }
        double least = std::numeric_limits<double>::infinity();
        for (const geometry::Quad &quad : quads)
            least = std::min(least, cavity_.reference().sizes->weight(quad));
        return least;
    }

    const mesh::QuadMesh &mesh_;
    const Cavity &cavity_;
    const Goal &goal_;
    const ShapeBounds &wanted_;
    const Settings &settings_;
    Evaluator &evaluator_;
    Trace &trace_;
    const reference::CrossField *cross_field_;
    ShapeBounds bounds_;
    double alignment_error_ = right_angle; // to be bettered
    std::optional<Replacement> best_;
    int tried_ = 0, compared_ = 0;
};

// With the boundary that is there, and, where that may change, with others.
struct WindowRefill {
    const mesh::QuadMesh &mesh;
    const Place &place;
    const ShapeBounds &wanted;
    const Settings &settings;
    const reference::Reference &reference;
    Trace &trace;

    std::optional<Replacement> run(const Goal &goal) const {
        Patch region;
        region.faces = place.faces;
        const Cavity cavity(mesh, region, goal, settings, reference);
        if (!reference.boundary || cavity.curved())
            return search(cavity, goal);
        const Respacing respacing(mesh, cavity.window, *reference.boundary, reference.edge_length,
                                  settings.tolerance);
        if (goal.respace) {
            for (const Respacing::Counts &counts : respacing.towards())
                if (auto found = search_respaced(region, respacing.window(counts, true), goal))
                    return found;
            return std::nullopt;
        }
        std::optional<Replacement> best = search(cavity, goal);
        const bool wished = reference.sizes != nullptr && reference.sizes->wished();
        Goal better = goal;
        int tried = 0;
        for (const Respacing::Counts &counts : respacing.near(wished)) {
            auto window = respacing.window(counts, false);
            if (!window)
                continue;
            if (best)
                better.most_added = best->singular_change - 1;
            if (auto found = search_respaced(region, std::move(window), better))
                best = std::move(found);
            if (++tried == most_spacings)
                break;
        }
        return best;
    }

    std::optional<Replacement> search_respaced(const Patch &region, std::optional<patch::Window> respaced,
                                               const Goal &goal) const {
        if (!respaced)
            return std::nullopt;
        Cavity cavity(mesh, region, goal, settings, reference);
        cavity.respace(std::move(*respaced));
        return search(cavity, goal);
    }

    std::optional<Replacement> search(const Cavity &cavity, const Goal &goal) const {
        const BufferRing buffer(mesh, cavity, place.buffer, false);
        Evaluator evaluator(mesh, cavity, buffer, settings, trace);
        return Search(mesh, place, cavity, goal, wanted, settings, evaluator, trace).run();
    }
};

} // namespace

std::optional<Replacement> refill_window(const mesh::QuadMesh &mesh, const Place &place, const Goal &goal,
                                         const ShapeBounds &wanted, const Settings &settings,
                                         const reference::Reference &reference, Trace &trace) {
    try {
        return WindowRefill{mesh, place, wanted, settings, reference, trace}.run(goal);
    } catch (const Refusal &) {
    }
    return std::nullopt;
}

} // namespace alphamst::refill
