// Patches predicted and adapted through the C interface on one thread. Run as it is, the
// meshes are made here; ALPHAMST_BENCHMARK_MESHES (see scripts/benchmark) adds mesh files.
#include <chrono>
#include <functional>
#include <limits>

#include <benchmark/benchmark.h>

#include "meshes.h"

namespace alphamst::benchmarks {
namespace {

using Point = std::array<double, 3>;

struct Ball {
    Point centre;
    double radius;
};

double squared_distance(const Point &a, const Point &b) {
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

std::vector<Point> centroids_of(const Arrays &mesh) {
    std::vector<Point> centroids(static_cast<std::size_t>(mesh.n_faces()), Point{});
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            centroids[i / 4][k] += mesh.points[3 * static_cast<std::size_t>(mesh.faces[i]) + k] / 4;
    return centroids;
}

Point point_of(const Arrays &mesh, std::size_t vertex) {
    return {mesh.points[3 * vertex], mesh.points[3 * vertex + 1], mesh.points[3 * vertex + 2]};
}

std::vector<Point> boundary_points(const Mesh &mesh, const Arrays &a) {
    std::int64_t n_edges = 0, needed = 0;
    must(amst_mesh_get_count(mesh.get(), AMST_EDGE, &n_edges));
    std::vector<amst_id> edges(static_cast<std::size_t>(2 * n_edges)), sides(edges.size());
    must(amst_mesh_get_edges(mesh.get(), edges.data(), 2 * n_edges, &needed));
    must(amst_mesh_get_edge_faces(mesh.get(), sides.data(), 2 * n_edges, &needed));
    std::vector<Point> points;
    for (std::size_t i = 0; i < sides.size(); i += 2)
        if (sides[i] < 0 || sides[i + 1] < 0)
            for (const std::size_t k : {i, i + 1})
                points.push_back(point_of(a, static_cast<std::size_t>(edges[k])));
    return points;
}

// Up to `most` balls of so many faces that stay off the boundary, around vertices drawn at random.
std::vector<Ball> draw_balls(const Mesh &mesh, std::int64_t faces, std::size_t most) {
    const Arrays a = arrays(mesh);
    const std::vector<Point> centroids = centroids_of(a), boundary = boundary_points(mesh, a);
    std::mt19937 random(12);
    std::vector<Ball> balls;
    for (std::size_t trial = 0; trial < 500 * most && balls.size() < most; ++trial) {
        const Point centre = point_of(a, random() % static_cast<std::size_t>(a.n_points()));
        double room = std::numeric_limits<double>::infinity();
        for (const Point &point : boundary)
            room = std::min(room, squared_distance(centre, point));
        std::vector<double> near;
        for (const Point &centroid : centroids)
            if (const double distance = squared_distance(centre, centroid); distance < room)
                near.push_back(distance);
        if (static_cast<std::int64_t>(near.size()) < faces)
            continue;
        const auto last = near.begin() + (faces - 1);
        std::nth_element(near.begin(), last, near.end());
        balls.push_back({centre, std::sqrt(*last) * (1 + 1e-12)});
    }
    return balls;
}

struct Times {
    std::vector<double> call, predict, patch; // seconds: predict and adapt, predict, inside adapt
    std::int64_t left = 0;                    // patches that were not adapted
};

double greatest(const std::vector<double> &values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// One patch on a clone of its own; clone and choice of the patch are not counted.
void measure(const Mesh &mesh, const Ball &ball, double alpha, Times &times) {
    const Mesh mine = clone(mesh);
    amst_patches *patches = nullptr;
    must(amst_patches_create(mine.get(), nullptr, &patches));
    const Patches owner(patches);
    must(amst_patches_add_ball(patches, ball.centre.data(), ball.radius, nullptr));
    std::int64_t faces = 0, singularities = 0, status = 0;
    amst_report *report = nullptr;
    const double start = now();
    const bool predicted = amst_patches_predict(patches, 0, alpha, nullptr, &faces, &singularities) >= 0;
    const double middle = now();
    must(amst_adapt(mine.get(), patches, alpha, nullptr, &report));
    const double end = now();
    const Report report_owner(report);
    must(amst_report_get_int(report, 0, AMST_RESULT_STATUS, &status));
    if (!predicted || status < 0)
        ++times.left;
    double inside = 0;
    must(amst_report_get_real(report, 0, AMST_RESULT_SECONDS, &inside));
    times.call.push_back(end - start);
    times.predict.push_back(middle - start);
    times.patch.push_back(inside);
}

// Balls of one size in one mesh. The time is the median of predict and adapt together,
// which the copy of the whole mesh in every change is part of; patch_ms is without it.
void adapt_balls(benchmark::State &state, const Mesh &mesh, std::int64_t faces, std::size_t most,
                 double alpha) {
    const std::vector<Ball> balls = draw_balls(mesh, faces, most);
    if (balls.empty()) {
        state.SkipWithError("no ball of that many faces in the mesh");
        return;
    }
    Times times;
    for ([[maybe_unused]] auto iteration : state) {
        times = Times();
        for (const Ball &ball : balls)
            measure(mesh, ball, alpha, times);
        state.SetIterationTime(median(times.call));
    }
    std::int64_t n_faces = 0;
    must(amst_mesh_get_count(mesh.get(), AMST_FACE, &n_faces));
    state.counters["mesh_faces"] = static_cast<double>(n_faces);
    state.counters["patches"] = static_cast<double>(balls.size());
    state.counters["left"] = static_cast<double>(times.left);
    state.counters["predict_ms"] = 1e3 * median(times.predict);
    state.counters["patch_ms"] = 1e3 * median(times.patch);
    state.counters["worst_ms"] = 1e3 * greatest(times.call);
}

// Seconds grow as faces to the power `exponent`, 10^3 to 10^5 faces, alpha = 2.
void growth(benchmark::State &state) {
    const Context context = new_context();
    std::vector<double> seconds, worst;
    std::int64_t left = 0;
    for ([[maybe_unused]] auto iteration : state) {
        seconds.clear();
        worst.clear();
        left = 0;
        double sum = 0;
        for (const std::int64_t faces : {1000, 10000, 100000}) {
            const Mesh mesh = create(context, unstructured(2 * faces));
            Times times;
            for (const Ball &ball : draw_balls(mesh, faces, faces > 50000 ? 1 : 5))
                measure(mesh, ball, 2, times);
            seconds.push_back(median(times.call));
            worst.push_back(greatest(times.call));
            left += times.left;
            sum += seconds.back();
        }
        state.SetIterationTime(sum);
    }
    state.counters["exponent"] = std::log(seconds[2] / seconds[0]) / std::log(100.0);
    state.counters["left"] = static_cast<double>(left);
    for (std::size_t k = 0; k < seconds.size(); ++k) {
        state.counters["ms_1e" + std::to_string(k + 3)] = 1e3 * seconds[k];
        state.counters["worst_1e" + std::to_string(k + 3)] = 1e3 * worst[k];
    }
}
BENCHMARK(growth)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(1);

void add_size(const std::string &mesh_name, std::int64_t faces, std::size_t most,
              const std::vector<double> &alphas, const std::function<Mesh(const Context &)> &make) {
    for (const double alpha : alphas) {
        std::ostringstream name;
        name << "adapt/" << mesh_name << "/faces:" << faces << "/alpha:" << alpha;
        benchmark::RegisterBenchmark(name.str().c_str(),
                                     [=](benchmark::State &state) {
                                         const Context context = new_context();
                                         adapt_balls(state, make(context), faces, most, alpha);
                                     })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1);
    }
}

const bool registered = [] {
    auto made = [](std::int64_t n_faces) {
        return [=](const Context &context) { return create(context, unstructured(n_faces)); };
    };
    add_size("made", 100, 101, {0.5, 1, 2, 4}, made(5000));
    add_size("made", 10000, 5, {2}, made(20000));
    const std::vector<std::string> files = mesh_files();
    auto file = [](const std::string &path) {
        return [=](const Context &context) { return read(context, path); };
    };
    if (!files.empty()) {
        add_size("file", 100, 101, {0.5, 1, 2, 4}, file(files.front()));
        add_size("file", 10000, 5, {2}, file(files.back()));
    }
    return true;
}();

} // namespace
} // namespace alphamst::benchmarks
