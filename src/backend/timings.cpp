// SPDX-License-Identifier: MIT
#include "backend/timings.h"

#include <algorithm>

namespace freshet {

Timings::Scope::Scope(Timings& timings, const char* name, int targets) : timings_(timings) {
  auto& list = timings.list_;
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const VerbTiming& v) { return v.name == name; });
  index_ = std::size_t(found - list.begin());
  if (found == list.end()) list.push_back({name});
  list[index_].calls += 1;
  list[index_].targets += targets;
}

Timings::Scope::~Scope() {
  const std::chrono::duration<double> taken = Clock::now() - start_;
  timings_.list_[index_].seconds += taken.count();
}

}  // namespace freshet
