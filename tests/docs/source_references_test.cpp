// SPDX-License-Identifier: MIT
/// The code that the documentation quotes and the tests that it names must exist.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <tuple>

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

/// docs/*.md and the *.md files beside the README.
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
  std::string code;  ///< a line of the file contains it; empty if no code follows the link
  bool operator<(const Reference& o) const {
    return std::tie(file, code) < std::tie(o.file, o.code);
  }
};

/// Every link [`FILE`](FILE) to a source, with the `code` that follows within a few characters. A
/// table writes a bar within code as \|.
std::set<Reference> references(const std::string& text) {
  constexpr std::size_t near = 12;  // punctuation, a line break or a table's bar
  static const std::regex form(
      "\\[`([A-Za-z0-9_./-]+\\.(?:h|cpp|cu))`\\]\\((?:\\.\\./)?([^)]*)\\)");
  std::set<Reference> all;
  for (std::sregex_iterator it(text.begin(), text.end(), form), end; it != end; ++it) {
    Reference r{(*it)[2].str(), ""};
    const auto after = std::size_t(it->position() + it->length());
    const auto open = text.find('`', after), close = text.find('`', open + 1);
    if (open <= after + near && close != std::string::npos)
      r.code =
          std::regex_replace(text.substr(open + 1, close - open - 1), std::regex(R"(\\\|)"), "|");
    all.insert(r);
  }
  return all;
}

bool holds(const std::string& file, const std::string& code) {
  std::ifstream in(source / file);
  for (std::string line; std::getline(in, line);)
    if (line.find(code) != std::string::npos) return true;
  return false;
}

/// One message for each wrong reference in `text`.
std::vector<std::string> wrong(const std::string& text) {
  std::vector<std::string> all;
  for (const Reference& r : references(text))
    if (!fs::is_regular_file(source / r.file)) all.push_back(r.file + " does not exist");
    else if (!holds(r.file, r.code)) all.push_back(r.file + " does not hold `" + r.code + "`");
  return all;
}

TEST(SourceReferences, QuoteCodeThatExists) {
  for (const fs::path& document : documents())
    for (const std::string& complaint : wrong(read(document)))
      ADD_FAILURE() << document.filename().string() << ": " << complaint;
  EXPECT_GT(references(read(source / "docs/article.md")).size(), 20u);
}

TEST(SourceReferences, WrongReferencesAreFound) {
  const std::string name = "tests/docs/source_references_test.cpp";
  const std::string here = "[`" + name + "`](../" + name + ")";
  EXPECT_EQ(0u, wrong(here + ": `// SPDX-License-Identifier: MIT`").size());
  EXPECT_EQ(0u, wrong("| " + here + " | `SPDX` |").size());
  EXPECT_EQ(0u, wrong(here + " without code").size());
  EXPECT_EQ(1u, wrong(here + ": `no such "
                             "code`")
                    .size());
  EXPECT_EQ(1u, wrong("[`tests/docs/no_such_file.h`](../tests/docs/no_such_file.h) `x`").size());
}

TEST(SourceReferences, AreTheSameInBothLanguages) {
  for (const fs::path& document : documents()) {
    const std::string name = document.filename().string(), suffix = ".zh-CN.md";
    if (!name.ends_with(suffix)) continue;
    const std::string english = name.substr(0, name.size() - suffix.size()) + ".md";
    const auto theirs = references(read(document.parent_path() / english));
    const auto ours = references(read(document));
    for (const Reference& r : theirs)
      EXPECT_TRUE(ours.contains(r)) << name << " lacks " << r.file << " `" << r.code << "`";
    for (const Reference& r : ours)
      EXPECT_TRUE(theirs.contains(r)) << english << " lacks " << r.file << " `" << r.code << "`";
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

TEST(SourceReferences, NameArticleTestsThatExist) {
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
