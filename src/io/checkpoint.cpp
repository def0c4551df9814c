#include "io/checkpoint.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>

#include "index.h"
#include "io/markers.h"
#include "io/sections.h"
#include "surface/boundary_curve.h"
#include "surface/curve.h"
#include "surface/surface.h"

namespace alphamst::io {
namespace {

using Eigen::Vector3d;
using Integers = std::vector<std::int32_t>;

// Numbers of the section "head".
enum Head {
    dimension,
    revision,
    last_revision,
    curve_numbers,
    n_fields,
    n_surfaces,
    n_curves,
    n_boundaries,
    n_head
};

std::vector<double> packed(std::span<const Vector3d> points) {
    std::vector<double> numbers;
    numbers.reserve(3 * points.size());
    for (const Vector3d &p : points)
        numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
    return numbers;
}

template <std::size_t width> Integers packed(const std::vector<std::array<std::int32_t, width>> &rows) {
    Integers numbers;
    for (const std::array<std::int32_t, width> &row : rows)
        numbers.insert(numbers.end(), row.begin(), row.end());
    return numbers;
}

std::span<const char> letters(std::string_view text) { return {text.data(), text.size()}; }

void add_names(SectionWriter &to, const Names &names) {
    Integers ids;
    std::string text;
    for (const auto &[of, name] : names) {
        ids.insert(ids.end(),
                   {static_cast<std::int32_t>(of.first), of.second, static_cast<std::int32_t>(name.size())});
        text += name;
    }
    to.add("nids", ids);
    to.add("name", letters(text));
}

void add_reference(SectionWriter &to, const mesh::QuadMesh &mesh) {
    if (mesh.surface) {
        to.add("spnt", packed(mesh.surface->points()));
        to.add("stri", packed(mesh.surface->triangles()));
    }
    if (mesh.curves) {
        std::vector<Vector3d> ends;
        for (const surface::Line &line : mesh.curves->lines())
            ends.insert(ends.end(), {line.start, line.end});
        to.add("clin", packed(ends));
        to.add("ctol", std::vector<double>{mesh.curves->tolerance()});
    }
    if (mesh.boundary) {
        Integers lengths;
        std::vector<Vector3d> points;
        for (int curve = 0; curve < mesh.boundary->count(); ++curve) {
            const std::vector<Vector3d> &of = mesh.boundary->points(curve);
            lengths.push_back(static_cast<std::int32_t>(of.size()));
            points.insert(points.end(), of.begin(), of.end());
        }
        to.add("blen", lengths);
        to.add("bpnt", packed(points));
    }
}

class Reader {
public:
    explicit Reader(std::string_view bytes) : from_(bytes) {}

    Checkpoint read() {
        const std::vector<std::int64_t> head = from_.take<std::int64_t>("head");
        if (head.size() != n_head)
            from_.fail("the section head has " + std::to_string(head.size()) + " numbers");
        Checkpoint result{nullptr, {head[revision], head[last_revision], {}, {}}};
        result.mesh.reset(new mesh::QuadMesh(read_mesh(head)));
        mesh::QuadMesh &mesh = *result.mesh;
        mesh.curve_numbers = head[curve_numbers] != 0;
        read_names(mesh.names);
        for (std::int64_t i = 0; i < head[n_fields]; ++i)
            read_field(mesh);
        read_reference(head, mesh);
        result.history.crossed = rows<2>("cros");
        result.history.split = rows<3>("splt");
        from_.expect_end();
        if (result.history.revision < 0 || result.history.last_revision < result.history.revision)
            from_.fail("the revisions cannot be");
        return result;
    }

private:
    // Failures of what the sections say get a place; memory that runs out stays what it is.
    template <class Call> auto placed(const Call &call) {
        try {
            return call();
        } catch (const Failure &failure) {
            if (failure.text.starts_with("byte "))
                throw;
            std::string text = failure.text;
            for (const std::int64_t id : failure.ids)
                if (const std::size_t hole = text.find("{}"); hole != std::string::npos)
                    text.replace(hole, 2, "number " + std::to_string(id));
            from_.fail("the sections up to here make no mesh: " + text);
        }
    }

