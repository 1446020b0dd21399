// SPDX-License-Identifier: MIT
#include "io/run_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "commit.h"
#include "freshet/error.h"
#include "freshet/version.h"
#include "io/files.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* manifest_name = "manifest.json";
constexpr std::string_view running = "running";
/// Written over `"running",` in a manifest, as many bytes.
constexpr std::string_view failed_word = "\"failed\", ";

/// The manifest of an earlier run. Files that are not plain paths below the folder are ignored.
struct Manifest {
  std::string state;
  std::set<std::string> files;
};

Manifest read_manifest(const fs::path& manifest) {
  Manifest m;
  const Json json = Json::parse(std::ifstream(manifest), nullptr, false);
  const auto refuse = [&] {
    throw Error(Error::Kind::scene, manifest.string(),
                "not a manifest of Freshet; remove the folder by hand or choose another `output`",
                {"output"});
  };
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) refuse();
  if (json.contains("state") && json["state"].is_string()) m.state = json["state"];
  for (const Json& file : json["files"]) {
    const Json entry = file.is_object() ? file.value("file", Json("")) : file;
    if (!entry.is_string()) refuse();
    const std::string name = entry;
    const fs::path path = fs::path(name).lexically_normal();
    if (!name.empty() && path.is_relative() && *path.begin() != "..") m.files.insert(name);
  }
  return m;
}

fs::path made(const fs::path& folder) {
  std::error_code ec;
  fs::create_directories(folder, ec);
  if (ec) fail_file(folder, "make this folder", ec.value());
  return folder;
}

std::string digest_of(std::string_view bytes) {
  Sha256 sha;
  sha.add(bytes.data(), bytes.size());
  return sha.hex();
}

/// A JSON string; bytes that are not UTF-8 are replaced.
std::string json_string(std::string_view text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string read_whole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

FolderLock::FolderLock(fs::path folder) : folder_(std::move(folder)) {
  fd_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd_ < 0) fail_file(folder_, "open this folder", errno);
  if (::flock(fd_, LOCK_EX | LOCK_NB) == 0) return;
  ::close(fd_);
  throw Error(Error::Kind::scene, folder_.string(),
              "another run is writing into this folder; wait for it or choose another `output`",
              {"output"});
}

FolderLock::~FolderLock() {
  if (fd_ >= 0) ::close(fd_);
}

FolderLock FolderLock::of_new(const fs::path& folder) { return FolderLock(made(folder)); }

void RunFolder::take(Take how, const std::vector<std::string>& planned, Provenance provenance) {
  planned_ = {planned.begin(), planned.end()};
  provenance_ = std::move(provenance);
  clear(how);
  make_places(planned);
  manifest_ = path() / manifest_name;
  write_manifest(running, planned_);
}

void RunFolder::make_places(const std::vector<std::string>& files) const {
  for (const std::string& file : files) made((path() / file).parent_path());
}

/// Removes the files of an earlier run. If the run is resumed, only its partial files are removed.
void RunFolder::clear(Take take) {
  const fs::path manifest = path() / manifest_name;
  Manifest old;
  if (fs::exists(manifest)) {
    if (take == Take::empty)
      throw Error(Error::Kind::scene, path().string(),
                  "this folder holds a run; `overwrite` replaces it (only the files that its "
                  "manifest.json names), resume it, or choose another `output`",
                  {"overwrite", "output"});
    old = read_manifest(manifest);
  }
  for (const std::string& file : planned_)
    if (fs::exists(path() / file) && !old.files.contains(file))
      throw Error(Error::Kind::scene, (path() / file).string(),
                  "this file was not written by a run, and the run would replace it; move it or "
                  "choose another `output`",
                  {"output"});
  std::error_code ignored;  // a missing file of the manifest is no error
  for (const std::string& file : old.files) {
    fs::remove(path() / (file + ".part"), ignored);
    if (take == Take::resume) planned_.insert(file);
    else fs::remove(path() / file, ignored);
  }
  earlier_state_ = old.state;
}

void RunFolder::write(const std::string& file, std::string_view bytes) {
  write_file(path() / file, bytes);
  written_[file] = {bytes.size(), digest_of(bytes)};
}

void RunFolder::write_more(const std::string& file, std::string_view bytes) {
  make_places({file});
  if (planned_.insert(file).second) write_manifest(running, planned_);
  write(file, bytes);
}

