// A mesh from arrays and back through the C interface, beside what it costs at the least: a
// bare OpenMesh add_face loop and memcpy, measured in the same iteration.
#include <chrono>
#include <cstring>

#include <benchmark/benchmark.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/Traits.hh>

#include "allocation.h"
#include "meshes.h"

namespace alphamst::benchmarks {
namespace {

constexpr int side = 1000; // of the grid: 10^6 quads

double seconds_of(const auto &work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

using BareMesh = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

void fill(BareMesh &bare, const Arrays &mesh) {
    const auto n_points = static_cast<std::size_t>(mesh.n_points());
    const auto n_faces = static_cast<std::size_t>(mesh.n_faces());
    bare.reserve(n_points, n_points + n_faces, n_faces);
    for (std::size_t v = 0; v < n_points; ++v)
        bare.add_vertex({mesh.points[3 * v], mesh.points[3 * v + 1], mesh.points[3 * v + 2]});
    for (std::size_t f = 0; f < n_faces; ++f)
        bare.add_face(
            BareMesh::VertexHandle(mesh.faces[4 * f]), BareMesh::VertexHandle(mesh.faces[4 * f + 1]),
            BareMesh::VertexHandle(mesh.faces[4 * f + 2]), BareMesh::VertexHandle(mesh.faces[4 * f + 3]));
}

void create_million(benchmark::State &state) {
    const Arrays mesh = grid(side);
    const auto n_faces = static_cast<double>(mesh.n_faces());
    const Context context = new_context();
    std::vector<double> ratios, bare_times;
    double live = 0, most = 0;
    for ([[maybe_unused]] auto iteration : state) {
        double bare_time = 0;
        {
            BareMesh bare;
            bare_time = seconds_of([&] { fill(bare, mesh); });
            benchmark::DoNotOptimize(bare.n_faces());
        }
        const std::int64_t before = bytes_live();
        restart_bytes_most();
        Mesh created;
        const double time = seconds_of([&] { created = create(context, mesh); });
        live = static_cast<double>(bytes_live() - before) / n_faces;
        most = static_cast<double>(bytes_most() - before) / n_faces;
        state.SetIterationTime(time);
        bare_times.push_back(bare_time);
        ratios.push_back(time / bare_time);
    }
    state.counters["bare_ms"] = 1e3 * median(bare_times);
    state.counters["ratio"] = median(ratios);
    state.counters["bytes_per_face"] = live;
    state.counters["bytes_per_face_most"] = most;
}
BENCHMARK(create_million)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(7);

// dim is the argument; the copy of as many bytes is the measure.
void get_back(benchmark::State &state) {
    const Context context = new_context();
    const auto dim = state.range(0);
    const Mesh mesh = create(context, grid(side), static_cast<int>(dim));
    std::int64_t n_points = 0, n_faces = 0, needed = 0;
    must(amst_mesh_get_count(mesh.get(), AMST_VERTEX, &n_points));
    must(amst_mesh_get_count(mesh.get(), AMST_FACE, &n_faces));
    std::vector<double> points(static_cast<std::size_t>(dim * n_points)), points_copy(points.size());
    std::vector<amst_id> faces(static_cast<std::size_t>(4 * n_faces)), faces_copy(faces.size());
    std::vector<double> points_ratios, faces_ratios;
    auto copy = [](auto &to, const auto &from) {
        std::memcpy(to.data(), from.data(), from.size() * sizeof from[0]);
        benchmark::ClobberMemory();
    };
    for ([[maybe_unused]] auto iteration : state) {
        const double points_time = seconds_of(
            [&] { must(amst_mesh_get_points(mesh.get(), points.data(), dim * n_points, &needed)); });
        const double faces_time =
            seconds_of([&] { must(amst_mesh_get_faces(mesh.get(), faces.data(), 4 * n_faces, &needed)); });
        points_ratios.push_back(points_time / seconds_of([&] { copy(points_copy, points); }));
        faces_ratios.push_back(faces_time / seconds_of([&] { copy(faces_copy, faces); }));
        state.SetIterationTime(points_time + faces_time);
    }
    state.counters["points_ratio"] = median(points_ratios);
    state.counters["faces_ratio"] = median(faces_ratios);
}
BENCHMARK(get_back)
    ->ArgName("dim")
    ->Arg(2)
    ->Arg(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(21);

} // namespace
} // namespace alphamst::benchmarks
