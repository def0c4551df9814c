// candidates MESH X Y [Z] FACES [ALPHA] OUT.svg
//
// For developers: a picture of the fillings that a window of about FACES faces around the vertex nearest to
// the point is offered, in their order, and of what became of each. With ALPHA they are to have round(ALPHA *
// faces) faces, without it any number. A curved mesh needs Z, a plane one has none. Singular vertices: of
// valence 3 blue, of 5 red, others purple.
#include <cmath>
#include <cstdio>
#include <sstream>

#include "geometry/embed.h"
#include "index.h"
#include "io/arrays.h"
#include "io/file.h"
#include "io/number.h"
#include "patch/grow.h"
#include "quality/metric.h"
#include "reference/reference.h"
#include "refill/evaluate.h"

using namespace alphamst;

namespace {

constexpr std::size_t most_candidates = 24, columns = 5;
constexpr int buffer_layers = 2;
constexpr double side = 260, caption = 40, gap = 20;                     // of a picture
constexpr double least_quality = 0.3, least_shape = 0.1, poor_price = 3; // as adapt/schedule.cpp has them

struct Drawn {
    fill::Filling filling;
    std::vector<Eigen::Vector3d> points; // [vertex]
    std::string title, verdict;
    bool taken;
};

Eigen::Vector3d vector(const OpenMesh::Vec3d &p) { return {p[0], p[1], p[2]}; }

mesh::QuadMesh read_mesh(const std::string &path) {
    const io::Arrays arrays = io::read(path);
    mesh::QuadMesh mesh = mesh::QuadMesh::build(arrays.dim, arrays.points, arrays.faces);
    mesh.face_marker = arrays.face_marker;
    mesh.edge_marker.resize(at(mesh.n_edges()));
    for (const auto &[vertices, marker] : arrays.marked_edges)
        if (const auto [v, w] = std::minmax(vertices[0], vertices[1]); v >= 0 && w < mesh.n_vertices())
            if (const int edge = mesh.find_edge(v, w); edge >= 0)
                mesh.edge_marker[at(edge)] = marker;
    return mesh;
}

int nearest(const mesh::QuadMesh &mesh, const Eigen::Vector3d &point) {
    int best = mesh.corners(0)[0];
    const auto distance = [&](int v) { return (vector(mesh.point(v)) - point).norm(); };
    for (const auto &corners : mesh.faces())
        for (const int v : corners)
            best = distance(v) < distance(best) ? v : best;
    return best;
}

// The candidates of one cavity and what becomes of them.
class Candidates {
public:
    Candidates(const mesh::QuadMesh &mesh, const refill::Cavity &cavity, const refill::BufferRing &buffer,
               const Settings &settings)
        : mesh_(mesh), cavity_(cavity), evaluator_(mesh, cavity, buffer, settings, trace_) {}

    std::vector<Drawn> draw() {
        std::vector<Drawn> all{{cavity_.old, points_of(cavity_.window.loop), "", "", true}};
        for (const Eigen::Vector3d &p : points_of(cavity_.window.interior))
            all[0].points.push_back(p);
        describe("now", all[0]);
        for (const refill::Cavity::Generator &generator : cavity_.generators())
            for (refill::Cavity::Group group = generator(); !group.empty(); group = generator())
                for (const refill::Cavity::Candidate &candidate : group) {
                    if (all.size() > most_candidates)
                        return all;
                    all.push_back(judge(candidate.build(), std::to_string(all.size())));
                }
        return all;
    }

    // Those of the mesh once the filling is in it; 4 on its boundary.
    std::vector<int> valences(const fill::Filling &filling) const {
        std::vector<int> edges(at(filling.vertices), 0);
        for (const auto &quad : filling.quads)
            for (const int v : quad)
                ++edges[at(v)];
        for (std::size_t v = 0; v < cavity_.window.loop.size(); ++v)
            edges[v] = mesh_.on_boundary(cavity_.window.loop[v]) ? 4 : edges[v] + cavity_.window.outside[v];
        return edges;
    }

private:
    std::vector<Eigen::Vector3d> points_of(const std::vector<int> &vertices) const {
        std::vector<Eigen::Vector3d> points;
        for (const int v : vertices)
            points.push_back(vector(mesh_.point(v)));
        return points;
    }

