// SPDX-License-Identifier: MIT
#include "run/result_folder.h"

#include <fmt/format.h>

#include "freshet/error.h"

namespace freshet {

namespace fs = std::filesystem;

ResultFolder::ResultFolder(const fs::path& run, const fs::path& output, const std::string& standard)
    : below_(output.empty() ? standard + "/" : ""),
      folder_(output.empty() ? run : made_folder(output)) {
  folder_.make_folder_of(below_);
}

void ResultFolder::refuse_existing(const std::vector<std::string>& names,
                                   const std::string& noun) const {
  for (const std::string& name : names)
    if (folder_.holds(below_ + name))
      throw Error(Error::Kind::scene, (folder_.path() / below_).string(),
                  fmt::format("this folder holds {}; `overwrite` replaces them, or choose another "
                              "`output`",
                              noun),
                  {"overwrite", "output"});
}

fs::path ResultFolder::write(const std::string& name, std::string_view bytes) const {
  folder_.write(below_ + name, bytes);
  return folder_.path() / (below_ + name);
}

}  // namespace freshet
