// SPDX-License-Identifier: Apache-2.0
// All items of one point of formats 0-5, in one stream.
#pragma once
#include <cstdint>
#include <type_traits>

#include "engine/cloud/record.h"
#include "engine/formats/laz/chunk.h"
#include "engine/formats/laz/colour.h"
#include "engine/formats/laz/colour_v1.h"
#include "engine/formats/laz/extra_bytes_codec.h"
#include "engine/formats/laz/gps_time.h"
#include "engine/formats/laz/gps_time_v1.h"
#include "engine/formats/laz/point10.h"
#include "engine/formats/laz/point10_v1.h"
#include "engine/formats/laz/wavepacket.h"

namespace ilot::laz {

// The codecs of one version of items; waveform packets have only one version.
template <class C>
struct ItemsV1 {  // before 2011
  using Coder = C;
  using Core = Point10CodecV1<C>;
  using GpsTime = GpsTimeCodecV1<C>;
  using Colour = RgbCodecV1<C>;
  using ExtraBytes = ExtraBytesCodec<C, ByteIntegers<C>>;
};
template <class C>
struct ItemsV2 {
  using Coder = C;
  using Core = Point10Codec<C>;
  using GpsTime = GpsTimeCodec<C, true>;
  using Colour = RgbCodec<C>;
  using ExtraBytes = ExtraBytesCodec<C, ByteDifferences<C>>;
};

template <class Items>
class PointwiseCodec {
 public:
  using Coder = typename Items::Coder;
  using Byte = std::conditional_t<Coder::kEncodes, const std::byte, std::byte>;

  explicit PointwiseCodec(const ChunkLayout& layout)
      : gps_offset_(static_cast<std::uint32_t>(gps_time_offset(layout.point_format).value_or(0))),
        rgb_offset_(static_cast<std::uint32_t>(rgb_offset(layout.point_format).value_or(0))),
        wave_offset_(layout.point_format >= 4
                         ? static_cast<std::uint32_t>(standard_size(layout.point_format) - kWavepacketSize)
                         : 0),
        extra_offset_(static_cast<std::uint32_t>(standard_size(layout.point_format))),
        extra_(layout.record_length - extra_offset_) {}

  void start(const std::byte* first) {
    core_.start(load<Point10>(first));
    if (gps_offset_) gps_.start(load<std::uint64_t>(first + gps_offset_));
    if (rgb_offset_) last_rgb_ = load<Rgb>(first + rgb_offset_);
    if (wave_offset_) last_wave_ = Wavepacket::from(first + wave_offset_);
    wave_.start();
    extra_.start(first + extra_offset_);
  }

  void code(Coder& coder, Byte* record) {
    Point10 p{};
    if constexpr (kEncodes) p = load<Point10>(record);
    core_.code(coder, p);
    if constexpr (!kEncodes) core_.last().to(record);
    if (gps_offset_) code_gps(coder, record + gps_offset_);
    if (rgb_offset_) code_rgb(coder, record + rgb_offset_);
    if (wave_offset_) code_wave(coder, record + wave_offset_);
    extra_.code(coder, record + extra_offset_);
  }

 private:
  static constexpr bool kEncodes = Coder::kEncodes;

  void code_gps(Coder& coder, Byte* at) {
    std::uint64_t time = 0;
    if constexpr (kEncodes) time = load<std::uint64_t>(at);
    time = gps_.code(coder, time);
    if constexpr (!kEncodes) store(at, time);
  }
  void code_rgb(Coder& coder, Byte* at) {
    Rgb value{};
    if constexpr (kEncodes) value = load<Rgb>(at);
    rgb_.code(coder, last_rgb_, value);
    last_rgb_ = value;
    if constexpr (!kEncodes) store(at, value);
  }
  void code_wave(Coder& coder, Byte* at) {
    Wavepacket w{};
    if constexpr (kEncodes) w = Wavepacket::from(at);
    wave_.code(coder, last_wave_, w);
    last_wave_ = w;
    if constexpr (!kEncodes) w.to(at);
  }
  std::uint32_t gps_offset_, rgb_offset_, wave_offset_, extra_offset_;  // 0: absent
  Rgb last_rgb_{};
  Wavepacket last_wave_{};
  typename Items::ExtraBytes extra_;
  typename Items::Core core_{};
  typename Items::GpsTime gps_{};
  typename Items::Colour rgb_{};
  WavepacketCodec<Coder> wave_{};
};

}  // namespace ilot::laz
