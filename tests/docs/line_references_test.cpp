// SPDX-License-Identifier: MIT
/// The documentation quotes lines of the sources and names tests. Both move; this says where.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace freshet {
namespace {

namespace fs = std::filesystem;
const fs::path source = SOURCE_DIR;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Those of docs/*.md and README*.md.
std::vector<fs::path> documents() {
  std::vector<fs::path> files;
  for (const fs::path& folder : {source, source / "docs"})
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".md") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

struct Reference {
  std::string file;
  int line;
  std::string code;  ///< as it must stand on that line; empty if none follows
  std::string text() const { return file + ":" + std::to_string(line); }
  bool operator<(const Reference& o) const { return text() + code < o.text() + o.code; }
};

/// Every `FOLDER/FILE:LINE` whose folder is one of ours, and the `code` a few characters after it.
/// In a table a bar within code is written \|.
std::set<Reference> references(const std::string& text) {
  constexpr std::size_t near = 12;  // room for punctuation, a line break, a table's bar
  static const std::regex form("`([A-Za-z0-9_]+)(/[A-Za-z0-9_./-]+):([0-9]+)`");
  std::set<Reference> all;
  for (std::sregex_iterator it(text.begin(), text.end(), form), end; it != end; ++it) {
    if (!fs::is_directory(source / (*it)[1].str())) continue;
    Reference r{(*it)[1].str() + (*it)[2].str(), std::stoi((*it)[3]), ""};
    const auto after = std::size_t(it->position() + it->length());
    const auto open = text.find('`', after), close = text.find('`', open + 1);
    if (open <= after + near && close != std::string::npos)
      r.code =
          std::regex_replace(text.substr(open + 1, close - open - 1), std::regex(R"(\\\|)"), "|");
    all.insert(r);
  }
  return all;
}

std::string line_of(const std::string& file, int number) {
  std::ifstream in(source / file);
  std::string line;
  for (int k = 0; k < number; ++k)
    if (!std::getline(in, line)) return "";
  return line;
}

/// Where the code stands now, for whoever has to mend the reference.
std::string found_at(const Reference& r) {
  std::ifstream in(source / r.file);
  std::string at, line;
  for (int k = 1; std::getline(in, line); ++k)
    if (line.find(r.code) != std::string::npos) at += " " + std::to_string(k);
  return at.empty() ? "it stands nowhere in the file" : "it stands on line" + at;
}

/// A line for each reference in `text` that is wrong.
std::vector<std::string> wrong(const std::string& text) {
  std::vector<std::string> all;
  for (const Reference& r : references(text))
    if (r.code.empty()) all.push_back(r.text() + " is not followed by its code in backticks");
    else if (!fs::is_regular_file(source / r.file)) all.push_back(r.text() + " is no file");
    else if (line_of(r.file, r.line).find(r.code) == std::string::npos)
      all.push_back(r.text() + " does not hold `" + r.code + "`: " + found_at(r));
  return all;
}

TEST(LineReferences, PointAtTheirCode) {
  for (const fs::path& document : documents())
    for (const std::string& complaint : wrong(read(document)))
      ADD_FAILURE() << document.filename().string() << ": " << complaint;
  EXPECT_GT(references(read(source / "docs/article.md")).size(), 20u);
}

TEST(LineReferences, AreChecked) {
  const std::string here = "`tests/docs/line_references_test.cpp:";
  EXPECT_EQ(0u, wrong(here + "1`: `// SPDX-License-Identifier: MIT`").size());
  EXPECT_EQ(0u, wrong("| " + here + "1` | `SPDX` |").size());
  EXPECT_EQ(1u, wrong(here + "2`: `SPDX`").size());
  EXPECT_EQ(1u, wrong(here + "99999`: `SPDX`").size());
  EXPECT_EQ(1u, wrong(here + "1` and then much else, and only then `SPDX`").size());
  EXPECT_EQ(1u, wrong("`tests/docs/no_such_file.h:1` `x`").size());
  EXPECT_EQ(0u, wrong("`my/scene.toml:1` is a place in no folder of ours").size());
}

TEST(LineReferences, AreTheSameInBothLanguages) {
  for (const fs::path& document : documents()) {
    const std::string name = document.filename().string(), suffix = ".zh-CN.md";
    if (!name.ends_with(suffix)) continue;
    const std::string english = name.substr(0, name.size() - suffix.size()) + ".md";
    const auto theirs = references(read(document.parent_path() / english));
    const auto ours = references(read(document));
    for (const Reference& r : theirs)
      EXPECT_TRUE(ours.contains(r)) << name << " lacks " << r.text() << " `" << r.code << "`";
    for (const Reference& r : ours)
      EXPECT_TRUE(theirs.contains(r)) << english << " lacks " << r.text() << " `" << r.code << "`";
  }
}

/// `Suite.Name` of every test in tests/.
std::set<std::string> tests() {
  static const std::regex form(R"(TEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(source / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = read(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), form), end; it != end; ++it)
      names.insert((*it)[1].str() + "." + (*it)[2].str());
  }
  return names;
}

TEST(LineReferences, NameTestsThatExist) {
  static const std::regex form("`(Article[A-Za-z0-9]*\\.[A-Za-z0-9]+)`");
  const std::set<std::string> existing = tests();
  for (const fs::path& document : documents()) {
    const std::string text = read(document);
    for (std::sregex_iterator it(text.begin(), text.end(), form), end; it != end; ++it)
      EXPECT_TRUE(existing.contains((*it)[1])) << document.filename() << " names " << (*it)[1];
  }
}

}  // namespace
}  // namespace freshet
