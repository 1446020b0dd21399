// SPDX-License-Identifier: MIT
/// Names of a scene, and their characters.
#include "scene/check/names.h"

#include <gtest/gtest.h>

#include <string>

namespace freshet::test {
namespace {

TEST(Names, MayHoldLettersOfAnyAlphabet) {
  for (const char* name : {"front", "Wand_links", "Überlauf", "前壁", "стена-2", "ताल", "π.2"}) {
    EXPECT_TRUE(names_column(name)) << name;
    EXPECT_TRUE(names_file(name)) << name;
  }
  EXPECT_TRUE(names_column("left wall [old]"));
}

TEST(Names, OfColumnsHaveNoInvisibleCharacters) {
  for (const char* name :
       {"a,b", "a\"b", "a\nb", "a\x7f", "a\xc2\x85z", "a\xe2\x80\x8b", "a\xe2\x80\xae",
        "\xef\xbb\xbf"
        "a"}) {
    EXPECT_FALSE(names_column(name)) << name;
    EXPECT_FALSE(names_file(name)) << name;
  }
}

TEST(Names, AreUtf8) {
  for (const char* name : {"\x80", "a\xff", "\xe5\x89", "\xe5\x41\x41", "\xc0\xaf",
                           "\xf4\x90\x80\x80", "\xed\xa0\x80"})
    EXPECT_FALSE(names_column(name)) << name;
}

TEST(Names, OfFilesStayInTheirFolder) {
  for (const char* name : {"../a", "a/b", ".a", "..", "a b",
                           "a\xe3\x80\x80"
                           "b",
                           "a:b", "a*"})
    EXPECT_FALSE(names_file(name)) << name;
  EXPECT_TRUE(names_file(std::string(200, 'a')));
  EXPECT_FALSE(names_file(std::string(201, 'a')));
}

}  // namespace
}  // namespace freshet::test
