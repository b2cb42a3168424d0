// SPDX-License-Identifier: Apache-2.0
// The streams of a layered chunk.
#pragma once
#include <cstddef>
#include <cstdint>

#include "engine/cloud/record.h"
#include "engine/formats/laz/chunk.h"
#include "engine/formats/laz/wavepacket.h"

namespace ilot::laz {

// The streams of a chunk in file order; the streams of the items behind the core begin at kCoreLayers.
enum Layer : std::uint32_t {
  kLayerXy,
  kLayerZ,
  kLayerClass,
  kLayerFlags,
  kLayerIntensity,
  kLayerAngle,
  kLayerUser,
  kLayerSource,
  kLayerGps,
  kCoreLayers
};

// The offsets in the record of the items behind the core, and their streams; 0: absent.
struct LayeredPlan {
  explicit LayeredPlan(const ChunkLayout& layout) {
    const std::uint8_t format = layout.point_format;
    std::uint32_t layer = kCoreLayers;
    rgb = static_cast<std::uint32_t>(rgb_offset(format).value_or(0));
    nir = static_cast<std::uint32_t>(nir_offset(format).value_or(0));
    extra = static_cast<std::uint32_t>(standard_size(format));
    if (format >= 9) wave = extra - static_cast<std::uint32_t>(kWavepacketSize);
    extra_count = layout.record_length - extra;
    if (rgb) rgb_layer = layer++;
    if (nir) nir_layer = layer++;
    if (wave) wave_layer = layer++;
    extra_layer = layer;
    layers = layer + extra_count;
    record_length = layout.record_length;
  }
  std::size_t fixed_bytes() const { return record_length + 4 + std::size_t{4} * layers; }

  std::uint32_t rgb = 0, nir = 0, wave = 0, extra = 0, extra_count = 0;
  std::uint32_t rgb_layer = 0, nir_layer = 0, wave_layer = 0, extra_layer = 0;
  std::uint32_t layers = 0, record_length = 0;
};

}  // namespace ilot::laz
