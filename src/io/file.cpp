#include "io/file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "failure.h"

namespace alphamst::io {
namespace {

namespace fs = std::filesystem;

// C streams, not C++ streams: these alone can refuse to open a file that exists
// ("x"), and their errno is the reason.
struct Close {
    void operator()(std::FILE *file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

File open(const fs::path &path, const char *mode) {
#ifdef _WIN32
    const std::wstring wide(mode, mode + std::char_traits<char>::length(mode));
    return File(_wfopen(path.c_str(), wide.c_str()));
#else
    return File(std::fopen(path.c_str(), mode));
#endif
}

[[noreturn]] void fail(const char *verb, const std::string &path, const std::string &reason) {
    std::string shown = path; // braces would stand for an id in a failure
    std::replace(shown.begin(), shown.end(), '{', '(');
    std::replace(shown.begin(), shown.end(), '}', ')');
    throw Failure(Fault::io, std::string("cannot ") + verb + " " + shown + ": " + reason);
}

[[noreturn]] void fail(const char *verb, const std::string &path, int error) {
    fail(verb, path, std::generic_category().message(error != 0 ? error : EIO));
}

fs::path from_utf8(const char *verb, const std::string &path) {
    if (path.empty() || path.find('\0') != std::string::npos)
        fail(verb, path.substr(0, path.find('\0')), ENOENT);
    return fs::path(std::u8string(path.begin(), path.end()));
}

// Tries path.part, path.part1, ... until one is free.
File create_beside(const fs::path &target, fs::path &part, int &error) {
    for (int i = 0; i < 100; ++i) {
        part = target;
        part += i == 0 ? ".part" : ".part" + std::to_string(i);
        errno = 0;
        File file = open(part, "wbx");
        error = errno;
        if (file || error != EEXIST)
            return file;
    }
    return nullptr;
}

} // namespace

std::string load(const std::string &path) {
    const fs::path from = from_utf8("read", path);
    std::error_code error;
    const fs::file_status status = fs::status(from, error);
    if (!fs::exists(status))
        fail("read", path, status.type() == fs::file_type::not_found ? ENOENT : error.value());
    if (fs::is_directory(status))
        fail("read", path, EISDIR);
    // A device or pipe may never end.
    if (!fs::is_regular_file(status))
        fail("read", path, "not a regular file");
    errno = 0;
    const File file = open(from, "rb");
    if (!file)
        fail("read", path, errno);
    std::string bytes;
    const std::uintmax_t size = fs::file_size(from, error);
    std::size_t step = error ? 65536 : static_cast<std::size_t>(size) + 1;
    for (;;) {
        const std::size_t before = bytes.size();
        bytes.resize(before + step);
        errno = 0;
        const std::size_t n = std::fread(bytes.data() + before, 1, step, file.get());
        bytes.resize(before + n);
        if (std::ferror(file.get()))
            fail("read", path, errno);
        if (n < step)
            return bytes;
        step = 65536;
    }
}

void save(const std::string &path, std::string_view bytes) {
    fs::path target = from_utf8("write", path);
    std::error_code error;
    if (fs::is_symlink(target, error)) { // write to where it leads, do not replace the link
        target = fs::weakly_canonical(target, error);
        if (error)
            fail("write", path, error.value());
    }
    const fs::file_status status = fs::status(target, error);
    const bool exists = fs::exists(status);
    if (fs::is_directory(status))
        fail("write", path, EISDIR);
    if (exists && !fs::is_regular_file(status))
        fail("write", path, "not a regular file");
    errno = 0;
    if (exists && !open(target, "r+b")) // renaming would get round write protection
        fail("write", path, errno);

    fs::path part;
    int reason = 0;
    File file = create_beside(target, part, reason);
    if (!file)
        fail("write", path, reason);
    errno = 0;
    bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                   std::fflush(file.get()) == 0;
    reason = errno;
    errno = 0;
    if (std::fclose(file.release()) != 0 && written) { // a full disk may show only here
        written = false;
        reason = errno;
    }
    if (written) {
        if (exists)
            fs::permissions(part, status.permissions(), error); // a wish, not a must
        fs::rename(part, target, error);
        written = !error;
        reason = error.value();
    }
    if (!written) {
        fs::remove(part, error);
        fail("write", path, reason);
    }
}

} // namespace alphamst::io
