// Sequences of calls with any arguments: after a failure all is as it was, after a success the mesh is in
// order and has the faces that the status promises.
#include <array>
#include <cmath>
#include <vector>

#include "bytes.h"

using namespace alphamst::fuzz;

namespace {

constexpr int most_calls = 12;
constexpr std::int32_t most_side = 6;
// More faces would only take longer.
constexpr std::int64_t most_faces = 600;

class World {
public:
    explicit World(Bytes &bytes) : bytes_(bytes), base_(bytes.below(2)) {
        require(amst_context_create(base_, &context_) == AMST_OK, "there are contexts");
        require(amst_options_create(&options_) == AMST_OK, "there are options");
        // Short searches leave time for more calls.
        require(amst_options_set_real(options_, AMST_OPT_EFFORT, 0.01) == AMST_OK, "effort is an option");
        for (const std::int32_t key : {AMST_OPT_CANDIDATES, AMST_OPT_NODE_LIMIT, AMST_OPT_SMOOTH_STEPS})
            require(amst_options_set_int(options_, key, 2) == AMST_OK, "limits are options");
        create_mesh();
        require(amst_patches_create(mesh_, options_, &patches_) == AMST_OK, "a mesh has patch sets");
    }
    ~World() {
        amst_context_destroy(context_); // in this order, as the header allows any
        amst_mesh_destroy(mesh_);
        amst_options_destroy(options_);
        amst_report_destroy(report_);
        amst_patches_destroy(patches_);
    }
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    void call() {
        static constexpr void (World::*calls[])() = {
            &World::adapt,         &World::adapt,     &World::reduce,      &World::smooth,
            &World::clean,         &World::collapse,  &World::split,       &World::insert,
            &World::add_rings,     &World::add_ball,  &World::add_faces,   &World::decompose,
            &World::renew_patches, &World::set_alpha, &World::set_corners, &World::set_option,
            &World::set_real,      &World::set_flags, &World::set_points,  &World::set_size,
            &World::set_markers,   &World::rollback,  &World::cross_field, &World::set_surface,
            &World::clone,         &World::detect,    &World::predict,     &World::ask};
        (this->*calls[static_cast<std::size_t>(bytes_.below(std::size(calls)))])();
    }
    std::int64_t faces() const { return count(mesh_, AMST_FACE); }

private:
    // A grid, plane or bent, with one corner moved.
    void create_mesh() {
        const std::int32_t nx = 1 + bytes_.below(most_side), ny = 1 + bytes_.below(most_side),
                           dim = 2 + bytes_.below(2);
        const double bend = dim == 3 ? bytes_.below(8) / 8.0 : 0;
        std::vector<double> points;
        std::vector<amst_id> corners;
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i) {
                points.insert(points.end(), {i + 0.2 * bytes_.below(2), static_cast<double>(j)});
                if (dim == 3)
                    points.push_back(bend * i * (nx - i));
            }
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                const amst_id low = j * (nx + 1) + i + base_;
                corners.insert(corners.end(), {low, low + 1, low + nx + 2, low + nx + 1});
            }
        require(amst_mesh_create(context_, dim, points.data(), (nx + 1) * (ny + 1), 0, 0, corners.data(),
                                 nx * ny, 0, 0, 4, options_, &mesh_) >= AMST_OK,
                "a grid is a mesh");
    }

    // How a call that may change the mesh went.
    template <class Call> amst_status change(Call call) {
        const std::int64_t before = checksum(mesh_), edges = count(mesh_, AMST_EDGE);
        const amst_status status = call();
        if (status < 0) {
            require(amst_last_error()[0] != 0, "a failure has words");
            require(checksum(mesh_) == before && count(mesh_, AMST_EDGE) == edges,
                    "a failure changes nothing");
        } else {
            is_valid(mesh_);
            require_finite();
        }
        return status;
    }
    // The same for an operation, and its report.
    template <class Call> void operate(bool exact, Call call) {
        amst_report *report = nullptr;
        const bool valid = is_valid(mesh_);
        const amst_status status = change([&] { return call(&report); });
        require(!valid || is_valid(mesh_), "an operation inverts no face");
        require((status < 0) == (report == nullptr), "a success alone has a report");
        if (report == nullptr)
            return;
        std::int64_t after = 0, wanted = 0;
        require(amst_report_get_int(report, AMST_ALL, AMST_RESULT_FACES_AFTER, &after) == AMST_OK,
                "a report has faces");
        require(amst_report_get_int(report, AMST_ALL, AMST_RESULT_FACES_WANTED, &wanted) == AMST_OK,
                "a report has faces");
        require(!exact || status != AMST_OK || after == wanted, "AMST_OK means all the faces wanted");
        amst_report_destroy(report_);
        report_ = report;
    }
    void require_finite() const {
        std::int64_t needed = 0;
        require(amst_mesh_get_points(mesh_, nullptr, 0, &needed) == AMST_OK, "points can be asked for");
        std::vector<double> points(static_cast<std::size_t>(needed));
        require(amst_mesh_get_points(mesh_, points.data(), needed, &needed) == AMST_OK, "points can be had");
        for (const double number : points)
            require(std::isfinite(number), "a success leaves finite points");
    }

    amst_patches *some_patches() { return bytes_.below(3) == 0 ? nullptr : patches_; }
    std::int32_t entity() { return bytes_.below(16) == 0 ? bytes_.below(5) - 1 : bytes_.below(3); }
    amst_id id(std::int32_t of) {
        return base_ + bytes_.id(of >= AMST_VERTEX && of <= AMST_FACE ? count(mesh_, of) : 1);
    }
    std::vector<amst_id> ids(std::int32_t of) {
        std::vector<amst_id> chosen(static_cast<std::size_t>(bytes_.below(6)));
        for (amst_id &one : chosen)
            one = id(of);
        return chosen;
    }
    // Most often one that does not end in a large mesh.
    double alpha() { return bytes_.real(); }

    void adapt() {
        amst_patches *set = some_patches();
        const double wanted = alpha();
        operate(true, [&](amst_report **report) { return amst_adapt(mesh_, set, wanted, options_, report); });
    }
    void reduce() {
        amst_patches *set = some_patches();
        operate(false, [&](amst_report **report) {
            return amst_reduce_singularities(mesh_, set, options_, report);
        });
    }
    void smooth() {
        amst_patches *set = some_patches();
        operate(false, [&](amst_report **report) { return amst_smooth(mesh_, set, options_, report); });
    }
    void clean() {
        operate(false, [&](amst_report **report) { return amst_clean(mesh_, options_, report); });
    }
    void collapse() {
        const amst_id edge = id(AMST_EDGE);
        operate(false,
                [&](amst_report **report) { return amst_collapse_chord(mesh_, edge, options_, report); });
    }
    void split() {
        const amst_id edge = id(AMST_EDGE);
        const std::int32_t n = bytes_.below(8) - 1;
        operate(false,
                [&](amst_report **report) { return amst_split_chord(mesh_, edge, n, options_, report); });
    }
    void insert() {
        const std::int32_t n = bytes_.below(8) - 1;
        operate(false, [&](amst_report **report) {
            return amst_insert_chords(mesh_, patches_, n, options_, report);
        });
    }

    // How a call that changes the patch set or nothing went.
    void note(amst_status status) {
        require(status >= 0 || amst_last_error()[0] != 0, "a failure has words");
    }
    amst_id patch() {
        std::int64_t n = 0;
        require(amst_patches_get_count(patches_, &n) >= AMST_ERR_STALE, "patches can be counted");
        return base_ + bytes_.id(n);
    }
    void add_rings() { note(amst_patches_add_rings(patches_, id(AMST_VERTEX), bytes_.below(4), nullptr)); }
    void add_ball() {
        const double centre[] = {bytes_.real(), bytes_.real(), bytes_.real()};
        note(amst_patches_add_ball(patches_, centre, bytes_.real(), nullptr));
    }
    void add_faces() {
        const std::vector<amst_id> chosen = ids(AMST_FACE);
        note(amst_patches_add_faces(patches_, chosen.data(), static_cast<std::int64_t>(chosen.size()),
                                    nullptr));
    }
    void decompose() { note(amst_patches_decompose(patches_, bytes_.below(7) - 1, nullptr)); }
    void renew_patches() {
        amst_patches *fresh = nullptr;
        require(amst_patches_create(mesh_, options_, &fresh) == AMST_OK, "a mesh has patch sets");
        amst_patches_destroy(patches_);
        patches_ = fresh;
    }
    void set_alpha() { note(amst_patches_set_alpha(patches_, patch(), alpha())); }
    void set_corners() {
        const std::vector<amst_id> chosen = ids(AMST_VERTEX);
        note(amst_patches_set_corners(patches_, patch(), chosen.data(),
                                      static_cast<std::int64_t>(chosen.size())));
    }
    void predict() {
        std::int64_t n_faces = 0, singular = 0;
        note(amst_patches_predict(patches_, patch(), alpha(), options_, &n_faces, &singular));
    }

    void set_option() { note(amst_options_set_int(options_, bytes_.below(13), bytes_.below(20) - 1)); }
    void set_real() {
        const std::int32_t key = 1000 + bytes_.below(11);
        if (key != AMST_OPT_EFFORT)
            note(amst_options_set_real(options_, key, bytes_.real()));
    }
    void set_flags() {
        const std::int32_t of = entity(), mask = bytes_.below(8);
        const std::vector<amst_id> chosen = ids(of);
        change([&] {
            return amst_mesh_set_flags(mesh_, of, chosen.data(), static_cast<std::int64_t>(chosen.size()),
                                       mask, bytes_.below(8) & mask);
        });
    }
    void set_markers() {
        const std::int32_t of = entity(), value = bytes_.below(4);
        const std::vector<amst_id> chosen = ids(of);
        change([&] {
            return amst_mesh_set_markers(mesh_, of, chosen.data(), static_cast<std::int64_t>(chosen.size()),
                                         value);
        });
    }
    // One vertex elsewhere.
    void set_points() {
        std::int64_t needed = 0;
        require(amst_mesh_get_points(mesh_, nullptr, 0, &needed) == AMST_OK, "points can be asked for");
        std::vector<double> points(static_cast<std::size_t>(needed));
        require(amst_mesh_get_points(mesh_, points.data(), needed, &needed) == AMST_OK, "points can be had");
        points[static_cast<std::size_t>(bytes_.below(256)) % points.size()] = bytes_.real();
        change([&] { return amst_mesh_set_points(mesh_, points.data(), count(mesh_, AMST_VERTEX)); });
    }
    void set_size() {
        std::vector<double> sizes(static_cast<std::size_t>(count(mesh_, AMST_VERTEX)));
        const double values[] = {bytes_.real(), bytes_.real(), bytes_.real()};
        for (std::size_t v = 0; v < sizes.size(); ++v)
            sizes[v] = values[v % 3];
        change([&] {
            return amst_mesh_set_field(mesh_, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, sizes.data(),
                                       static_cast<std::int64_t>(sizes.size()));
        });
    }
    void rollback() {
        if (bytes_.below(2) == 0)
            change([&] { return amst_mesh_mark(mesh_, &marked_); });
        else
            change([&] { return amst_mesh_rollback(mesh_, marked_); });
    }
    void cross_field() {
        change([&] { return amst_mesh_compute_cross_field(mesh_, options_); });
    }
    // A square, somewhere.
    void set_surface() {
        const double z = bytes_.real();
        const double points[] = {-9, -9, z, 19, -9, z, 19, 19, -z, -9, 19, z};
        const std::array<amst_id, 6> triangles = {base_, base_ + 1, base_ + 2, base_, base_ + 2, base_ + 3};
        change([&] { return amst_mesh_set_surface(mesh_, points, 4, triangles.data(), 2); });
    }
    void clone() {
        amst_mesh *other = nullptr;
        require(amst_mesh_clone(mesh_, &other) == AMST_OK, "a mesh can be copied");
        require(checksum(other) == checksum(mesh_), "a copy is equal");
        amst_mesh_destroy(other);
    }
    void detect() {
        change([&] { return amst_mesh_detect_features(mesh_, 60 * bytes_.real(), nullptr); });
    }
    void ask() {
        amst_summary summary;
        note(amst_mesh_get_summary(mesh_, bytes_.below(22) - 1, &summary));
        std::int64_t needed = 0;
        note(amst_mesh_get_chords(mesh_, bytes_.below(10) - 1, options_, nullptr, 0, &needed));
        note(amst_mesh_get_overlap(mesh_, mesh_, nullptr, nullptr, nullptr, 0, &needed));
        if (report_ != nullptr)
            note(amst_report_get_origin(report_, entity(), nullptr, 0, &needed));
    }

    Bytes &bytes_;
    std::int32_t base_;
    amst_context *context_ = nullptr;
    amst_options *options_ = nullptr;
    amst_mesh *mesh_ = nullptr;
    amst_patches *patches_ = nullptr;
    amst_report *report_ = nullptr;
    std::int64_t marked_ = 0;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    Bytes bytes(data, size);
    World world(bytes);
    for (int i = 0; i < most_calls && !bytes.empty() && world.faces() <= most_faces; ++i)
        world.call();
    return 0;
}
