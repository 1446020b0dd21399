// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace freshet {
inline namespace FRESHET_ISA {

/// Memory that only grows, aligned to cache lines. Growing discards the contents. The buffer is
/// empty after reserve() threw std::bad_alloc.
template <class T> class Buffer {
 public:
  T* reserve(std::size_t n) {
    if (n > size_) {
      const std::size_t size = n + n / 8, bytes = (size * sizeof(T) + 127) / 64 * 64;
      data_.reset();
      size_ = 0;  // stays, if memory runs out
      data_.reset(static_cast<T*>(::operator new(bytes, alignment)));
      size_ = size;
    }
    return data_.get();
  }
  T* get() const { return data_.get(); }
  std::size_t size() const { return size_; }

 private:
  static constexpr std::align_val_t alignment{64};
  struct Free {
    void operator()(T* p) const { ::operator delete(p, alignment); }
  };
  std::unique_ptr<T, Free> data_;
  std::size_t size_ = 0;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