    // Its numbers and the smallest scaled Jacobian of its quads.
    void describe(const std::string &name, Drawn &drawn) const {
        double least = 1;
        for (const auto &[a, b, c, d] : drawn.filling.quads) {
            const std::vector<Eigen::Vector3d> &p = drawn.points;
            least = std::min(least, quality::measure(quality::Metric::scaled_jacobian,
                                                     {p[at(a)], p[at(b)], p[at(c)], p[at(d)]}, 1));
        }
        drawn.title = name + ": " + std::to_string(drawn.filling.quads.size()) + " faces, " +
                      std::to_string(cavity_.singular_all(drawn.filling)) + " irregular";
        drawn.verdict = "scaled Jacobian " + std::to_string(least).substr(0, 5);
    }

    // As a window of a whole mesh is judged at first, see adapt/schedule.cpp.
    refill::ShapeBounds bounds_for(const fill::Filling &filling) const {
        const refill::ShapeBounds &before = evaluator_.before();
        const int gain = std::max(0, cavity_.old_singular_all - cavity_.singular_all(filling)) +
                         std::max(before.inverted, evaluator_.inverted_at_features());
        return {std::min(least_quality, before.scaled_jacobian), std::min(least_shape, before.shape),
                before.poor + poor_price * gain, before.inverted};
    }

    // Where it comes to lie, taken or not, or Tutte's start if it came nowhere.
    Drawn judge(const refill::PlacedFilling &candidate, const std::string &name) {
        const fill::Filling &filling = candidate.filling;
        const std::vector<int> &loop = cavity_.window.loop;
        Drawn drawn{filling, points_of(loop), "", "", false};
        trace_ = {};
        std::optional<refill::Evaluation> found;
        if (evaluator_.fits(filling))
            found = evaluator_.evaluate(candidate, bounds_for(filling));
        drawn.taken = found.has_value();
        for (const auto &p : found ? found->replacement.points : cavity_.lift(cavity_.embed(candidate)))
            drawn.points.push_back(vector(p));
        if (found)
            for (const auto &[moved, point] : found->replacement.moved.vertices)
                if (const auto i = std::find(loop.begin(), loop.end(), moved); i != loop.end())
                    drawn.points[at(i - loop.begin())] = vector(point);
        if (drawn.points.size() < at(filling.vertices)) {
            drawn.points.clear();
            const std::vector<double> lengths(loop.size(), 1);
            for (const auto &p :
                 geometry::embed_on_circle(filling.quads, filling.boundary, filling.vertices, lengths))
                drawn.points.emplace_back(p.x(), p.y(), 0);
        }
        describe(name, drawn);
        for (std::size_t i = 0; i < trace_.refused.size(); ++i)
            if (trace_.refused[i] > 0)
                drawn.verdict = std::string(refill::reason_names[i]) + ", " + drawn.verdict;
        return drawn;
    }

    const mesh::QuadMesh &mesh_;
    const refill::Cavity &cavity_;
    refill::Trace trace_;
    refill::Evaluator evaluator_;
};

// As large as the picture, seen along the mean normal of the loop.
std::vector<Eigen::Vector2d> places_of(const Drawn &drawn, bool plane) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < at(drawn.filling.boundary); ++i)
        normal += (drawn.points[i] - drawn.points[0]).cross(drawn.points[i + 1] - drawn.points[0]);
    const geometry::Plane view =
        plane ? geometry::Plane::of_coordinates(normal.z() < 0) : geometry::Plane::fit(drawn.points, normal);
    std::vector<Eigen::Vector2d> places;
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector3d &p : drawn.points)
        box.extend(places.emplace_back(view.to_plane(p)));
    const Eigen::Vector2d scale =
        Eigen::Vector2d(1, -1) * (0.94 * side / std::max(box.sizes().maxCoeff(), 1e-300));
    for (Eigen::Vector2d &p : places)
        p = Eigen::Vector2d::Constant(side / 2) + (p - box.center()).cwiseProduct(scale);
    return places;
}