    mesh::QuadMesh read_mesh(const std::vector<std::int64_t> &head) {
        const std::vector<double> points = from_.take<double>("pnts");
        mesh::QuadMesh::Connectivity connectivity;
        connectivity.faces = from_.take<std::int32_t>("face");
        connectivity.sides = from_.take<std::int32_t>("side");
        connectivity.first = from_.take<std::int32_t>("frst");
        const int dim = head[dimension] == 2 || head[dimension] == 3 ? static_cast<int>(head[dimension]) : 0;
        mesh::QuadMesh mesh = placed([&] { return mesh::QuadMesh::restore(dim, points, connectivity); });
        take_into(mesh.vertex_flags, "vflg");
        take_into(mesh.edge_flags, "eflg");
        take_into(mesh.face_flags, "fflg");
        const std::array<std::size_t, 3> n{mesh.vertex_flags.size(), mesh.edge_flags.size(),
                                           mesh.face_flags.size()};
        take_markers(mesh.vertex_marker, "vmrk", n[0]);
        take_markers(mesh.edge_marker, "emrk", n[1]);
        take_markers(mesh.face_marker, "fmrk", n[2]);
        return mesh;
    }

    void take_into(std::vector<std::uint8_t> &flags, const char *section) {
        const std::vector<std::uint8_t> found = from_.take<std::uint8_t>(section);
        constexpr std::uint8_t known = mesh::fixed | mesh::feature | mesh::corner | mesh::held;
        if (found.size() != flags.size() ||
            std::ranges::any_of(found, [](auto f) { return (f & ~known) != 0; }))
            from_.fail("flags are not one for each entity");
        std::ranges::copy(found, flags.begin());
    }

    void take_markers(Integers &markers, const char *section, std::size_t n) {
        markers = from_.take<std::int32_t>(section);
        if (!markers.empty() && markers.size() != n)
            from_.fail("markers are not one for each entity");
    }

    Entity entity(std::int32_t number) {
        if (number < 0 || number > 2)
            from_.fail("there is no kind of entity of number " + std::to_string(number));
        return static_cast<Entity>(number);
    }

    void read_names(Names &names) {
        const Integers ids = from_.take<std::int32_t>("nids");
        const std::vector<char> text = from_.take<char>("name");
        if (ids.size() % 3 != 0)
            from_.fail("names of markers are not whole");
        std::size_t done = 0;
        for (std::size_t i = 0; i < ids.size(); i += 3) {
            const std::int32_t length = ids[i + 2];
            if (length <= 0 || at(length) > text.size() - done || ids[i + 1] == 0)
                from_.fail("a name of a marker does not fit");
            names[{entity(ids[i]), ids[i + 1]}] = clean_name({text.data() + done, at(length)});
            done += at(length);
        }
    }

    void read_field(mesh::QuadMesh &mesh) {
        const Integers head = from_.take<std::int32_t>("fhed");
        const std::vector<char> name = from_.take<char>("fnam");
        if (head.size() != 3 || head[1] < 1 || head[2] < 0 ||
            head[2] > static_cast<int>(mesh::Carry::average))
            from_.fail("the head of a field is damaged");
        auto field = std::make_shared<mesh::Field>();
        field->entity = entity(head[0]);
        field->name.assign(name.begin(), name.end());
        field->components = head[1];
        field->carry = static_cast<mesh::Carry>(head[2]);
        field->values = from_.take<double>("fval");
        const int n = field->entity == Entity::vertex ? mesh.n_vertices()
                      : field->entity == Entity::edge ? mesh.n_edges()
                                                      : mesh.n_faces();
        if (field->values.size() != at(n) * at(field->components) || field->name.empty())
            from_.fail("a field has not one row for each entity");
        placed([&] { mesh::require_sound(*field); });
        mesh.fields.set(std::move(field));
    }

    std::vector<Vector3d> points(const char *section) {
        const std::vector<double> numbers = from_.take<double>(section);
        if (numbers.size() % 3 != 0 ||
            !std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }))
            from_.fail("points are not three finite numbers each");
        std::vector<Vector3d> result;
        result.reserve(numbers.size() / 3);
        for (std::size_t i = 0; i < numbers.size(); i += 3)
            result.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
        return result;
    }

