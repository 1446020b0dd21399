// SPDX-License-Identifier: MIT
#include "formats/numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "formats/point_sink.h"

namespace freshet {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are stored");

template <class T> struct Decoder {
  double operator()(const char* at, bool big) const {
    char bytes[sizeof(T)];
    std::memcpy(bytes, at, sizeof bytes);
    if (big) std::reverse(bytes, bytes + sizeof bytes);
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return double(value);
  }
};

/// Calls use(decoder) with the decoder of a type.
template <class Use> void with_decoder(NumberType type, Use use) {
  if (type.kind == 'f') return type.bytes == 4 ? use(Decoder<float>()) : use(Decoder<double>());
  const bool has_sign = type.kind == 'i';
  switch (type.bytes) {
    case 1:
      return has_sign ? use(Decoder<std::int8_t>()) : use(Decoder<std::uint8_t>());
    case 2:
      return has_sign ? use(Decoder<std::int16_t>()) : use(Decoder<std::uint16_t>());
    case 4:
      return has_sign ? use(Decoder<std::int32_t>()) : use(Decoder<std::uint32_t>());
    case 8:
      return has_sign ? use(Decoder<std::int64_t>()) : use(Decoder<std::uint64_t>());
  }
}

}  // namespace

double number_at(const char* at, NumberType type, bool big) {
  double value = 0;
  with_decoder(type, [&](auto decode) { value = decode(at, big); });
  return value;
}

std::vector<double> numbers_in(std::string_view bytes, NumberType type, bool big) {
  std::vector<double> values(type.bytes == 0 ? 0 : bytes.size() / type.bytes);
  with_decoder(type, [&](auto decode) {
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = decode(bytes.data() + k * type.bytes, big);
  });
  return values;
}

std::vector<double> take_numbers(std::string_view& text, std::uint64_t count) {
  std::vector<double> values;
  values.reserve(
      std::min<std::uint64_t>(count, (text.size() + 1) / 2));  // a digit and a space each
  for (std::string_view rest = text; values.size() < count; text = rest) {
    const auto value = number_in(take_word(rest, white_space));
    if (!value || !std::isfinite(*value)) break;
    values.push_back(*value);
  }
  text.remove_prefix(std::min(text.find_first_not_of(white_space), text.size()));
  return values;
}

}  // namespace freshet
