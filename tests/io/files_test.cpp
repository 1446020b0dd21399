// SPDX-License-Identifier: MIT
#include "io/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "core/sha256.h"
#include "freshet/error.h"

namespace freshet {
namespace {

TEST(Sha256, GivesTheDigestOfTheStandardsExample) {  // FIPS 180-4, "abc"
  Sha256 sha;
  sha.add("ab", 2);
  sha.add("c", 1);
  EXPECT_EQ("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad", sha.hex());
}

TEST(WriteFile, ReplacesAFileAndLeavesNoPartialFile) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "freshet_files_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  write_file(folder / "a", "one");
  write_file(folder / "a", "two");
  std::string text;
  std::ifstream(folder / "a") >> text;
  EXPECT_EQ("two", text);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.part"));
  EXPECT_THROW(write_file(folder / "a" / "b", "three"), Error);  // a is not a folder
  std::filesystem::create_directories(folder / "full" / "x");
  EXPECT_THROW(write_file(folder / "full", "four"), Error);  // full is a folder
  EXPECT_FALSE(std::filesystem::exists(folder / "full.part"));
}

TEST(WriteFile, ReplacesAPartialFileAndFollowsNoLink) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "freshet_files_links_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto text_of = [&](const char* name) {
    std::string text;
    std::getline(std::ifstream(folder / name), text);
    return text;
  };
  std::ofstream(folder / "victim") << "precious";
  std::ofstream(folder / "a.part") << "of a run that was killed";
  write_file(folder / "a", "one");
  EXPECT_EQ("one", text_of("a"));
  std::filesystem::create_symlink("victim", folder / "b.part");
  std::filesystem::create_symlink("victim", folder / "b");
  write_file(folder / "b", "two");
  EXPECT_EQ("two", text_of("b"));
  EXPECT_FALSE(std::filesystem::is_symlink(folder / "b"));
  std::filesystem::create_hard_link(folder / "victim", folder / "c.part");
  write_file(folder / "c", "three");
  EXPECT_EQ("three", text_of("c"));
  EXPECT_EQ("precious", text_of("victim"));
  EXPECT_EQ(4, std::distance(std::filesystem::directory_iterator(folder), {}));
}

/// The rename would replace /dev/null, for root, and every FIFO.
TEST(WriteFile, ReplacesNoPipeAndNoDevice) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "freshet_files_pipe_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  ASSERT_EQ(0, ::mkfifo((folder / "pipe").c_str(), 0600));
  std::filesystem::create_symlink("/dev/null", folder / "null");
  const auto refusal = [&](const char* name) -> std::string {
    try {
      write_file(folder / name, "one");
    } catch (const Error& e) {
      return e.what();
    }
    return "written";
  };
  EXPECT_NE(std::string::npos, refusal("pipe").find("this is a named pipe (FIFO)"));
  EXPECT_NE(std::string::npos, refusal("null").find("this is a device"));
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "null"));
  EXPECT_EQ(2, std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace
}  // namespace freshet
