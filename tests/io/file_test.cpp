#include "io/file.h"

#include <gtest/gtest.h>

#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

TEST(File, SavesAndLoads) {
    const samples::Folder folder;
    const std::string path = folder / "\xc3\xa4{}.off", bytes("a\0b\r\n\xff", 6);
    save(path, "old and longer");
    save(path, bytes);
    EXPECT_EQ(load(path), bytes);
    EXPECT_EQ(folder.size(), 1u); // no .part is left
    save(path, "");
    EXPECT_EQ(load(path), "");
}

TEST(File, TellsTheReason) {
    const samples::Folder folder;
    for (const std::string &path : {folder / "none", folder / "none/none", std::string()}) {
        const Failure failure = failure_of([&] { load(path); });
        EXPECT_EQ(failure.fault, Fault::io);
        EXPECT_NE(std::string(failure.what()).find("No such file"), std::string::npos) << failure.what();
    }
    EXPECT_NE(std::string(failure_of([&] { load(folder / "."); }).what()).find("directory"),
              std::string::npos);
    EXPECT_EQ(failure_of([&] { save(folder / ".", "x"); }).fault, Fault::io);
    EXPECT_EQ(failure_of([&] { save(folder / "none/x", "x"); }).fault, Fault::io);
    EXPECT_EQ(failure_of([&] { save("", "x"); }).fault, Fault::io);
    // Braces in a path must not be taken for an id.
    EXPECT_EQ(std::string(failure_of([&] { load(folder / "{}"); }).what()).find('{'), std::string::npos);
}

TEST(File, GetsPastAPartThatSomebodyLeft) {
    const samples::Folder folder;
    save(folder / "x.part", "left");
    save(folder / "x", "new");
    EXPECT_EQ(load(folder / "x"), "new");
    EXPECT_EQ(load(folder / "x.part"), "left");
}

#ifndef _WIN32
TEST(File, WritesThroughALink) {
    const samples::Folder folder;
    save(folder / "x", "old");
    std::filesystem::create_symlink("x", folder / "link");
    save(folder / "link", "new");
    EXPECT_EQ(load(folder / "x"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
}

TEST(File, RefusesWhatMayNeverEnd) {
    EXPECT_EQ(failure_of([] { load("/dev/zero"); }).fault, Fault::io);
    EXPECT_EQ(failure_of([] { save("/dev/null", "x"); }).fault, Fault::io);
}
#endif

} // namespace
} // namespace alphamst::io