    template <std::size_t width> std::vector<std::array<std::int32_t, width>> rows(const char *section) {
        const Integers numbers = from_.take<std::int32_t>(section);
        if (numbers.size() % width != 0)
            from_.fail("rows are not whole");
        std::vector<std::array<std::int32_t, width>> result(numbers.size() / width);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            result[i / width][i % width] = numbers[i];
        return result;
    }

    void read_reference(const std::vector<std::int64_t> &head, mesh::QuadMesh &mesh) {
        if (head[n_surfaces] != 0) {
            std::vector<Vector3d> of = points("spnt");
            std::vector<std::array<int, 3>> triangles = rows<3>("stri");
            mesh.surface = placed([&] {
                return std::make_shared<const surface::Surface>(std::move(of), std::move(triangles));
            });
        }
        if (head[n_curves] != 0) {
            const std::vector<Vector3d> ends = points("clin");
            std::vector<surface::Line> lines;
            for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
                lines.push_back({ends[i], ends[i + 1]});
            const std::vector<double> tolerance = from_.take<double>("ctol");
            if (tolerance.size() != 1 || !(tolerance[0] >= 0) || !std::isfinite(tolerance[0]))
                from_.fail("curves have no tolerance");
            mesh.curves = std::make_shared<const surface::Curves>(std::span<const Vector3d>(),
                                                                  std::span<const std::array<int, 2>>(),
                                                                  tolerance[0], std::move(lines));
        }
        if (head[n_boundaries] != 0)
            read_boundary(mesh);
    }

    void read_boundary(mesh::QuadMesh &mesh) {
        const Integers lengths = from_.take<std::int32_t>("blen");
        const std::vector<Vector3d> all = points("bpnt");
        std::vector<std::vector<Vector3d>> curves;
        std::size_t done = 0;
        for (const std::int32_t n : lengths) {
            if (n < 2 || at(n) > all.size() - done)
                from_.fail("curves of the boundary do not have these points");
            curves.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(done),
                                all.begin() + static_cast<std::ptrdiff_t>(done + at(n)));
            done += at(n);
        }
        mesh.boundary = std::make_shared<const surface::BoundaryCurves>(std::move(curves));
    }

    SectionReader from_;
};

} // namespace

std::string print_checkpoint(const mesh::QuadMesh &mesh, const History &history) {
    SectionWriter to;
    std::vector<std::int64_t> head(n_head);
    head[dimension] = mesh.dim();
    head[revision] = history.revision;
    head[last_revision] = history.last_revision;
    head[curve_numbers] = mesh.curve_numbers ? 1 : 0;
    head[n_fields] = std::distance(mesh.fields.begin(), mesh.fields.end());
    head[n_surfaces] = mesh.surface ? 1 : 0;
    head[n_curves] = mesh.curves ? 1 : 0;
    head[n_boundaries] = mesh.boundary ? 1 : 0;
    to.add("head", head);
    std::vector<double> points;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        points.insert(points.end(), mesh.point(v).data(), mesh.point(v).data() + 3);
    to.add("pnts", points);
    const mesh::QuadMesh::Connectivity connectivity = mesh.connectivity();
    to.add("face", connectivity.faces);
    to.add("side", connectivity.sides);
    to.add("frst", connectivity.first);
    to.add("vflg", mesh.vertex_flags);
    to.add("eflg", mesh.edge_flags);
    to.add("fflg", mesh.face_flags);
    to.add("vmrk", mesh.vertex_marker);
    to.add("emrk", mesh.edge_marker);
    to.add("fmrk", mesh.face_marker);
    add_names(to, mesh.names);
    for (const auto &field : mesh.fields) {
        to.add("fhed", Integers{static_cast<std::int32_t>(field->entity), field->components,
                                static_cast<std::int32_t>(field->carry)});
        to.add("fnam", letters(field->name));
        to.add("fval", field->values);
    }
    add_reference(to, mesh);
    to.add("cros", packed(history.crossed));
    to.add("splt", packed(history.split));
    return to.finished();
}

Checkpoint parse_checkpoint(std::string_view bytes) { return Reader(bytes).read(); }

} // namespace alphamst::io
