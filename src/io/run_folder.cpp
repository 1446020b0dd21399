// SPDX-License-Identifier: MIT
#include "io/run_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "commit.h"
#include "freshet/error.h"
#include "freshet/version.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* manifest_name = "manifest.json";
constexpr std::string_view running = "running";
/// Written over `"running",` in a manifest, as many bytes.
constexpr std::string_view failed_word = "\"failed\", ";

/// Whether a name cannot leave the folder by itself. Links are another matter: see Folder.
bool is_below(const fs::path& name) {
  return !name.empty() && name.is_relative() &&
         std::find(name.begin(), name.end(), "..") == name.end();
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

}  // namespace

/// The manifest of an earlier run. Files that are not plain paths below the folder are ignored.
struct RunFolder::Manifest {
  std::string state;
  std::set<std::string> files;
};

FolderLock::FolderLock(fs::path folder) : folder_(std::move(folder)) {
  if (::flock(folder_.descriptor(), LOCK_EX | LOCK_NB) == 0) return;
  throw Error(Error::Kind::scene, folder_.path().string(),
              "another run is writing into this folder; wait for it or choose another `output`",
              {"output"});
}

FolderLock FolderLock::of_new(const fs::path& folder) { return FolderLock(made_folder(folder)); }

void RunFolder::take(Take how, const RunPlan& plan, Provenance provenance) {
  const Manifest old = earlier_manifest(how);
  refuse_links(plan, how);
  planned_ = old.files;
  for (const std::string& file : plan.files) refuse_files_of_others(file, how);
  planned_ = {plan.files.begin(), plan.files.end()};
  provenance_ = std::move(provenance);
  taken_ = how;
  clear(old, how);
  for (const std::string& file : plan.files) folder().make_folder_of(file);
  for (const std::string& name : plan.folders) folder().make_folder_of(name + "/");
  write_manifest(running, planned_);
}

RunFolder::Manifest RunFolder::earlier_manifest(Take take) const {
  if (!folder().holds(manifest_name)) return {};
  if (take == Take::empty)
    throw Error(Error::Kind::scene, path().string(),
                "this folder holds a run; `overwrite` replaces it (only the files that its "
                "manifest.json names), resume it, or choose another `output`",
                {"overwrite", "output"});
  const auto reject = [this] {
    throw Error(Error::Kind::scene, (path() / manifest_name).string(),
                "not a manifest of Freshet; remove the folder by hand or choose another `output`",
                {"output"});
  };
  Manifest m;
  const Json json = Json::parse(folder().read(manifest_name).value_or(""), nullptr, false);
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) reject();
  if (json.contains("state") && json["state"].is_string()) m.state = json["state"];
  for (const Json& file : json["files"]) {
    const Json entry = file.is_object() ? file.value("file", Json("")) : file;
    if (!entry.is_string()) reject();
    if (const std::string name = entry; is_below(name)) m.files.insert(name);
  }
  return m;
}

/// A folder in the plan must not be a link. Nor must a file that a resumed run adds to; other links
/// are replaced, whatever they point to.
void RunFolder::refuse_links(const RunPlan& plan, Take take) const {
  std::set<std::string> places(plan.folders.begin(), plan.folders.end());
  for (const std::string& file : plan.files)
    places.insert(take == Take::resume ? file : fs::path(file).parent_path().string());
  for (const std::string& place : places)
    if (const std::string link = folder().link_in(place); !link.empty())
      refuse(link, take,
             "this is a symbolic link, and a run writes and deletes only below its folder; remove "
             "the link");
}

/// A file that is not in `planned_`, which a run must neither replace nor remove.
void RunFolder::refuse_files_of_others(const std::string& file, Take take) const {
  if (planned_.contains(file)) return;
  for (const std::string& name : {file, file + ".part"})
    if (folder().holds(name))
      refuse(name, take,
             "this file was not written by a run, and the run would replace it; move it");
}

void RunFolder::refuse(const std::string& name, Take take, const std::string& why) const {
  const bool stays = take == Take::resume;  // a resumed run has no other folder
  throw Error(Error::Kind::scene, (path() / name).string(),
              why + (stays ? "" : " or choose another `output`"),
              stays ? std::vector<std::string>() : std::vector<std::string>{"output"});
}

/// Removes the files of an earlier run. If the run is resumed, only its partial files are removed.
void RunFolder::clear(const Manifest& old, Take take) {
  for (const std::string& file : old.files) {
    folder().remove(file + ".part");
    if (take == Take::resume) planned_.insert(file);
    else folder().remove(file);
  }
  earlier_state_ = old.state;
}

void RunFolder::write(const std::string& file, std::string_view bytes) {
  folder().write(file, bytes);
  written_[file] = {bytes.size(), digest_of(bytes)};
}

void RunFolder::write_more(const std::string& file, std::string_view bytes) {
  refuse_files_of_others(file, taken_);
  folder().make_folder_of(file);
  if (planned_.insert(file).second) write_manifest(running, planned_);
  write(file, bytes);
}

void RunFolder::append(const std::string& file, std::string_view bytes) {
  Growing& growing = growing_[file];
  folder().append(file, growing.bytes, bytes);
  growing.bytes += bytes.size();
  growing.sha.add(bytes.data(), bytes.size());
  written_[file] = {growing.bytes, appended_sha256(file, growing.bytes)};
}

std::string RunFolder::appended_sha256(const std::string& file, std::size_t bytes) const {
  const auto it = growing_.find(file);
  if (it != growing_.end() && it->second.bytes == bytes) return Sha256(it->second.sha).hex();
  return digest_of(std::string_view(folder().read(file).value_or("")).substr(0, bytes));
}

bool RunFolder::continue_file(const std::string& file, std::size_t bytes,
                              const std::string& sha256) {
  if (!folder().holds(file)) return false;
  const std::string there = folder().read(file).value_or("");
  if (there.size() < bytes || digest_of(std::string_view(there).substr(0, bytes)) != sha256)
    throw Error(Error::Kind::run, (path() / file).string(),
                "this table was changed after the run wrote it; put it back, or move it away and "
                "resume without its earlier rows");
  growing_.erase(file);
  Growing& growing = growing_[file];
  growing.bytes = bytes;
  growing.sha.add(there.data(), bytes);
  folder().append(file, bytes, "");
  written_[file] = {bytes, appended_sha256(file, bytes)};
  return true;
}

void RunFolder::remove(const std::string& file) {
  folder().remove(file);
  written_.erase(file);
}

void RunFolder::finish(std::string_view state) {
  std::set<std::string> there;
  for (const std::string& file : planned_) {
    if (written_.contains(file) && folder().holds(file)) {
      there.insert(file);
    } else if (const auto bytes = folder().read(file)) {  // of the run before it was resumed
      there.insert(file);
      written_[file] = {bytes->size(), digest_of(*bytes)};
    }
  }
  write_manifest(state, there);
}

/// The text is put together without JSON values: destroying those takes memory, and the process
/// ends if the allocation fails.
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
  folder().write(manifest_name, text);
  running_at_ = state == running ? state_at : 0;
}

void RunFolder::mark_failed() noexcept {
  if (running_at_ == 0) return;
  const int fd = ::openat(folder().descriptor(), manifest_name, O_WRONLY | O_CLOEXEC | O_NOFOLLOW);
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