std::string grid(const Candidates &candidates, const std::vector<Drawn> &all, bool plane) {
    constexpr std::array colours{"#7b2fa0", "#2458c5", "#7b2fa0", "#d0312d"}; // of valences other, 3, 4, 5
    const double right = side + gap, down = side + caption + gap;
    std::ostringstream svg;
    svg << "<svg xmlns='http://www.w3.org/2000/svg' width='" << gap + static_cast<double>(columns) * right
        << "' height='" << gap + static_cast<double>((all.size() + columns - 1) / columns) * down
        << "' font-family='sans-serif' font-size='13'>\n<rect width='100%' height='100%' fill='#fff'/>\n";
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::vector<Eigen::Vector2d> places = places_of(all[i], plane);
        svg << "<g transform='translate(" << gap + static_cast<double>(i % columns) * right << ' '
            << gap + static_cast<double>(i / columns) * down << ")'>\n<path stroke='#555' fill='"
            << (all[i].taken ? "#e4f2e4" : "#f6e9e4") << "' stroke-width='0.7' d='";
        for (const auto &quad : all[i].filling.quads)
            for (std::size_t k = 0; k < 4; ++k)
                svg << (k == 0 ? 'M' : 'L') << places[at(quad[k])].x() << ' ' << places[at(quad[k])].y()
                    << (k == 3 ? "z" : "");
        svg << "'/>\n";
        const std::vector<int> valences = candidates.valences(all[i].filling);
        for (std::size_t v = 0; v < places.size(); ++v)
            if (const int n = valences[v]; n != 4)
                svg << "<circle cx='" << places[v].x() << "' cy='" << places[v].y() << "' r='3.5' fill='"
                    << colours[n == 3 || n == 5 ? at(n - 2) : 0] << "'/>\n";
        svg << "<text y='" << side + 15 << "'>" << all[i].title << "</text><text y='" << side + 32
            << "' fill='" << (all[i].taken ? "#1a7a3c" : "#a03020") << "'>" << all[i].verdict
            << "</text>\n</g>\n";
    }
    return svg.str() + "</svg>\n";
}

// words: the point, FACES and perhaps ALPHA.
void show(const std::string &path, const std::vector<std::string> &words, const std::string &out) {
    mesh::QuadMesh mesh = read_mesh(path);
    const std::size_t dim = at(mesh.dim());
    std::vector<double> numbers;
    for (const std::string &word : words)
        if (io::parse(word, numbers.emplace_back()) != io::Parsed::number)
            throw Failure(Fault::argument, word + " is no number");
    if (numbers.size() != dim + 1 && numbers.size() != dim + 2)
        throw Failure(Fault::argument, "give " + std::to_string(dim) + " coordinates, then FACES [ALPHA]");
    const Eigen::Vector3d point(numbers[0], numbers[1], dim == 3 ? numbers[2] : 0);
    patch::Growth growth(mesh);
    const Patch window{growth.disk({nearest(mesh, point), static_cast<int>(numbers[dim])}), {}, 0};
    const std::size_t n = window.faces.size();
    std::vector<int> around = growth.surround(window.faces, buffer_layers); // the window first
    around.erase(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(n));
    refill::Goal goal;
    goal.any_count = numbers.size() == dim + 1;
    goal.faces = std::llround((goal.any_count ? 1 : numbers.back()) * static_cast<double>(n));
    Settings settings;
    settings.candidates = most_candidates;
    reference::Reference reference = reference::reference_of(mesh);
    if (const auto &surface = reference.surface)
        reference.surface_distance =
            reference::surface_distance_of(mesh, *surface, mesh.n_faces(), settings.tolerance);
    const refill::Cavity cavity(mesh, window, goal, settings, reference);
    const refill::BufferRing buffer(mesh, cavity, std::move(around), false);
    Candidates candidates(mesh, cavity, buffer, settings);
    io::save(out, grid(candidates, candidates.draw(), mesh.dim() == 2));
}

} // namespace

int main(int n, char **words) try {
    if (n < 6)
        throw Failure(Fault::argument, "candidates MESH X Y [Z] FACES [ALPHA] OUT.svg");
    show(words[1], {words + 2, words + n - 1}, words[n - 1]);
} catch (const refill::Refusal &refusal) {
    std::fprintf(stderr, "%s\n", refusal.text.c_str());
    return 1;
} catch (const std::exception &failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
}
