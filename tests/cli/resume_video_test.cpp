// SPDX-License-Identifier: MIT
/// The video of a run that is resumed.
#include "cli/resume.h"

namespace freshet::test {
namespace {

class ResumeVideo : public Resume {
 protected:
  void SetUp() override {
    const auto r = freshet(arguments("whole", video("whole.gif")));
    if (r.code == 2 && contains(r.err, "ffmpeg")) GTEST_SKIP() << r.err;
    ASSERT_EQ(r.code, 0) << r.err;
    ASSERT_EQ(freshet(arguments("run", video("run.gif", {"--set", "time.end=0.1"}))).code, 0);
  }
  std::vector<std::string> video(const std::string& name,
                                 std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--video", (folder / name).string(), "--fps", "50", "--speed", "0.5"});
    return more;
  }
};

TEST_F(ResumeVideo, Continues) {
  EXPECT_NE(read_text(folder / "whole.gif"), read_text(folder / "run.gif"));
  const auto r = resume("run", {"--set", "time.end=0.25"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_TRUE(contains(r.out, "run.gif")) << r.out;
  EXPECT_TRUE(read_text(folder / "whole.gif") == read_text(folder / "run.gif"));
  expect_same_run("whole", "run");
}

TEST_F(ResumeVideo, GoesToAnotherFileIfAsked) {
  const std::string before = read_text(folder / "run.gif");
  const std::string taken = (folder / "whole.gif").string(), free = (folder / "new.gif").string();
  const auto rejected = resume("run", {"--set", "time.end=0.25", "--video", taken});
  EXPECT_EQ(rejected.code, 2);
  EXPECT_TRUE(contains(rejected.err, "exists")) << rejected.err;
  ASSERT_EQ(resume("run", {"--set", "time.end=0.25", "--video", free}).code, 0);
  EXPECT_TRUE(read_text(taken) == read_text(free));
  EXPECT_EQ(before, read_text(folder / "run.gif"));
}

TEST_F(ResumeVideo, StartsAnewWithoutItsPictures) {
  fs::remove_all(folder / "run/video");
  const auto r = resume("run", {"--set", "time.end=0.25"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.err, "run/video: warning: the pictures of the video are missing"))
      << r.err;
  EXPECT_FALSE(read_text(folder / "whole.gif") == read_text(folder / "run.gif"));
}

}  // namespace
}  // namespace freshet::test
