#include <metis.h>
#include <mutex>

#include "patch/decompose.h"

namespace alphamst::patch {
namespace {

std::vector<std::size_t> metis(const FaceDual &dual, std::size_t n, std::uint64_t seed) {
    if (n == 1)
        return std::vector<std::size_t>(dual.size(), 0);
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = static_cast<idx_t>(seed & 0x7fffffff);
    options[METIS_OPTION_CONTIG] = 1;
    idx_t nodes = static_cast<idx_t>(dual.size()), constraints = 1, wanted = static_cast<idx_t>(n), cut = 0;
    std::vector<idx_t> group(dual.size()), start(dual.start.begin(), dual.start.end()),
        links(dual.links.begin(), dual.links.end());
    static std::mutex alone; // METIS draws from the random numbers of the C library
    const std::lock_guard lock(alone);
    if (METIS_PartGraphKway(&nodes, &constraints, start.data(), links.data(), nullptr, nullptr, nullptr,
                            &wanted, nullptr, nullptr, options, &cut, group.data()) != METIS_OK)
        throw Failure(Fault::internal, "METIS could not partition the mesh");
    return std::vector<std::size_t>(group.begin(), group.end());
}

} // namespace

Groups partition(const mesh::QuadMesh &mesh, double size, std::uint64_t seed, Taken taken) {
    // METIS makes empty parts, and prints that it does, where parts are of a few nodes.
    return decompose(mesh, size, taken, [&](const FaceDual &dual, std::size_t n) {
        return dual.size() < 8 * n ? lloyd(dual, n, seed) : metis(dual, n, seed);
    });
}

} // namespace alphamst::patch
