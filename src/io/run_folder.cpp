// SPDX-License-Identifier: MIT
#include "io/run_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "commit.h"
#include "freshet/error.h"
#include "freshet/version.h"
#include "io/files.h"
#include "io/sha256.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* manifest_name = "manifest.json";

/// The files that the manifest of an earlier run names; only plain paths below the folder count.
std::set<std::string> files_of(const fs::path& manifest) {
  std::set<std::string> files;
  const Json json = Json::parse(std::ifstream(manifest), nullptr, false);
  const auto refuse = [&] {
    throw Error(Error::Kind::scene, manifest.string(),
                "not a manifest of Freshet; remove the folder by hand or choose another --output");
  };
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) refuse();
  for (const Json& file : json["files"]) {
    const Json entry = file.is_object() ? file.value("file", Json("")) : file;
    if (!entry.is_string()) refuse();
    const std::string name = entry;
    const fs::path path = fs::path(name).lexically_normal();
    if (!name.empty() && path.is_relative() && *path.begin() != "..") files.insert(name);
  }
  return files;
}

}  // namespace

RunFolder::RunFolder(fs::path folder, bool overwrite, std::vector<std::string> planned,
                     Provenance provenance)
    : folder_(std::move(folder)), planned_(std::move(planned)), provenance_(std::move(provenance)) {
  std::error_code ec;
  fs::create_directories(folder_, ec);
  if (ec) fail_file(folder_, "make this folder", ec.value());
  lock();
  try {
    clear(overwrite);
    for (const std::string& file : planned_) {
      fs::create_directories((folder_ / file).parent_path(), ec);
      if (ec) fail_file((folder_ / file).parent_path(), "make this folder", ec.value());
    }
    write_manifest("running", planned_);
  } catch (...) {
    ::close(lock_);
    throw;
  }
}

RunFolder::~RunFolder() { ::close(lock_); }

void RunFolder::lock() {
  lock_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) fail_file(folder_, "open this folder", errno);
  if (::flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
  ::close(lock_);
  throw Error(Error::Kind::scene, folder_.string(),
              "another run is writing into this folder; wait for it or choose another --output");
}

void RunFolder::clear(bool overwrite) {
  const fs::path manifest = folder_ / manifest_name;
  std::set<std::string> old;
  if (fs::exists(manifest)) {
    if (!overwrite)
      throw Error(Error::Kind::scene, folder_.string(),
                  "this folder holds a run; --overwrite replaces it (only the files that its "
                  "manifest.json names), or choose another --output");
    old = files_of(manifest);
  }
  for (const std::string& file : planned_)
    if (fs::exists(folder_ / file) && !old.contains(file))
      throw Error(Error::Kind::scene, (folder_ / file).string(),
                  "this file was not written by a run, and the run would replace it; move it or "
                  "choose another --output");
  std::error_code ignored;  // a file of the manifest that is gone is fine
  for (const std::string& file : old) fs::remove(folder_ / file, ignored);
}

void RunFolder::write(const std::string& file, std::string_view bytes) {
  write_file(folder_ / file, bytes);
  Sha256 sha;
  sha.add(bytes.data(), bytes.size());
  written_[file] = {bytes.size(), sha.hex()};
}

void RunFolder::finish(std::string_view state) {
  std::vector<std::string> files;
  for (const auto& [file, written] : written_) files.push_back(file);
  write_manifest(state, files);
}

void RunFolder::write_manifest(std::string_view state,
                               const std::vector<std::string>& files) const {
  Json list = Json::array();
  for (const std::string& file : files) {
    Json entry{{"file", file}};
    if (const auto it = written_.find(file); it != written_.end()) {
      entry["bytes"] = it->second.bytes;
      entry["sha256"] = it->second.sha256;
    }
    list.push_back(entry);
  }
  const Json manifest{{"freshet", FRESHET_VERSION},
                      {"commit", FRESHET_COMMIT},
                      {"compiler", FRESHET_COMPILER},
                      {"isa", provenance_.isa},
                      {"threads", provenance_.threads},
                      {"backend", provenance_.backend},
                      {"command", provenance_.command},
                      {"state", state},
                      {"files", list}};
  write_file(folder_ / manifest_name,
             manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace freshet
