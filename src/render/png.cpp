// SPDX-License-Identifier: MIT
#include "render/png.h"

#include <spng.h>

#include <cstdlib>
#include <memory>
#include <new>

#include "freshet/error.h"

namespace freshet {
namespace {

static_assert(sizeof(Color) == 3, "pixels are handed over as packed RGB");

using PngContext = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

void require(int code) {
  if (code == SPNG_EMEM || code == SPNG_EZLIB_INIT) throw std::bad_alloc();
  if (code != 0) throw Error(Error::Kind::run, "", std::string("PNG: ") + spng_strerror(code));
}

}  // namespace

std::string encode_png(const Image& image) {
  const PngContext ctx(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
  require(spng_set_option(ctx.get(), SPNG_ENCODE_TO_BUFFER, 1));
  spng_ihdr header{};
  header.width = std::uint32_t(image.width);
  header.height = std::uint32_t(image.height);
  header.bit_depth = 8;
  header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
  require(spng_set_ihdr(ctx.get(), &header));
  require(spng_encode_image(ctx.get(), image.pixels.data(), 3 * image.pixels.size(), SPNG_FMT_PNG,
                            SPNG_ENCODE_FINALIZE));
  std::size_t size = 0;
  int code = 0;
  const std::unique_ptr<void, decltype(&std::free)> bytes(
      spng_get_png_buffer(ctx.get(), &size, &code), std::free);
  require(code);
  return {static_cast<const char*>(bytes.get()), size};
}

Image decode_png(const std::string& bytes) {
  const PngContext ctx(spng_ctx_new(0), spng_ctx_free);
  require(spng_set_png_buffer(ctx.get(), bytes.data(), bytes.size()));
  spng_ihdr header{};
  require(spng_get_ihdr(ctx.get(), &header));
  Image image(int(header.width), int(header.height), {});
  require(
      spng_decode_image(ctx.get(), image.pixels.data(), 3 * image.pixels.size(), SPNG_FMT_RGB8, 0));
  return image;
}

}  // namespace freshet
