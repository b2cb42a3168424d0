// SPDX-License-Identifier: Apache-2.0
// The 32-bit range coder of LAZ. Encoder and decoder have one interface: a codec is written once for a template
// `Coder`. An encoder encodes the value that the codec passes; a decoder ignores that value and returns the decoded
// one.
#pragma once
#include <cstdint>

#include "engine/formats/laz/decoder.h"
#include "engine/formats/laz/encoder.h"

namespace ilot::laz {

// 32 and 64 raw bits, low half first.
template <class Coder>
std::uint32_t raw32(Coder& coder, std::uint32_t v) {
  const std::uint32_t low = coder.raw(16, v & 0xFFFF);
  return coder.raw(16, v >> 16) << 16 | low;
}
template <class Coder>
std::uint64_t raw64(Coder& coder, std::uint64_t v) {
  const std::uint64_t low = raw32(coder, static_cast<std::uint32_t>(v));
  return static_cast<std::uint64_t>(raw32(coder, static_cast<std::uint32_t>(v >> 32))) << 32 | low;
}

}  // namespace ilot::laz
