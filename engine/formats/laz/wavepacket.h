// SPDX-License-Identifier: Apache-2.0
// References to waveform packets. Most packets follow each other directly in the file.
#pragma once
#include <cstdint>

#include "engine/cloud/record.h"
#include "engine/formats/laz/integer_codec.h"

namespace ilot::laz {

constexpr std::size_t kWavepacketSize = 29;

struct Wavepacket {
  std::uint8_t descriptor;
  std::uint64_t offset;
  std::uint32_t size;
  std::int32_t parameters[4];  // return location, dx, dy, dz: bits of floats

  static Wavepacket from(const std::byte* p) {
    Wavepacket w{load<std::uint8_t>(p), load<std::uint64_t>(p + 1), load<std::uint32_t>(p + 9), {}};
    for (std::size_t i = 0; i < 4; ++i) w.parameters[i] = load<std::int32_t>(p + 13 + 4 * i);
    return w;
  }
  void to(std::byte* p) const {
    store(p, descriptor);
    store(p + 1, offset);
    store(p + 9, size);
    for (std::size_t i = 0; i < 4; ++i) store(p + 13 + 4 * i, parameters[i]);
  }
};

template <class Coder>
class WavepacketCodec {
 public:
  void start() {
    last_difference_ = 0;
    last_kind_ = 0;
  }

  // Encodes `w` relative to the last packet, or decodes it.
  void code(Coder& coder, const Wavepacket& last, Wavepacket& w) {
    w.descriptor = static_cast<std::uint8_t>(coder.symbol(descriptor_, w.descriptor));
    code_offset(coder, last, w);
    w.size = static_cast<std::uint32_t>(
        size_.code(coder, static_cast<std::int32_t>(last.size), static_cast<std::int32_t>(w.size), 0));
    w.parameters[0] = location_.code(coder, last.parameters[0], w.parameters[0], 0);
    for (std::uint32_t i = 1; i < 4; ++i) {
      w.parameters[i] = direction_.code(coder, last.parameters[i], w.parameters[i], i - 1);
    }
  }

 private:
  enum Kind : std::uint32_t { kSame, kNext, kNear, kFar };

  void code_offset(Coder& coder, const Wavepacket& last, Wavepacket& w) {
    const std::uint32_t kind = Coder::kEncodes ? kind_of(last, w) : 0;
    last_kind_ = coder.symbol(kind_[last_kind_], kind);
    switch (last_kind_) {
      case kSame:
        w.offset = last.offset;
        break;
      case kNext:
        w.offset = last.offset + last.size;
        break;
      case kNear:
        last_difference_ =
            difference_.code(coder, last_difference_, static_cast<std::int32_t>(w.offset - last.offset), 0);
        w.offset = last.offset + static_cast<std::uint64_t>(static_cast<std::int64_t>(last_difference_));
        break;
      default:
        w.offset = raw64(coder, w.offset);
    }
  }

  static std::uint32_t kind_of(const Wavepacket& last, const Wavepacket& w) {
    const auto difference = static_cast<std::int64_t>(w.offset - last.offset);
    if (difference == 0) return kSame;
    if (difference != static_cast<std::int32_t>(difference)) return kFar;
    return difference == static_cast<std::int64_t>(last.size) ? kNext : kNear;
  }

  std::int32_t last_difference_;
  std::uint32_t last_kind_;
  typename Coder::template Model<256> descriptor_;
  typename Coder::template Model<4> kind_[4];
  IntegerCodec<Coder, 32, 1> difference_, size_, location_;
  IntegerCodec<Coder, 32, 3> direction_;
};

}  // namespace ilot::laz
