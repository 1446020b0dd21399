// SPDX-License-Identifier: MIT
/// Folders and files for tests of the program.
#pragma once
#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace freshet::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline const fs::path source_dir = SOURCE_DIR;
inline const std::string article = (source_dir / "scenes/article.toml").string();

/// A folder that the destructor removes.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "freshet-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("cannot create a temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  fs::path operator/(const std::string& name) const { return path_ / name; }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

inline std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void write_text(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

inline std::string sha256(const std::string& bytes) {
  unsigned char digest[32];
  EVP_Digest(bytes.data(), bytes.size(), digest, nullptr, EVP_sha256(), nullptr);
  std::string hex;
  for (const unsigned char byte : digest) {
    hex += "0123456789abcdef"[byte >> 4];
    hex += "0123456789abcdef"[byte & 15];
  }
  return hex;
}

/// The files below a folder, relative to it.
inline std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory()) files.insert(fs::relative(entry.path(), folder).string());
  return files;
}

/// Expects that the manifest lists exactly the files of the folder, with their sizes and digests.
inline void expect_whole_run(const fs::path& folder) {
  const Json manifest = Json::parse(read_text(folder / "manifest.json"), nullptr, false);
  ASSERT_TRUE(manifest.is_object()) << read_text(folder / "manifest.json");
  std::set<std::string> expected{"manifest.json"};
  for (const Json& entry : manifest.at("files")) {
    const std::string name = entry.at("file"), bytes = read_text(folder / name);
    expected.insert(name);
    EXPECT_EQ(entry.at("bytes"), bytes.size()) << name;
    EXPECT_EQ(entry.at("sha256"), sha256(bytes)) << name;
  }
  EXPECT_EQ(files_below(folder), expected);
}

inline Json report_of(const fs::path& folder) {
  return Json::parse(read_text(folder / "report.json"));
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Arguments of a run of the article's scene for 50 steps, with `more` arguments.
inline std::vector<std::string> short_run(const fs::path& output,
                                          const std::vector<std::string>& more = {}) {
  std::vector<std::string> all{"run",           article, "--output",
                               output.string(), "--set", "time.end=0.05"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Arguments of a run of the article's scene that would take minutes, with `more` arguments.
inline std::vector<std::string> long_run(const fs::path& output,
                                         const std::vector<std::string>& more = {}) {
  auto all = short_run(output, more);
  all.insert(all.end(), {"--set", "time.end=500"});
  return all;
}

}  // namespace freshet::test