void RunFolder::append(const std::string& file, std::string_view bytes) {
  Growing& growing = growing_[file];
  append_file(path() / file, growing.bytes, bytes);
  growing.bytes += bytes.size();
  growing.sha.add(bytes.data(), bytes.size());
  written_[file] = {growing.bytes, appended_sha256(file, growing.bytes)};
}

std::string RunFolder::appended_sha256(const std::string& file, std::size_t bytes) const {
  const auto it = growing_.find(file);
  if (it != growing_.end() && it->second.bytes == bytes) return Sha256(it->second.sha).hex();
  return digest_of(std::string_view(read_whole(path() / file)).substr(0, bytes));
}

bool RunFolder::continue_file(const std::string& file, std::size_t bytes,
                              const std::string& sha256) {
  if (!fs::exists(path() / file)) return false;
  const std::string there = read_whole(path() / file);
  if (there.size() < bytes || digest_of(std::string_view(there).substr(0, bytes)) != sha256)
    throw Error(Error::Kind::run, (path() / file).string(),
                "this table was changed after the run wrote it; put it back, or move it away and "
                "resume without its earlier rows");
  growing_.erase(file);
  Growing& growing = growing_[file];
  growing.bytes = bytes;
  growing.sha.add(there.data(), bytes);
  append_file(path() / file, bytes, "");
  written_[file] = {bytes, appended_sha256(file, bytes)};
  return true;
}

void RunFolder::remove(const std::string& file) {
  std::error_code ignored;
  fs::remove(path() / file, ignored);
  written_.erase(file);
}

void RunFolder::finish(std::string_view state) {
  std::set<std::string> there;
  for (const std::string& file : planned_) {
    if (!fs::is_regular_file(path() / file)) continue;
    there.insert(file);
    if (written_.contains(file)) continue;  // the others were written before the run was resumed
    const std::string bytes = read_whole(path() / file);
    written_[file] = {bytes.size(), digest_of(bytes)};
  }
  write_manifest(state, there);
}

/// The text is put together without JSON values: destroying those takes memory, and the process
/// ends where there is none.
void RunFolder::write_manifest(std::string_view state, const std::set<std::string>& files) {
  std::string text = "{\n";
  const auto add = [&](const char* name, const std::string& value) {
    text += fmt::format("  \"{}\": {},\n", name, value);
  };
  add("freshet", json_string(FRESHET_VERSION));
  add("commit", json_string(FRESHET_COMMIT));
  add("compiler", json_string(FRESHET_COMPILER));
  add("isa", json_string(provenance_.isa));
  add("threads", std::to_string(provenance_.threads));
  add("backend", json_string(provenance_.backend));
  std::string words;
  for (const std::string& word : provenance_.command)
    words += (words.empty() ? "\n    " : ",\n    ") + json_string(word);
  add("command", words.empty() ? "[]" : "[" + words + "\n  ]");
  const std::size_t state_at = text.size() + std::string_view("  \"state\": ").size();
  add("state", json_string(state));
  std::string list;
  for (const std::string& file : files) {
    list += (list.empty() ? "\n    {\n      \"file\": " : ",\n    {\n      \"file\": ") +
            json_string(file);
    if (const auto it = written_.find(file); it != written_.end())
      list += fmt::format(",\n      \"bytes\": {},\n      \"sha256\": \"{}\"", it->second.bytes,
                          it->second.sha256);
    list += "\n    }";
  }
  text += "  \"files\": " + (list.empty() ? "[]" : "[" + list + "\n  ]") + "\n}\n";
  write_file(manifest_, text);
  running_at_ = state == running ? state_at : 0;
}

void RunFolder::mark_failed() noexcept {
  if (running_at_ == 0) return;
  const int fd = ::open(manifest_.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW);
  if (fd < 0) return;
  if (::pwrite(fd, failed_word.data(), failed_word.size(), off_t(running_at_)) > 0) ::fsync(fd);
  ::close(fd);
}

void RunFolder::fail() noexcept {
  mark_failed();
  try {
    if (running_at_ != 0) finish("failed");
  } catch (...) {  // a full disk, or no memory: the marked manifest stays
    mark_failed();
  }
}

}  // namespace freshet
