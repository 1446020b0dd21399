// SPDX-License-Identifier: MIT
#include "core/input_file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <functional>

#include "cli/files.h"
#include "freshet/scene.h"
#include "io/checkpoint.h"
#include "io/frame_files.h"
#include "io/run_folder.h"
#include "mesh/triangle_mesh.h"
#include "run/table.h"
#include "scene/model/body_motion.h"
#include "scene/sample/point_cloud.h"

namespace freshet::test {
namespace {

std::string message_of(const std::function<void()>& read) {
  try {
    read();
    return "read without an error";
  } catch (const Error& e) {
    return e.diagnostics().front().message;
  }
}

const InputFile rules{.noun = "thing", .remedy = "name a thing"};

TEST(ReadInput, ReturnsAllBytes) {
  const TemporaryFolder folder;
  std::string bytes(200000, 'a');
  bytes[70000] = '\0';
  write_text(folder / "a", bytes);
  EXPECT_TRUE(bytes == read_input(folder / "a"));
  fs::create_symlink(folder / "a", folder / "link");
  EXPECT_TRUE(bytes == read_input(folder / "link"));
}

TEST(ReadInput, ReportsWhatIsWrongWithAPath) {
  const TemporaryFolder folder;
  const auto refused = [&](const fs::path& file) {
    return message_of([&] { read_input(file, rules); });
  };
  EXPECT_EQ("no such thing; check the path", refused(folder / "none"));
  write_text(folder / "a", "");
  EXPECT_EQ("no such thing; check the path", refused(folder / "a/b"));
  EXPECT_EQ("this file is empty; name a thing", refused(folder / "a"));
  EXPECT_EQ("", read_input(folder / "a", {.may_be_empty = true}));
  EXPECT_EQ("this is a folder; name a thing", refused(folder.path()));
  EXPECT_EQ("not a regular file but a device; name a thing", refused("/dev/zero"));
  ASSERT_EQ(0, ::mkfifo((folder / "fifo").c_str(), 0600));
  EXPECT_EQ("not a regular file but a named pipe (FIFO); name a thing", refused(folder / "fifo"));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, (folder / "socket").c_str(), sizeof address.sun_path - 1);
  const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(0, ::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address));
  EXPECT_EQ("not a regular file but a socket; name a thing", refused(folder / "socket"));
  ::close(fd);
}

TEST(ReadInput, ReportsAFileThatItMayNotRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read every file";
  const TemporaryFolder folder;
  write_text(folder / "a", "x");
  fs::permissions(folder / "a", fs::perms::none);
  EXPECT_EQ("cannot be read: Permission denied; check its permissions, or name a thing",
            message_of([&] { read_input(folder / "a", rules); }));
}

TEST(ReadInput, RejectsAFileThatIsTooLarge) {
  const TemporaryFolder folder;
  write_text(folder / "a", "");
  const InputFile small{.noun = "thing", .remedy = "name a thing", .largest = 1 << 20};
  fs::resize_file(folder / "a", 1 << 20);
  EXPECT_EQ(1u << 20, read_input(folder / "a", small).size());
  fs::resize_file(folder / "a", (1 << 20) + 1);
  EXPECT_EQ("larger than 1 MiB, the maximum of a thing; name a thing",
            message_of([&] { read_input(folder / "a", small); }));
}

// A reader that opens a FIFO waits for a writer, and this test does not end.
TEST(ReadInput, EveryReaderRejectsAFifo) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& name, const std::function<void(fs::path)>& read,
                           const char* why = "not a regular file but a named pipe") {
    const fs::path file = folder / name;
    fs::create_directories(file.parent_path());
    ASSERT_EQ(0, ::mkfifo(file.c_str(), 0600)) << name;
    EXPECT_TRUE(contains(message_of([&] { read(file); }), why)) << name;
  };
  refused("scene.toml", [](const fs::path& file) { load_scene(file); });
  refused("points.csv", [](const fs::path& file) { read_points(file, 2); });
  refused("points.vtk", [](const fs::path& file) { read_points(file, 3); });
  refused("mesh.ply", [](const fs::path& file) { read_mesh(file); });
  refused("mesh.stl", [](const fs::path& file) { read_mesh(file); });
  refused("motion.csv", [](const fs::path& file) { read_body_path(file, 2); });
  refused("table.csv", [](const fs::path& file) { read_table(file); });
  refused("frame.h5", [](const fs::path& file) { read_frame(file); });
  refused("step.h5", [](const fs::path& file) { read_checkpoint(file); });
  refused(
      "run/manifest.json",
      [](const fs::path& file) {
        RunFolder run(FolderLock::of_new(file.parent_path()));
        run.take(RunFolder::Take::overwrite, {}, {});
      },
      "not a manifest of Freshet");
}

}  // namespace
}  // namespace freshet::test
