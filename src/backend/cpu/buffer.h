// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>

namespace freshet {
inline namespace FRESHET_ISA {

/// Memory that only grows, aligned to cache lines. Growing discards the contents.
template <class T> class Buffer {
 public:
  T* reserve(std::size_t n) {
    if (n > size_) {
      size_ = n + n / 8;
      data_.reset();
      data_.reset(static_cast<T*>(std::aligned_alloc(64, (size_ * sizeof(T) + 127) / 64 * 64)));
      if (!data_) throw std::bad_alloc();
    }
    return data_.get();
  }
  T* get() const { return data_.get(); }
  std::size_t size() const { return size_; }

 private:
  struct Free {
    void operator()(T* p) const { std::free(p); }
  };
  std::unique_ptr<T, Free> data_;
  std::size_t size_ = 0;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
