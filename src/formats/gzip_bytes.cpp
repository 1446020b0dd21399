// SPDX-License-Identifier: MIT
#include "formats/gzip_bytes.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace freshet {

struct InputBytes::Gzip {
  z_stream stream = {};
  std::string out;  // the bytes of the last call
  bool ended = false;

  Gzip() = default;
  Gzip(const Gzip&) = delete;
  ~Gzip() { inflateEnd(&stream); }
};

InputBytes::InputBytes(std::string_view bytes, const FilePlace& place)
    : bytes_(bytes), place_(place) {
  if (!is_gzip(bytes)) return;
  constexpr int gzip_window = 15 + 16;
  gzip_ = std::make_unique<Gzip>();
  if (inflateInit2(&gzip_->stream, gzip_window) != Z_OK) throw std::bad_alloc();
}

InputBytes::~InputBytes() = default;

std::string_view InputBytes::inflate(std::size_t size) {
  constexpr std::size_t most = std::numeric_limits<uInt>::max();
  z_stream& z = gzip_->stream;
  gzip_->out.resize(size);
  for (std::size_t done = 0; done < size;) {
    if (gzip_->ended) return {};
    const std::size_t room = std::min(size - done, most), given = std::min(bytes_.size(), most);
    z.next_out = reinterpret_cast<Bytef*>(gzip_->out.data() + done);
    z.avail_out = uInt(room);
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes_.data()));
    z.avail_in = uInt(given);
    const int status = ::inflate(&z, Z_NO_FLUSH);
    bytes_.remove_prefix(given - z.avail_in);
    done += room - z.avail_out;
    gzip_->ended = status == Z_STREAM_END;
    if (status == Z_BUF_ERROR) return {};  // the file ends
    if (status != Z_OK && status != Z_STREAM_END)
      place_.fail("its gzip data is damaged; save the file again");
  }
  return gzip_->out;
}

}  // namespace freshet
