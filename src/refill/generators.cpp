// Where the fillings of a patch come from, best first, all made only when asked for.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "patch/patches.h"
#include "refill/cavity.h"

namespace alphamst::refill {

// The inside of the patch and the faces around it, which stay.
struct Cavity::Inner {
    Inner(const Cavity &cavity, patch::Window inside) : window(std::move(inside)) {
        buffer.boundary = static_cast<int>(cavity.window.loop.size());
        buffer.vertices = buffer.boundary;
        std::vector<int> name(static_cast<std::size_t>(cavity.old.vertices), -1);
        for (int v = 0; v < buffer.boundary; ++v)
            name[static_cast<std::size_t>(v)] = v;
        auto renamed = [&](int v) {
            int &number = name[static_cast<std::size_t>(v)];
            if (number < 0)
                number = buffer.vertices++;
            return number;
        };
        for (const int v : window.loop)
            loop.push_back(renamed(cavity.local_.at(v)));
        for (std::size_t q = 0; q < cavity.old.quads.size(); ++q) {
            if (std::binary_search(window.faces.begin(), window.faces.end(), cavity.window.faces[q]))
                continue;
            buffer.quads.push_back({});
            for (std::size_t k = 0; k < 4; ++k)
                buffer.quads.back()[k] = renamed(cavity.old.quads[q][k]);
        }
        singular_outside = cavity.old_singular_all;
        for (const auto *list : {&window.loop, &window.interior})
            for (const int v : *list)
                singular_outside -= cavity.mesh_.singular(v);
    }
    fill::Filling complete(const fill::Filling &inside) const {
        fill::Filling whole = buffer;
        fill::append(whole, inside, loop);
        return whole;
    }

    patch::Window window;
    fill::Filling buffer;  // boundary of the patch, kept faces
    std::vector<int> loop; // of the inside, as vertices of buffer
    int singular_outside = 0;
};

std::vector<Cavity::Generator> Cavity::generators() const {
    std::vector<Generator> list;
    if (respaced()) {
        list.push_back(templates(request()));
    } else if (goal_.collapse) {
        list.push_back(collapsed());
    } else if (goal_.keep_quality) {
        // A smallest scaled Jacobian that is already good is seldom reached again next to
        // a boundary that cannot move: there a buffer of faces stays.
        constexpr double good = 0.6;
        if (old_quality < good)
            list.push_back(templates(request()));
        list.push_back(inner(1));
        list.push_back(inner(2));
    } else if (goal_.any_count) {
        list.push_back(templates(request()));
    } else {
        const bool late = ragged(); // templates seldom follow a ragged boundary
        if (!late)
            list.push_back(templates(request()));
        list.push_back(inner(1));
        list.push_back(collapsed());
        if (late)
            list.push_back(templates(request()));
        fill::Request near = request();
        near.tolerance = 2;
        list.push_back(templates(std::move(near)));
    }
    return list;
}

// Where the wanted number is out of reach, what quads of the present filling can collapse to tells how far
// the boundary allows to go.
std::vector<std::int64_t> Cavity::nearest_counts() const {
    // Of the way back; a few, as each takes as long as the wanted count did.
    constexpr double parts[] = {0, 0.125, 0.25, 0.5};
    const auto now = static_cast<std::int64_t>(old.quads.size());
    std::int64_t first = goal_.faces;
    if (first < now)
        if (const auto coarse = coarsen_towards(request(), {old, old_positions_}, settings_.seed))
            first = static_cast<std::int64_t>(coarse->shape.filling.quads.size());
    std::vector<std::int64_t> counts;
    for (const double part : parts) {
        const std::int64_t count = first + std::llround(part * static_cast<double>(now - first));
        if (count != goal_.faces && count != now && (counts.empty() || count != counts.back()))
            counts.push_back(count);
    }
    return counts;
}

std::optional<Cavity::Candidate> Cavity::present() const {
    const auto faces = static_cast<std::int64_t>(old.quads.size());
    if (respaced() || goal_.forbid_old || (!goal_.any_count && goal_.faces != faces))
        return std::nullopt;
    return Candidate{faces, old_singular_all, [this] { return PlacedFilling{old, old_positions_}; }};
}

bool Cavity::ragged() const {
    const auto length = static_cast<std::int64_t>(window.loop.size());
    return length * length > 64 * static_cast<std::int64_t>(window.faces.size()) ||
           length * length > 52 * goal_.faces;
}

Cavity::Generator Cavity::templates(fill::Request request) {
    return [plan = std::make_shared<fill::Plan>(std::move(request))] {
        Group group;
        for (fill::Candidate &candidate : plan->next())
            group.push_back({candidate.faces, candidate.singularities, [make = std::move(candidate.build)] {
                                 return PlacedFilling{make(), {}};
                             }});
        return group;
    };
}

Cavity::Generator Cavity::collapsed() const {
    return [this, round = std::uint64_t{0}]() mutable {
        Group group;
        for (; group.empty() && round < 8 && goal_.faces < static_cast<std::int64_t>(old.quads.size());
             ++round)
            if (auto coarse = coarsen(request(), {old, old_positions_}, settings_.seed + 1000003 * round))
                group.push_back({goal_.faces, coarse->singularities,
                                 [shape = std::move(coarse->shape)] { return shape; }});
        return group;
    };
}

Cavity::Generator Cavity::inner(int layers) const {
    return [this, layers, generator = Generator()]() mutable {
        if (!generator)
            generator = start_inner(layers);
        return generator();
    };
}

Cavity::Generator Cavity::start_inner(int layers) const {
    std::vector<int> faces = window.faces;
    for (int layer = 0; layer < layers; ++layer) {
        std::vector<int> buffer = layer == 0 ? window.loop : border(faces);
        std::sort(buffer.begin(), buffer.end());
        std::erase_if(faces, [&](int f) {
            const auto corners = mesh_.corners(f);
            return std::any_of(corners.begin(), corners.end(),
                               [&](int v) { return std::binary_search(buffer.begin(), buffer.end(), v); });
        });
    }
    const std::vector<char> none(static_cast<std::size_t>(mesh_.n_faces()), 0);
    faces = patch::repair(mesh_, std::move(faces), none);
    const auto kept = static_cast<std::int64_t>(window.faces.size() - faces.size());
    if (faces.size() < 4 || goal_.faces <= kept)
        return [] { return Group{}; };
    const auto inside = std::make_shared<const Inner>(*this, patch::make_window(mesh_, faces));
    fill::Request request = this->request();
    request.word = inside->window.wanted;
    request.regular.clear();
    for (const int outside : inside->window.outside)
        request.regular.push_back(4 - outside);
    request.angles.clear(); // its boundary can move
    request.faces = goal_.faces - kept;
    request.fewer_than -= inside->singular_outside;
    return [inside, kept, next = templates(std::move(request))] {
        Group group = next();
        for (Candidate &candidate : group) {
            candidate.faces += kept;
            candidate.singularities += inside->singular_outside;
            candidate.build = [inside, make = std::move(candidate.build)] {
                return PlacedFilling{inside->complete(make().filling), {}};
            };
        }
        return group;
    };
}

std::vector<int> Cavity::border(const std::vector<int> &faces) const {
    std::vector<int> vertices;
    for (const int f : window.faces)
        if (!std::binary_search(faces.begin(), faces.end(), f))
            for (const int v : mesh_.corners(f))
                vertices.push_back(v);
    return vertices;
}

} // namespace alphamst::refill
