// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/vec.h"
#include "freshet/state_array.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The list of the arrays of an engine's state.
template <int D> class StateArrays {
 public:
  using Role = StateArray::Role;
  /// Adds an array. data() and count() return its address and length at the time of each arrays().
  template <class Data, class Count> void add(std::string name, Data data, Count count, Role role) {
    using Number = StateArray::Number;
    using T = std::remove_pointer_t<decltype(data())>;
    using Scalar = decltype(scalar_of(T{}));
    constexpr Number number = std::is_same_v<Scalar, float>    ? Number::float32
                              : std::is_same_v<Scalar, double> ? Number::float64
                              : sizeof(Scalar) == 4            ? Number::int32
                                                               : Number::uint64;
    all_.push_back([=, name = std::move(name)] {
      return StateArray{name,    reinterpret_cast<std::byte*>(data()),
                        count(), int(sizeof(T) / sizeof(Scalar)),
                        number,  role};
    });
  }
  /// Adds records that consist of doubles only.
  template <class Record> void add_numbers(const char* name, std::vector<Record>& records) {
    auto* all = &records;
    add(
        name, [=] { return reinterpret_cast<double*>(all->data()); },
        [=] { return std::int64_t(all->size() * sizeof(Record) / sizeof(double)); }, Role::other);
  }
  std::vector<StateArray> arrays() const {
    std::vector<StateArray> told;
    for (const auto& array : all_) told.push_back(array());
    return told;
  }

 private:
  template <class T> static T scalar_of(T);
  template <class R> static R scalar_of(Vec<D, R>);

  std::vector<std::function<StateArray()>> all_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
