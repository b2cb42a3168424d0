// SPDX-License-Identifier: Apache-2.0
// The parts of LAS and LAZ files before and behind the points. (ASPRS LAS 1.4 R15)
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/cloud/cloud_info.h"
#include "engine/formats/file.h"

namespace ilot {

// Places in the public header block, in bytes.
namespace las {
constexpr std::size_t kGlobalEncoding = 6, kMajor = 24, kMinor = 25, kSystem = 26, kSoftware = 58, kDayOfYear = 90,
                      kYear = 92, kHeaderSize = 94, kPointOffset = 96, kVlrCount = 100, kFormat = 104,
                      kRecordLength = 105, kLegacyCount = 107, kLegacyReturns = 111, kScale = 131, kOffset = 155,
                      kBounds = 179, kWaveform = 227, kEvlrOffset = 235, kEvlrCount = 243, kCount = 247, kReturns = 255;
constexpr std::size_t kVlrHeader = 54, kEvlrHeader = 60, kLargestVlr = 65535;
constexpr std::uint16_t kWktBit = 16, kWaveformInternalBit = 2;
// Returns the size of the header block that a minor version needs.
constexpr std::size_t header_size(int minor) {
  return minor >= 4 ? 375 : minor == 3 ? 235 : 227;
}
}  // namespace las

struct LasContainer {
  // The layout has the plain point format (compression bits removed). points is the number that the file can contain
  // when the points are not compressed, else the declared count. format is "las" or "laz". The LASzip VLR is among
  // vlrs.
  CloudInfo info;
  std::uint64_t point_offset = 0;
  std::uint64_t point_end = 0;  // end of the file, or start of the EVLRs when they are behind the points
  bool compressed = false;
};

bool looks_like_las(std::span<const std::byte> beginning);

// Reads the header block, VLRs and EVLRs. Throws Error when the points cannot be interpreted: the file is not LAS, or
// the version, point format, record length, scale, offset or place of the points is wrong. Everything else is a
// warning. Payloads above 64 MiB in total (waveforms) are left out with a warning. Fills in extra-byte fields and the
// CRS. O(bytes of the VLRs).
LasContainer parse_las(const InputFile& file);

}  // namespace ilot
