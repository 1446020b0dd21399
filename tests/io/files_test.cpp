// SPDX-License-Identifier: MIT
#include "io/files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "freshet/error.h"
#include "core/sha256.h"

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

}  // namespace
}  // namespace freshet
