// SPDX-License-Identifier: MIT
// Code of one instruction set must not replace code of another. A linker keeps one of several
// inline functions of equal name; if it kept an AVX-512 one, the program would crash on an older
// machine.
#include <gtest/gtest.h>

#ifdef OBJECTS_sse42

#include <cstdio>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

/// The mangled names of the weak symbols that the objects define. Some are too long for demanglers.
std::set<std::string> weak_symbols(const std::string& objects) {
  std::set<std::string> all;
  FILE* nm = popen(("nm --defined-only " + objects).c_str(), "r");
  if (!nm) return all;
  static char line[1 << 16];
  while (std::fgets(line, sizeof line, nm)) {  // ADDRESS TYPE NAME
    const std::string text(line);
    if (text.size() > 19 && std::string("WVu").find(text[17]) != std::string::npos)
      all.insert(text.substr(19));
  }
  pclose(nm);
  return all;
}

const std::map<std::string, std::string> objects{
    {"sse42", OBJECTS_sse42},
#ifdef OBJECTS_avx2
    {"avx2", OBJECTS_avx2},
#endif
#ifdef OBJECTS_avx512
    {"avx512", OBJECTS_avx512},
#endif
};

// Every weak symbol names its instruction set, or the baseline defines it too. The baseline is
// linked first, so the linker keeps its copy.
TEST(Symbols, NameTheirInstructionSetOrExistInTheBaseline) {
  const std::set<std::string> base = weak_symbols(OBJECTS_sse42);
  EXPECT_GT(base.size(), 20u);
  for (const auto& [isa, files] : objects) {
    // freshet::ISA, mangled; a substitution (S0_) may replace the first part
    const std::regex ours("(7freshet|S[0-9A-Z]*_)" + std::to_string(isa.size()) + isa);
    const std::set<std::string> weak = weak_symbols(files);
    EXPECT_GT(weak.size(), 20u) << isa;
    for (const std::string& name : weak)
      EXPECT_TRUE(std::regex_search(name, ours) || base.contains(name)) << isa << ": " << name;
  }
}

}  // namespace

#endif
