// SPDX-License-Identifier: MIT
#include "whole_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "freshet/error.h"

namespace freshet::cli {

namespace fs = std::filesystem;

void write_whole(const fs::path& file, const std::string& text) {
  std::error_code ec;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ec);
  const fs::path part = file.string() + ".part";
  fs::remove(part, ec);  // of a command that was killed, or a planted link
  ec.clear();
  std::FILE* out = std::fopen(part.c_str(), "wbx");  // x: never what stands there, or a link
  bool written = out && std::fwrite(text.data(), 1, text.size(), out) == text.size();
  if (out) written = std::fclose(out) == 0 && written;
  const int reason = errno;
  if (written) fs::rename(part, file, ec);
  if (written && !ec) return;
  const std::string why = ec ? ec.message() : std::strerror(reason);
  if (out) fs::remove(part, ec);
  throw Error(Error::Kind::run, file.string(),
              fmt::format("cannot write: {}; make room, or choose another place", why));
}

}  // namespace freshet::cli
