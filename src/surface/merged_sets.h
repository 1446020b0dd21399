// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

namespace freshet {

/// Sets of numbers that are merged pair by pair. The least number of a set stands for it.
class MergedSets {
 public:
  explicit MergedSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int k) {
    while (parent_[std::size_t(k)] != k) {
      int& parent = parent_[std::size_t(k)];
      parent = parent_[std::size_t(parent)];
      k = parent;
    }
    return k;
  }
  void merge(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace freshet
