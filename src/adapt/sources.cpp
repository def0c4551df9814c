// Where the fillings of a patch come from, best first, all made only when asked for.
#include <algorithm>
#include <memory>
#include <utility>

#include "adapt/site.h"
#include "patch/patches.h"

namespace alphamst::adapt {

// The inside of the patch and the faces around it, which stay.
struct Site::Inner {
    Inner(const Site &site, patch::Window inside) : window(std::move(inside)) {
        rim.boundary = static_cast<int>(site.window.loop.size());
        rim.vertices = rim.boundary;
        std::vector<int> name(static_cast<std::size_t>(site.old.vertices), -1);
        for (int v = 0; v < rim.boundary; ++v)
            name[static_cast<std::size_t>(v)] = v;
        auto renamed = [&](int v) {
            int &number = name[static_cast<std::size_t>(v)];
            if (number < 0)
                number = rim.vertices++;
            return number;
        };
        for (const int v : window.loop)
            loop.push_back(renamed(site.local_.at(v)));
        for (std::size_t q = 0; q < site.old.quads.size(); ++q) {
            if (std::binary_search(window.faces.begin(), window.faces.end(), site.window.faces[q]))
                continue;
            rim.quads.push_back({});
            for (std::size_t k = 0; k < 4; ++k)
                rim.quads.back()[k] = renamed(site.old.quads[q][k]);
        }
        singular_outside = site.old_singular_all;
        for (const auto *list : {&window.loop, &window.interior})
            for (const int v : *list)
                singular_outside -= site.mesh_.singular(v);
    }
    fill::Filling complete(const fill::Filling &inside) const {
        fill::Filling whole = rim;
        fill::append(whole, inside, loop);
        return whole;
    }

    patch::Window window;
    fill::Filling rim;     // boundary of the patch, kept faces
    std::vector<int> loop; // of the inside, as vertices of rim
    int singular_outside = 0;
};

std::vector<Site::Source> Site::sources() const {
    std::vector<Source> list;
    if (goal_.collapse) {
        list.push_back(collapsed());
    } else if (goal_.keep_quality) {
        // A smallest scaled Jacobian that is already good is seldom reached again next to
        // a boundary that cannot move: there a rim of faces stays.
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

std::optional<Site::Offer> Site::present() const {
    const auto faces = static_cast<std::int64_t>(old.quads.size());
    if (goal_.forbid_old || (!goal_.any_count && goal_.faces != faces))
        return std::nullopt;
    return Offer{faces, old_singular_all, [this] { return Shape{old, old_positions_}; }};
}

bool Site::ragged() const {
    const auto length = static_cast<std::int64_t>(window.loop.size());
    return length * length > 64 * static_cast<std::int64_t>(window.faces.size()) ||
           length * length > 52 * goal_.faces;
}

Site::Source Site::templates(fill::Request request) {
    return [plan = std::make_shared<fill::Plan>(std::move(request))] {
        Group group;
        for (fill::Candidate &candidate : plan->next())
            group.push_back({candidate.faces, candidate.singularities, [make = std::move(candidate.build)] {
                                 return Shape{make(), {}};
                             }});
        return group;
    };
}

Site::Source Site::collapsed() const {
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

Site::Source Site::inner(int layers) const {
    return [this, layers, source = Source()]() mutable {
        if (!source)
            source = start_inner(layers);
        return source();
    };
}

Site::Source Site::start_inner(int layers) const {
    std::vector<int> faces = window.faces;
    for (int layer = 0; layer < layers; ++layer) {
        std::vector<int> rim = layer == 0 ? window.loop : border(faces);
        std::sort(rim.begin(), rim.end());
        std::erase_if(faces, [&](int f) {
            const auto corners = mesh_.corners(f);
            return std::any_of(corners.begin(), corners.end(),
                               [&](int v) { return std::binary_search(rim.begin(), rim.end(), v); });
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
        for (Offer &offer : group) {
            offer.faces += kept;
            offer.singularities += inside->singular_outside;
            offer.build = [inside, make = std::move(offer.build)] {
                return Shape{inside->complete(make().filling), {}};
            };
        }
        return group;
    };
}

std::vector<int> Site::border(const std::vector<int> &faces) const {
    std::vector<int> vertices;
    for (const int f : window.faces)
        if (!std::binary_search(faces.begin(), faces.end(), f))
            for (const int v : mesh_.corners(f))
                vertices.push_back(v);
    return vertices;
}

} // namespace alphamst::adapt
