// SPDX-License-Identifier: MIT
/// Videos as animated WebP, by libwebp.
#include "io/video.h"

#ifdef FRESHET_WEBP
#include <webp/encode.h>
#include <webp/mux.h>

#include <new>
#include <string>
#include <string_view>

#include "freshet/error.h"
#include "io/files.h"

namespace freshet {
namespace {

constexpr double webp_units = 1000;
constexpr float webp_quality = 90;  // of 100
constexpr int webp_effort = 2;      // of 6: slower methods make the files a few percent smaller

class WebpVideo final : public Video {
 public:
  WebpVideo(std::filesystem::path file, int width, int height, double fps)
      : file_(std::move(file)), partial_(file_), fps_(fps) {
    WebPAnimEncoderOptions options;
    if (!WebPAnimEncoderOptionsInit(&options) || !WebPConfigInit(&config_)) fail("wrong version");
    config_.quality = webp_quality;
    config_.method = webp_effort;
    encoder_.reset(WebPAnimEncoderNew(width, height, &options));
    if (!encoder_) throw std::bad_alloc();
  }

  void add(const Image& image) override {
    WebPPicture picture;
    if (!WebPPictureInit(&picture)) fail("wrong version");
    picture.use_argb = 1;
    picture.width = image.width;
    picture.height = image.height;
    const bool good =
        WebPPictureImportRGB(&picture, reinterpret_cast<const std::uint8_t*>(image.pixels.data()),
                             3 * image.width) &&
        WebPAnimEncoderAdd(encoder_.get(), &picture, end_, &config_);
    WebPPictureFree(&picture);
    if (!good) fail(WebPAnimEncoderGetError(encoder_.get()));
    end_ = int(video_time(count_++, fps_, webp_units));
  }
  void finish() override {
    WebPData data;
    WebPDataInit(&data);
    const bool good = WebPAnimEncoderAdd(encoder_.get(), nullptr, end_, nullptr) &&
                      WebPAnimEncoderAssemble(encoder_.get(), &data);
    const std::string bytes(reinterpret_cast<const char*>(data.bytes), good ? data.size : 0);
    WebPDataClear(&data);
    if (!good) fail(WebPAnimEncoderGetError(encoder_.get()));
    partial_.write(bytes);
    partial_.finish();
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw Error(Error::Kind::run, file_.string(),
                "libwebp could not make this film: " + why + "; choose another kind of file");
  }
  struct Delete {
    void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
  };

  std::filesystem::path file_;
  PartialFile partial_;
  double fps_;
  WebPConfig config_;
  std::unique_ptr<WebPAnimEncoder, Delete> encoder_;
  long count_ = 0;
  int end_ = 0;  // [ms]
};

}  // namespace

bool has_webp() { return true; }

std::unique_ptr<Video> make_webp_video(const std::filesystem::path& file, int width, int height,
                                       double fps) {
  return std::make_unique<WebpVideo>(file, width, height, fps);
}

}  // namespace freshet

#else

namespace freshet {

bool has_webp() { return false; }

std::unique_ptr<Video> make_webp_video(const std::filesystem::path&, int, int, double) {
  return nullptr;
}

}  // namespace freshet

#endif
