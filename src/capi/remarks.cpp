#include "capi/remarks.h"

#include <string>

#include "mesh/components.h"
#include "mesh/hanging.h"

namespace alphamst::capi {
namespace {

using Edge = std::array<std::int32_t, 2>;

// "between vertices 3 and 4"
std::string between(const Edge &edge, int base) {
    return "between vertices " + std::to_string(edge[0] + base) + " and " + std::to_string(edge[1] + base);
}

std::string edges_without_length(const mesh::QuadMesh &mesh, int base) {
    std::int64_t n = 0;
    Edge first{};
    for (int e = 0; e < mesh.n_edges(); ++e)
        if (const auto [v, w] = mesh.edge_vertices(e); mesh.point(v) == mesh.point(w) && n++ == 0)
            first = {v, w};
    return n == 0 ? ""
                  : std::to_string(n) + (n == 1 ? " edge has" : " edges have") +
                        " no length, the first of them " + between(first, base) +
                        ": faces there are flat; make one vertex of the two, if that is no pole";
}

std::string hanging_vertices(const mesh::QuadMesh &mesh, int base) {
    std::vector<Edge> edges;
    for (int e = 0; e < mesh.n_edges(); ++e)
        if (const auto [left, right] = mesh.edge_faces(e); left < 0 || right < 0)
            edges.push_back(mesh.edge_vertices(e));
    std::vector<double> points;
    points.reserve(3 * static_cast<std::size_t>(mesh.n_vertices()));
    for (int v = 0; v < mesh.n_vertices(); ++v)
        points.insert(points.end(), mesh.point(v).data(), mesh.point(v).data() + 3);
    const std::vector<mesh::Hanging> hanging = mesh::find_hanging(points, edges);
    if (hanging.empty())
        return "";
    const auto &[vertex, edge] = hanging.front();
    return std::to_string(hanging.size()) + (hanging.size() == 1 ? " vertex hangs" : " vertices hang") +
           " in the middle of an edge, the first of them vertex " + std::to_string(vertex + base) + " " +
           between(edges[edge], base) +
           ": the mesh has a slit there, whose sides are boundary; divide the larger face, or join the "
           "smaller ones, so that faces at both sides have the same vertices";
}

std::string lone_faces(const mesh::QuadMesh &mesh) {
    const int n = mesh::count_lone_faces(mesh);
    return n < 2 ? ""
                 : std::to_string(n) +
                       " components of one face: these share no edge with another one; if they lie side by "
                       "side, make one vertex of those at the same place (weld them) first";
}

} // namespace

void say_turned(const Context &context, const char *call, const mesh::Oriented &oriented,
                std::int64_t n_faces) {
    if (oriented.n_turned > 0)
        context.say(AMST_LOG_WARNING,
                    std::string(call) + ": " + std::to_string(oriented.n_turned) + " of " +
                        std::to_string(n_faces) +
                        " faces ran the other way round and were turned over, the first of them face " +
                        std::to_string(oriented.first_turned + context.index_base));
}

void say_oddities(const Context &context, const char *call, const mesh::QuadMesh &mesh) {
    if (context.log == nullptr || context.log_level < AMST_LOG_WARNING)
        return;
    for (const std::string &remark : {lone_faces(mesh), hanging_vertices(mesh, context.index_base),
                                      edges_without_length(mesh, context.index_base)})
        if (!remark.empty())
            context.say(AMST_LOG_WARNING, std::string(call) + ": " + remark);
}

} // namespace alphamst::capi
