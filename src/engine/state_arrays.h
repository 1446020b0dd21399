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

/// Where the arrays are that an engine's next steps follow from.
template <int D> class StateArrays {
 public:
  using Role = StateArray::Role;
  /// data() and count() tell where an array is, whenever it is asked for.
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
  /// Records that are nothing but doubles.
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
