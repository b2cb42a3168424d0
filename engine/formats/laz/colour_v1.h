// SPDX-License-Identifier: Apache-2.0
// Colours in item version 1: only the changed bytes, each predicted from the last point.
#pragma once
#include <bit>
#include <cstdint>

#include "engine/formats/laz/colour.h"
#include "engine/formats/laz/integer_codec.h"

namespace ilot::laz {

template <class Coder>
class RgbCodecV1 {
 public:
  // Encodes `value` relative to the last colour, or decodes it.
  void code(Coder& coder, const Rgb& last, Rgb& value) {
    const Bytes before = std::bit_cast<Bytes>(last);
    Bytes bytes = Coder::kEncodes ? std::bit_cast<Bytes>(value) : before;
    const std::uint32_t used = coder.symbol(used_, Coder::kEncodes ? changes(before, bytes) : 0);
    for (std::uint32_t i = 0; i < kBytes; ++i)
      if (used >> i & 1u) bytes.v[i] = static_cast<std::uint8_t>(bytes_.code(coder, before.v[i], bytes.v[i], i));
    value = std::bit_cast<Rgb>(bytes);
  }

 private:
  static constexpr std::uint32_t kBytes = 6;
  struct Bytes {  // as in the file: red, green, blue, low byte first
    std::uint8_t v[kBytes];
  };
  static_assert(std::endian::native == std::endian::little && sizeof(Rgb) == sizeof(Bytes));

  static std::uint32_t changes(const Bytes& a, const Bytes& b) {
    std::uint32_t changed = 0;
    for (std::uint32_t i = 0; i < kBytes; ++i) changed |= (a.v[i] != b.v[i] ? 1u : 0u) << i;
    return changed;
  }

  typename Coder::template Model<64> used_;
  IntegerCodec<Coder, 8, kBytes> bytes_;
};

}  // namespace ilot::laz
