// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace ilot {

// Attributes of a row that a run may not need. x, y, returns and scanner channel are always read.
enum Fields : std::uint32_t {
  kFieldZ = 1,
  kFieldClass = 2,
  kFieldFlags = 4,
  kFieldIntensity = 8,
  kFieldAngle = 16,
  kFieldUser = 32,
  kFieldSource = 64,
  kFieldGpsTime = 128,
  kFieldRgb = 256,
  kFieldNir = 512,
  kFieldWavepacket = 1024,
  kFieldExtra = 2048,
  kAllFields = 4095,
};

}  // namespace ilot
