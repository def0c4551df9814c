// Chords through the C interface: all labels of a million faces, every chord that can go out of a hundred
// thousand, and coarsening by chords, by templates and by both.
#include <chrono>

#include <benchmark/benchmark.h>

#include "meshes.h"

namespace alphamst::benchmarks {
namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::int64_t count(const Mesh &mesh, std::int32_t entity) {
    std::int64_t n = 0;
    must(amst_mesh_get_count(mesh.get(), entity, &n));
    return n;
}

void labels(benchmark::State &state) {
    const Context context = new_context();
    const Mesh mesh = create(context, grid(1000), 2);
    std::vector<amst_id> ids(static_cast<std::size_t>(count(mesh, AMST_EDGE)));
    std::vector<double> times;
    std::int64_t n_chords = 0, needed = 0;
    for ([[maybe_unused]] auto iteration : state) {
        const double start = now();
        must(amst_mesh_get_chord_ids(mesh.get(), &n_chords, ids.data(), std::ssize(ids), &needed));
        times.push_back(now() - start);
        state.SetIterationTime(times.back());
    }
    state.counters["seconds"] = median(times);
    state.counters["chords"] = static_cast<double>(n_chords);
}
BENCHMARK(labels)->Name("chord/labels")->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);

using Options = std::unique_ptr<amst_options, Destroy<amst_options_destroy>>;

Options by_chords() {
    amst_options *options = nullptr;
    must(amst_options_create(&options));
    Options made(options);
    must(amst_options_set_int(options, AMST_OPT_STRATEGY, 1));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    return made;
}

// Each mesh on a clone of its own; alpha so small that every chord goes that can.
void removal(benchmark::State &state, const Arrays &arrays) {
    const Context context = new_context();
    const Mesh start = create(context, arrays, 2);
    const Options options = by_chords();
    double seconds = 0, left = 0;
    for ([[maybe_unused]] auto iteration : state) {
        const Mesh mesh = clone(start);
        const double before = now();
        must(amst_adapt(mesh.get(), nullptr, 1e-9, options.get(), nullptr));
        seconds = now() - before;
        left = static_cast<double>(count(mesh, AMST_FACE));
        state.SetIterationTime(seconds);
    }
    state.counters["seconds"] = seconds;
    state.counters["faces"] = static_cast<double>(count(start, AMST_FACE));
    state.counters["left"] = left;
}
BENCHMARK_CAPTURE(removal, grid, grid(316))
    ->Name("chord/removal/grid")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

enum Tools { chords, templates, both };

// Both: windows take out singular vertices, which leaves chords that can go; at last windows again bring
// the exact count.
void coarsen(benchmark::State &state, Tools tools, double alpha) {
    const Context context = new_context();
    const Mesh start = create(context, unstructured(5000), 2);
    const Options options = by_chords();
    const auto faces = static_cast<double>(count(start, AMST_FACE));
    for ([[maybe_unused]] auto iteration : state) {
        const Mesh mesh = clone(start);
        const double before = now();
        if (tools == both)
            must(amst_reduce_singularities(mesh.get(), nullptr, nullptr, nullptr));
        if (tools != templates)
            must(amst_adapt(mesh.get(), nullptr, alpha * faces / static_cast<double>(count(mesh, AMST_FACE)),
                            options.get(), nullptr));
        if (tools != chords)
            must(amst_adapt(mesh.get(), nullptr, alpha * faces / static_cast<double>(count(mesh, AMST_FACE)),
                            nullptr, nullptr));
        state.SetIterationTime(now() - before);
        std::int64_t singular = 0;
        amst_summary shape{};
        must(amst_mesh_get_singularities(mesh.get(), nullptr, 0, &singular));
        must(amst_mesh_get_summary(mesh.get(), AMST_METRIC_SCALED_JACOBIAN, &shape));
        state.counters["faces"] = static_cast<double>(count(mesh, AMST_FACE));
        state.counters["singular"] = static_cast<double>(singular);
        state.counters["scaled_jacobian"] = shape.min;
    }
    state.counters["wanted"] = alpha * faces;
}

const bool registered = [] {
    const char *names[] = {"chords", "templates", "both"};
    for (const Tools tools : {chords, templates, both})
        for (const double alpha : {0.5, 0.25}) {
            std::ostringstream name;
            name << "chord/coarsen/" << names[tools] << "/alpha:" << alpha;
            benchmark::RegisterBenchmark(name.str().c_str(),
                                         [=](benchmark::State &state) { coarsen(state, tools, alpha); })
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond)
                ->Iterations(1);
        }
    return true;
}();

} // namespace
} // namespace alphamst::benchmarks
