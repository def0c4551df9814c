// Files of the format FORMAT with any bytes: a mesh in order, which can be written and read again, or a
// failure that says why.
#include <string>
#include <unistd.h>

#include "bytes.h"

using namespace alphamst::fuzz;

namespace {

// A file in memory, where there is one.
std::string scratch(const char *name, const std::string &extension) {
    const char *folder = access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp";
    return std::string(folder) + "/alphamst_fuzz_" + std::to_string(getpid()) + "_" + name + "." + extension;
}

void write_bytes(const std::string &path, const std::uint8_t *data, std::size_t size) {
    std::FILE *file = std::fopen(path.c_str(), "wb");
    require(file != nullptr && std::fwrite(data, 1, size, file) == size, "the disk has room");
    std::fclose(file);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    static const std::string format = FORMAT;
    static const std::string given = scratch("given", format),
                             written =
                                 scratch("written", format == "inp" ? "msh" : format); // .inp is only read
    static amst_context *const context = [] {
        amst_context *made = nullptr;
        require(amst_context_create(0, &made) == AMST_OK, "there are contexts");
        return made;
    }();
    write_bytes(given, data, size);
    amst_mesh *mesh = nullptr, *again = nullptr;
    const amst_status status = amst_mesh_read(context, given.c_str(), nullptr, &mesh);
    if (status < 0) {
        require(mesh == nullptr, "a failure writes no handle");
        require(amst_last_error()[0] != 0, "a failure has words");
        return 0;
    }
    is_valid(mesh);
    require(amst_mesh_write(mesh, written.c_str()) >= AMST_OK, "what was read can be written");
    require(amst_mesh_read(context, written.c_str(), nullptr, &again) >= AMST_OK,
            "what was written can be read");
    for (const std::int32_t entity : {AMST_VERTEX, AMST_EDGE, AMST_FACE})
        require(count(again, entity) == count(mesh, entity), "a file keeps vertices, edges and faces");
    amst_mesh_destroy(again);
    amst_mesh_destroy(mesh);
    return 0;
}
