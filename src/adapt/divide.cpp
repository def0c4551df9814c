#include "adapt/divide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "adapt/patches.h"
#include "index.h"
#include "patch/patches.h"
#include "random.h"
#include "reference/region_sizes.h"
#include "reference/statistics.h"

namespace alphamst::adapt {
namespace {

// Of the patch at first, for each part: large ones give few singular vertices, small ones are quickly filled
// and fit where large ones do not. And where the count is still missed, smaller and smaller.
constexpr double faces_of_part = 150;
constexpr double least_parts = 4;
constexpr std::array<double, 2> sizes = {120, 40};
constexpr int tries = 3; // with parts of one size, each time others and fewer of them
// Rounds that bring faces to where they are wanted: what was a border between parts lies within one then.
constexpr int balances = 3;
// Rounds that only save singular vertices.
constexpr int savings = 2;

std::int64_t count_faces(const std::vector<Patch> &parts) {
    std::int64_t sum = 0;
    for (const Patch &part : parts)
        sum += static_cast<std::int64_t>(part.faces.size());
    return sum;
}

// A few that take much may go where many that take a little do not: a square of 2 by 2 faces can have 12, but
// not 8.
void concentrate(std::vector<Patch> &parts, int times, Random &random) {
    random.shuffle(parts);
    const std::size_t fraction = at(times) + 1;
    parts.resize((parts.size() + fraction - 1) / fraction);
}

class Division {
public:
    Division(mesh::QuadMesh &mesh, std::vector<Patch> &patches, std::size_t patch, std::int64_t wanted,
             const Settings &settings, const Progress &progress)
        : mesh_(mesh), patches_(patches), patch_(patch), wanted_(wanted), settings_(settings),
          progress_(progress), random_(settings.seed) {
        if (mesh.field(Entity::vertex, "size") == nullptr) // else that says what is wanted
            want_sizes();
    }

    void want_sizes() {
        std::optional<reference::Boundary> boundary;
        if (settings_.edit_boundary)
            boundary = reference::boundary_of(mesh_, 1);
        sizes_.emplace(mesh_, patches_[patch_].faces, static_cast<double>(wanted_), settings_.transition,
                       boundary ? &*boundary : nullptr);
    }

    void run() {
        const double parts_wanted =
            std::max(least_parts, static_cast<double>(faces().size()) / faces_of_part);
        const auto size = [&] { return static_cast<double>(faces().size()) / parts_wanted; };
        const bool stays = missing() == 0; // then no part changes its number either
        for (int k = 0; k < balances && !stays; ++k) {
            std::vector<Patch> parts = parts_of(size());
            share(parts, weights_of(parts, true), count_faces(parts) + missing());
            refill(parts, Goals::exact);
        }
        for (const double most : sizes)
            for (int k = 0; k < tries && missing() != 0; ++k) {
                std::vector<Patch> parts = parts_of(std::min(most, size()));
                concentrate(parts, k, random_);
                share(parts, weights_of(parts, false), count_faces(parts) + missing());
                refill(parts, most > sizes.back() ? Goals::exact : Goals::nearest);
            }
        for (int k = 0; k < savings + (stays ? balances : 0); ++k) {
            std::vector<Patch> parts = parts_of(size());
            refill(parts, Goals::exact);
        }
    }

    // Of the patch as it is now.
    void tell_before(Outcome &outcome) const {
        tell(outcome);
        outcome.quality_before = outcome.quality_after;
        outcome.aspect_ratio_before = outcome.aspect_ratio_after;
        outcome.valences_before = outcome.valences_after;
        outcome.singular_before = outcome.singular_after;
        if (!sizes_)
            return;
        outcome.size_error_before = outcome.size_error_after;
        outcome.least_area_before = outcome.least_area_after;
        outcome.shortest_edge_before = outcome.shortest_edge_after;
    }

    void tell(Outcome &outcome) const {
        outcome.faces_after = static_cast<std::int64_t>(faces().size());
        outcome.quality_after = reference::least_quality(mesh_, faces());
        outcome.aspect_ratio_after = reference::largest_aspect_ratio(mesh_, faces());
        reference::count(mesh_, faces(), outcome.valences_after, outcome.singular_after);
        std::vector<geometry::Quad> quads;
        if (!sizes_) { // what was known is of other faces
            constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
            reference::tell_sizes_after({unknown, unknown, unknown, {}}, outcome);
            return;
        }
        for (const int f : faces())
            quads.push_back(reference::quad_of(mesh_, f));
        reference::tell_sizes_after(sizes_->error(quads), outcome);
    }

private:
    const std::vector<int> &faces() const { return patches_[patch_].faces; }
    std::int64_t missing() const { return wanted_ - static_cast<std::int64_t>(faces().size()); }

    std::vector<Patch> parts_of(double size) {
        std::vector<char> taken(at(mesh_.n_faces()), 1);
        for (const int f : faces())
            taken[at(f)] = static_cast<char>((mesh_.face_flags[at(f)] & mesh::fixed) != 0);
        std::vector<Patch> parts;
        for (std::vector<int> &faces : patch::clusters(mesh_, size, random_(), taken)) {
            Patch part;
            part.faces = std::move(faces);
            parts.push_back(std::move(part));
        }
        return parts;
    }

    // Faces that are wanted in each; or as many as there are, in proportion.
    std::vector<double> weights_of(const std::vector<Patch> &parts, bool by_sizes) const {
        std::vector<double> weights;
        for (const Patch &part : parts) {
            weights.push_back(static_cast<double>(part.faces.size()));
            if (!sizes_ || !by_sizes)
                continue;
            weights.back() = 0;
            for (const int f : part.faces) {
                const geometry::Quad q = reference::quad_of(mesh_, f);
                weights.back() += geometry::area_vector(q).norm() / sizes_->at(geometry::centre(q));
            }
        }
        return weights;
    }

    enum class Goals { exact, nearest };

    void refill(std::vector<Patch> &parts, Goals goals) {
        Manner manner;
        manner.tolerances = std::span(tolerances).first(1); // there will be other parts
        manner.whole = &patches_;
        manner.sizes = sizes_ ? &*sizes_ : nullptr;
        refill_patches(
            mesh_, parts, settings_, progress_, "divide",
            [goals](const Patch &part) {
                refill::Goal goal = goal_of(part, 1);
                goal.or_nearest = goals == Goals::nearest;
                return goal;
            },
            manner);
    }

    mesh::QuadMesh &mesh_;
    std::vector<Patch> &patches_;
    const std::size_t patch_;
    const std::int64_t wanted_;
    const Settings &settings_;
    const Progress &progress_;
    std::optional<reference::RegionSizes> sizes_;
    Random random_;
};

} // namespace

void refill_in_parts(mesh::QuadMesh &mesh, std::vector<Patch> &patches, std::size_t patch,
                     std::int64_t wanted, const Settings &settings, const Progress &progress,
                     Outcome &outcome) {
    Division division(mesh, patches, patch, wanted, settings, progress);
    division.tell_before(outcome);
    division.run();
    division.tell(outcome);
}

} // namespace alphamst::adapt
