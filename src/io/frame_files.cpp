// SPDX-License-Identifier: MIT
#include "io/frame_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/input_file.h"
#include "formats/file_place.h"
#include "io/frame_formats.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// The number of "frame_0007.vtp"; empty for names that data_file would not give.
std::optional<std::int64_t> number_of_frame(const fs::path& file, const std::string& extension) {
  const std::string name = file.filename().string();
  std::int64_t number = 0;
  if (!name.starts_with("frame_")) return {};
  std::from_chars(name.data() + 6, name.data() + name.size(), number);
  if (number < 0 || name != fmt::format("frame_{:04}{}", number, extension)) return {};
  return number;
}

/// The file of the whitewater beside a data file, in any format: data/whitewater_0007.vtp beside
/// data/frame_0007.h5. Empty if the folder has no such file.
fs::path whitewater_of(const fs::path& frame) {
  const std::string name = frame.stem().string();
  for (const FrameFormat& format : frame_formats()) {
    std::error_code ec;
    if (!format.decode || !name.starts_with("frame_")) continue;
    const fs::path file = frame.parent_path() / ("whitewater_" + name.substr(6) + format.extension);
    if (fs::exists(file, ec)) return file;
  }
  return {};
}

}  // namespace

std::string picture_name(const FrameFile& frame) {
  return fmt::format("frame_{:04}.png", frame.number);
}

std::vector<FrameFile> frame_files(const fs::path& run_folder) {
  for (const FrameFormat& format : frame_formats()) {
    if (!format.decode) continue;
    std::vector<FrameFile> files;
    std::error_code ec;  // a missing folder has no files
    for (const auto& entry : fs::directory_iterator(run_folder / "data", ec))
      if (const auto number = number_of_frame(entry.path(), format.extension))
        files.push_back({entry.path(), *number});
    std::sort(files.begin(), files.end(),
              [](const FrameFile& a, const FrameFile& b) { return a.number < b.number; });
    if (!files.empty()) return files;
  }
  return {};
}

Frame frame_in(std::string_view bytes, const fs::path& file, DataFields* stored) {
  DataFields unused;
  for (const FrameFormat& format : frame_formats())
    if (format.decode && file.extension() == format.extension)
      return format.decode(bytes, file.string(), stored ? *stored : unused);
  FilePlace(file.string()).fail("not *.h5, *.vtp, *.ply or *.csv; name a data file of a run");
}

Frame read_frame(const fs::path& file, DataFields* stored) {
  constexpr InputFile data_file{.noun = "data file", .remedy = "name a data file of a run"};
  Frame frame = frame_in(read_input(file, data_file), file, stored);
  const fs::path beside = whitewater_of(file);
  if (beside.empty()) return frame;
  Frame with = frame_in(read_input(beside, data_file), beside);
  if (with.size() > 0 || with.dimension != frame.dimension ||
      (with.step != 0 && with.step != frame.step))
    FilePlace(beside.string())
        .fail(fmt::format("this is not the whitewater of {}; remove it, or run the scene again",
                          file.filename().string()));
  frame.whitewater = std::move(with.whitewater);
  return frame;
}

}  // namespace freshet
