// SPDX-License-Identifier: MIT
/// Videos as GIF, by giflib.
#include "io/video.h"

#ifdef FRESHET_GIF
#include <gif_lib.h>

#include <algorithm>
#include <optional>
#include <string>

#include "freshet/error.h"
#include "io/files.h"
#include "render/palette.h"

namespace freshet {
namespace {

constexpr double gif_units = 100;
constexpr std::size_t most_gif_waiting = 1 << 20;  // bytes

/// The smallest rectangle that holds all pixels in which two images differ.
struct Difference {
  int left = 0, top = 0, right = 0, bottom = 0;
  Difference(const Image& a, const Image& b) : left(a.width), top(a.height) {
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x) {
        if (a.at(x, y) == b.at(x, y)) continue;
        left = std::min(left, x);
        right = std::max(right, x + 1);
        top = std::min(top, y);
        bottom = std::max(bottom, y + 1);
      }
  }
  bool is_empty() const { return right <= left; }
};

Image part_of(const Image& image, const Difference& d) {
  Image part(d.right - d.left, d.bottom - d.top, {});
  for (int y = 0; y < part.height; ++y)
    std::copy_n(&image.at(d.left, d.top + y), part.width, &part.at(0, y));
  return part;
}

class GifVideo final : public Video {
 public:
  GifVideo(std::filesystem::path file, int width, int height, double fps)
      : file_(std::move(file)), partial_(file_), fps_(fps) {
    int error = 0;
    gif_ = EGifOpen(this, &GifVideo::take, &error);
    if (!gif_) fail(error);
    EGifSetGifVersion(gif_, true);
    require(EGifPutScreenDesc(gif_, width, height, 8, 0, nullptr));
    require(EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE));
    require(EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0"));
    const GifByteType forever[] = {1, 0, 0};
    require(EGifPutExtensionBlock(gif_, 3, forever));
    require(EGifPutExtensionTrailer(gif_));
  }
  ~GifVideo() override {
    int error = 0;
    if (gif_) EGifCloseFile(gif_, &error);
  }
  GifVideo(const GifVideo&) = delete;
  GifVideo& operator=(const GifVideo&) = delete;

  /// A picture is written when the next different one comes, as its duration is known then.
  void add(const Image& image) override {
    if (!next_) next_ = image;
    else if (next_->pixels != image.pixels) {
      put();
      next_ = image;
    }
    end_ = video_time(count_++, fps_, gif_units);
  }
  void finish() override {
    if (next_) put();
    int error = 0;
    if (EGifCloseFile(std::exchange(gif_, nullptr), &error) == GIF_ERROR) fail(error);
    partial_.write(waiting_);
    partial_.finish();
  }

 private:
  static int take(GifFileType* gif, const GifByteType* bytes, int count) {
    static_cast<GifVideo*>(gif->UserData)
        ->waiting_.append(reinterpret_cast<const char*>(bytes), std::size_t(count));
    return count;
  }
  [[noreturn]] void fail(int error) const {
    const char* why = GifErrorString(error);
    throw Error(Error::Kind::run, file_.string(),
                std::string("giflib could not make this film: ") + (why ? why : "unknown error") +
                    "; choose another kind of file");
  }
  void require(int result) const {
    if (result == GIF_ERROR) fail(gif_->Error);
  }
  /// Writes what differs from the picture before.
  void put() {
    Difference d(*next_, shown_ ? *shown_ : *next_);
    if (!shown_) d.left = d.top = 0, d.right = next_->width, d.bottom = next_->height;
    if (d.is_empty()) return;
    const PalettedImage part = reduce_colors(part_of(*next_, d));
    int size = 2;
    while (size < int(part.colors.size())) size *= 2;
    ColorMapObject* map = GifMakeMapObject(size, nullptr);
    if (!map) throw std::bad_alloc();
    for (std::size_t k = 0; k < part.colors.size(); ++k)
      map->Colors[k] = {part.colors[k].r, part.colors[k].g, part.colors[k].b};
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, int(end_ - start_),
                                       NO_TRANSPARENT_COLOR};
    GifByteType bytes[4];
    EGifGCBToExtension(&control, bytes);
    const bool good =
        EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, 4, bytes) != GIF_ERROR &&
        EGifPutImageDesc(gif_, d.left, d.top, part.width, part.height, false, map) != GIF_ERROR;
    GifFreeMapObject(map);
    require(good ? GIF_OK : GIF_ERROR);
    std::vector<std::uint8_t> pixels = part.pixels;  // EGifPutLine masks its argument in place
    for (int y = 0; y < part.height; ++y)
      require(EGifPutLine(gif_, &pixels[std::size_t(y) * std::size_t(part.width)], part.width));
    start_ = end_;
    shown_ = std::move(next_);
    if (waiting_.size() < most_gif_waiting) return;
    partial_.write(waiting_);
    waiting_.clear();
  }

  std::filesystem::path file_;
  PartialFile partial_;
  double fps_;
  GifFileType* gif_ = nullptr;
  std::string waiting_;  // bytes
  std::optional<Image> shown_, next_;
  long count_ = 0, start_ = 0, end_ = 0;  // pictures; hundredths of a second
};

}  // namespace

bool has_gif() { return true; }

std::unique_ptr<Video> make_gif_video(const std::filesystem::path& file, int width, int height,
                                      double fps) {
  return std::make_unique<GifVideo>(file, width, height, fps);
}

}  // namespace freshet

#else

namespace freshet {

bool has_gif() { return false; }

std::unique_ptr<Video> make_gif_video(const std::filesystem::path&, int, int, double) {
  return nullptr;
}

}  // namespace freshet

#endif
