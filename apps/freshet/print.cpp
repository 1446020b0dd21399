// SPDX-License-Identifier: MIT
#include "print.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <new>

namespace freshet::cli {
namespace {

int first_failure = 0;  // an errno

void note_failure() {
  if (first_failure == 0) first_failure = errno != 0 ? errno : EIO;
}

/// The bytes of the control character that the text begins with; 0 if it begins with none. Those of
/// Latin-1, U+0080 to U+009F, have two bytes in UTF-8.
std::size_t control_bytes(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
  return text.size() > 1 && byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) < 0xa0 ? 2 : 0;
}

/// `text` with escapes for its control characters, but for those in `kept`.
std::string escaped(std::string_view text, std::string_view kept) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t bytes = control_bytes(text);
    if (bytes == 0 || (bytes == 1 && kept.find(text[0]) != std::string_view::npos)) out += text[0];
    else if (text[0] == '\n') out += "\\n";
    else if (text[0] == '\t') out += "\\t";
    else if (bytes == 1) out += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    else out += fmt::format("\\u{:04x}", static_cast<unsigned char>(text[1]));
    text.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  return out;
}

constexpr std::string_view layout = "\n\t";

}  // namespace

void fill_standard_descriptors() {
  // Each open() takes the smallest free number. The modes are those that reading and writing fail
  // in, as on a closed descriptor.
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(fd, F_GETFD) < 0 && errno == EBADF)
      static_cast<void>(::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

std::string printable(std::string_view text) { return escaped(text, ""); }

void put(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) note_failure();
}

void flush_output() {
  if (std::fflush(stdout) != 0) note_failure();
}

int output_failure() {
  flush_output();
  if (std::ferror(stdout) != 0) note_failure();
  return first_failure == EPIPE ? 0 : first_failure;
}

void put_text(std::string_view text) { put(escaped(text, layout)); }

void put_error(std::string_view text) {
  std::string all;
  try {
    all = escaped(text, layout);
    text = all;
  } catch (const std::bad_alloc&) {  // as it is, rather than not at all
  }
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

}  // namespace freshet::cli
