// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "engine/cloud/record.h"

namespace ilot::laz {

// The core of point formats 6-10, with its bit fields.
struct Point14 {
  std::int32_t x, y, z;
  std::uint16_t intensity;
  std::uint8_t returns;  // bits 0-3 return number, 4-7 number of returns
  std::uint8_t flags;    // bits 0-3 class flags, 4-5 scanner channel, 6 scan direction, 7 edge
  std::uint8_t classification, user;
  std::int16_t angle;
  std::uint16_t source;
  std::uint64_t gps_time;

  static constexpr std::size_t kSize = 30;
  static constexpr std::size_t kGpsOffset = 22;
  static Point14 from(const std::byte* record) {
    Point14 p;
    std::memcpy(&p, record, kGpsOffset);
    p.gps_time = load<std::uint64_t>(record + kGpsOffset);
    return p;
  }
  void to(std::byte* record) const {
    store(record, x);
    store(record + 4, y);
    store(record + 8, z);
    store(record + 12, intensity);
    store(record + 14, returns);
    store(record + 15, flags);
    store(record + 16, classification);
    store(record + 17, user);
    store(record + 18, angle);
    store(record + 20, source);
    store(record + kGpsOffset, gps_time);
  }
  std::uint32_t r() const { return returns & 15u; }
  std::uint32_t n() const { return returns >> 4; }
  std::uint32_t channel() const { return (flags >> 4) & 3u; }
  std::uint32_t flag_bits() const { return (flags & 15u) | (flags >> 6) << 4; }
  void set_channel(std::uint32_t c) { flags = static_cast<std::uint8_t>((flags & ~0x30u) | c << 4); }
  void set_flag_bits(std::uint32_t f) {
    flags = static_cast<std::uint8_t>((flags & 0x30u) | (f & 15u) | (f >> 4) << 6);
  }
};

}  // namespace ilot::laz
