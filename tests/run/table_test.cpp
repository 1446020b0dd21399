// SPDX-License-Identifier: MIT
#include "run/table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cli/files.h"
#include "freshet/error.h"

namespace freshet::test {
namespace {

Table read(const std::string& text) {
  const TemporaryFolder folder;
  write_text(folder / "table.csv", text);
  return read_table(folder / "table.csv");
}

/// The error message of reading this text, from the file's name on; empty without an error.
std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const Error& e) {
    EXPECT_EQ(Error::Kind::scene, e.kind());
    const std::string what = e.what();
    return what.substr(std::min(what.find("table.csv"), what.size()));
  }
  return "";
}

TEST(Table, HasNamesUnitsNumbersAndWords) {
  const Table t = read(
      "step,time [s],ruled by,\"force on a, \"\"b\"\" x [N/m]\"\n"
      "1,0.5,sound,-1e-3\r\n2,inf,7,+4\n");
  EXPECT_EQ(2u, t.rows);
  ASSERT_EQ(4u, t.columns.size());
  EXPECT_EQ("step", t.columns[0].name);
  EXPECT_EQ("", t.columns[0].unit);
  EXPECT_EQ((std::vector<double>{1, 2}), t.columns[0].numbers);
  EXPECT_EQ("s", t.find("time")->unit);
  EXPECT_EQ((std::vector<double>{0.5, INFINITY}), t.find("time")->numbers);
  EXPECT_FALSE(t.find("time")->of_words());
  EXPECT_EQ((std::vector<std::string>{"sound", "7"}), t.find("ruled by")->words);
  EXPECT_TRUE(t.find("ruled by")->numbers.empty());
  ASSERT_TRUE(t.find("force on a, \"b\" x"));
  EXPECT_EQ("N/m", t.columns[3].unit);
  EXPECT_EQ((std::vector<double>{-1e-3, 4}), t.columns[3].numbers);
  EXPECT_EQ(nullptr, t.find("speed"));
}

TEST(Table, SkipsAnIncompleteLastLine) {
  EXPECT_EQ(1u, read("step,time [s]\n1,0.5\n2,0.2").rows);
  EXPECT_EQ(0u, read("step,time [s]\n1,0").rows);
  EXPECT_EQ(0u, read("step,time [s]\n").rows);
}

TEST(Table, ErrorsNameTheLine) {
  const std::string no_line = "the file has no complete line; the first must name the columns";
  EXPECT_EQ("table.csv:1: error: " + no_line, error_of(""));
  EXPECT_EQ("table.csv:1: error: " + no_line, error_of("step,time [s]"));
  EXPECT_EQ("table.csv:2: error: " + no_line, error_of("# a comment\n"));
  EXPECT_EQ("table.csv:3: error: 1 value instead of 2; write one per column",
            error_of("step,time [s]\n1,2\n3\n4,5\n"));
  EXPECT_EQ("table.csv:2: error: 3 values instead of 2; write one per column",
            error_of("step,time [s]\n1,2,3\n"));
}

/// The file may be another than a table, with contents that no message may show.
TEST(Table, ErrorsContainNoFields) {
  const std::string not_a_number =
      "value 2 is not a number, and its column has a unit; write numbers only, or name the column "
      "without a unit";
  EXPECT_EQ("table.csv:3: error: " + not_a_number, error_of("step,time [s]\n1,2\n2,secret\n"));
  EXPECT_EQ("table.csv:4: error: " + not_a_number,
            error_of("# a comment\nstep,time [s]\n1,2\n2,secret\n"));
}

TEST(Table, RejectsMissingFilesAndFolders) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_table(folder / "nothing.csv"), Error);
  EXPECT_THROW(read_table(folder.path()), Error);
}

}  // namespace
}  // namespace freshet::test
