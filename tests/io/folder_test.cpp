// SPDX-License-Identifier: MIT
/// A folder of a run stays within itself, whatever was planted in it.
#include "io/folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "cli/files.h"
#include "freshet/error.h"

namespace freshet::test {
namespace {

/// A folder `run` beside a folder `outside` with a file.
class FolderTest : public ::testing::Test {
 protected:
  FolderTest() { write_text(base / "outside/victim", "precious"); }
  ~FolderTest() override {
    EXPECT_EQ(std::set<std::string>{"victim"}, files_below(base / "outside"));
    EXPECT_EQ("precious", read_text(base / "outside/victim"));
  }
  std::string text(const std::string& file) const { return read_text(base / "run" / file); }
  void link(const std::string& to, const std::string& name) const {
    fs::create_symlink(to, base / "run" / name);
  }
  const TemporaryFolder base;
  const Folder made{made_folder(base / "run")};
};

TEST_F(FolderTest, WritesAppendsReadsAndRemoves) {
  made.make_folder_of("a/b/c");
  made.write("a/b/c", "one");
  made.write("a/b/c", "two");
  EXPECT_EQ("two", made.read("a/b/c"));
  made.append("t", 0, "12");
  made.append("t", 2, "34");
  made.append("t", 3, "5");
  EXPECT_EQ("1235", text("t"));
  EXPECT_THROW(made.append("t", 9, "6"), Error);
  EXPECT_EQ("1235", text("t"));
  EXPECT_TRUE(made.holds("a/b/c") && made.holds("a") && !made.holds("a/b/d") && !made.holds("x/y"));
  made.remove("a/b/c");
  made.remove("a/b/c");
  made.remove("a");  // a folder
  EXPECT_FALSE(made.holds("a/b/c"));
  EXPECT_TRUE(made.holds("a/b"));
  EXPECT_FALSE(made.read("a/b/c"));
  EXPECT_FALSE(made.read("a"));
}

TEST_F(FolderTest, FollowsNoLinkToAFolder) {
  link("../outside", "frames");
  EXPECT_EQ("frames", made.link_in("frames/victim"));
  EXPECT_FALSE(made.holds("frames/victim"));
  EXPECT_FALSE(made.read("frames/victim"));
  made.remove("frames/victim");
  for (const char* name : {"frames/victim", "frames/new", "frames/new/deep"}) {
    EXPECT_THROW(made.write(name, "x"), Error) << name;
    EXPECT_THROW(made.append(name, 0, "x"), Error) << name;
    EXPECT_THROW(made.make_folder_of(name), Error) << name;
  }
  try {
    made.write("frames/new", "x");
  } catch (const Error& e) {
    EXPECT_TRUE(contains(e.what(), "a symbolic link is in the way")) << e.what();
  }
}

TEST_F(FolderTest, FollowsNoLinkToAFile) {
  for (const char* name : {"a", "a.part", "t", "u"}) link("../outside/victim", name);
  EXPECT_EQ("a", made.link_in("a"));
  EXPECT_EQ("", made.link_in("b"));
  EXPECT_TRUE(made.holds("a"));
  EXPECT_FALSE(made.read("a"));
  made.write("a", "mine");
  EXPECT_EQ("mine", text("a"));
  EXPECT_THROW(made.append("t", 3, "x"), Error);
  made.append("t", 0, "table");
  EXPECT_EQ("table", text("t"));
  made.remove("u");
  EXPECT_FALSE(made.holds("u"));
}

TEST_F(FolderTest, LeavesItByNoName) {
  for (const std::string& name :
       {std::string("../outside/victim"), std::string("a/../../outside/victim"),
        (base / "outside/victim").string(), std::string("..")}) {
    fs::create_directories(base / "run/a");
    EXPECT_THROW(made.write(name, "x"), Error) << name;
    EXPECT_THROW(made.append(name, 0, "x"), Error) << name;
    EXPECT_FALSE(made.read(name)) << name;
    made.remove(name);
  }
}

// Opening a pipe without a writer would wait for ever.
TEST_F(FolderTest, ReadsNoPipe) {
  ASSERT_EQ(0, mkfifo((base / "run/pipe").c_str(), 0600));
  EXPECT_FALSE(made.read("pipe"));
  EXPECT_THROW(made.append("pipe", 1, "x"), Error);
}

TEST_F(FolderTest, IsNamedWhereItIsMissing) {
  try {
    Folder none(base / "none");
    ADD_FAILURE() << "no error";
  } catch (const Error& e) {
    EXPECT_TRUE(contains(e.what(), "none: error: cannot open this folder: ")) << e.what();
  }
}

}  // namespace
}  // namespace freshet::test
