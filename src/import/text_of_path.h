// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace freshet {

/// The path of a key or of an item in messages: "Emitters[0].width".
inline std::string path_below(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}
inline std::string path_below(const std::string& path, std::size_t item) {
  return path + "[" + std::to_string(item) + "]";
}

}  // namespace freshet
