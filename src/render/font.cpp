// SPDX-License-Identifier: MIT
/// Loads fonts by file. Cairo could find fonts by name, but then it keeps fontconfig's patterns for
/// the life of the process. These refer to their parts by offsets, which leak checkers report as
/// leaks.
#include "render/font.h"

#include <cairo/cairo-ft.h>

#include <string>

#include "freshet/error.h"

namespace freshet {
namespace {

template <class T, class Free> std::unique_ptr<T, Free> owned(T* pointer, Free free) {
  return {pointer, free};
}

[[noreturn]] void fail(const std::string& why) {
  throw Error(Error::Kind::run, "",
              why + "; install the fonts DejaVu (apt-get install fonts-dejavu-core)");
}

/// The file of the font that fontconfig selects.
std::string font_file(bool bold) {
  const auto config = owned(FcInitLoadConfigAndFonts(), FcConfigDestroy);
  const auto wanted = owned(
      FcPatternBuild(nullptr, FC_FAMILY, FcTypeString, "DejaVu Sans", FC_WEIGHT, FcTypeInteger,
                     bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR, static_cast<char*>(nullptr)),
      FcPatternDestroy);
  if (!config || !wanted) fail("fontconfig cannot be set up");
  FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result{};
  const auto found = owned(FcFontMatch(config.get(), wanted.get(), &result), FcPatternDestroy);
  FcChar8* file = nullptr;
  if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch)
    fail("no font is installed");
  return reinterpret_cast<const char*>(file);
}

/// A font face with the FreeType library that owns it.
struct Face {
  explicit Face(const std::string& file) {
    if (FT_Init_FreeType(&library) != 0) fail("FreeType cannot be set up");
    if (FT_New_Face(library, file.c_str(), 0, &face) == 0) return;
    FT_Done_FreeType(library);
    fail("the font " + file + " cannot be read");
  }
  Face(const Face&) = delete;
  ~Face() {
    FT_Done_Face(face);
    FT_Done_FreeType(library);
  }
  FT_Library library = nullptr;
  FT_Face face = nullptr;
};

constexpr cairo_user_data_key_t key{};

}  // namespace

Font load_font(bool bold) {
  auto face = std::make_unique<Face>(font_file(bold));
  Font font(cairo_ft_font_face_create_for_ft_face(face->face, FT_LOAD_DEFAULT),
            cairo_font_face_destroy);
  // Cairo may keep the font: the face is deleted when Cairo releases it
  if (cairo_font_face_set_user_data(font.get(), &key, face.get(), [](void* f) {
        delete static_cast<Face*>(f);
      }) != CAIRO_STATUS_SUCCESS)
    fail("a font cannot be set up");
  face.release();
  return font;
}

}  // namespace freshet
