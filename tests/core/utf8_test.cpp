// SPDX-License-Identifier: MIT
#include "core/utf8.h"

#include <gtest/gtest.h>

namespace freshet {
namespace {

TEST(Utf8, KeepsWhatIsValid) {
  for (const char* text : {"", "flow", "火", "é", "\U0001F30A", "\U0010FFFF", "a\nb"})
    EXPECT_EQ(text, valid_utf8(text));
}

TEST(Utf8, ReplacesWhatIsNot) {
  const std::string mark = "\xEF\xBF\xBD";
  EXPECT_EQ("a" + mark + "b", valid_utf8("a\xFF"
                                         "b"));
  EXPECT_EQ(mark, valid_utf8("\xE7"));
  EXPECT_EQ(mark + mark + "x", valid_utf8("\xE7\x81x"));                 // cut off
  EXPECT_EQ(mark + mark, valid_utf8("\xC0\x80"));                        // too long
  EXPECT_EQ(mark + mark + mark, valid_utf8("\xED\xA0\x80"));             // a surrogate
  EXPECT_EQ(mark + mark + mark + mark, valid_utf8("\xF4\x90\x80\x80"));  // beyond the last
}

}  // namespace
}  // namespace freshet
