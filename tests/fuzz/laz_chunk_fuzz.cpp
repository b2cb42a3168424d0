// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as one LAZ chunk. The first five bytes choose the layout, the number of points and the fields; the
// rest is the chunk.
#include <vector>

#include "engine/cloud/record.h"
#include "engine/formats/laz/chunk.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  if (size < 5) return 0;
  const auto format = static_cast<std::uint8_t>(data[0] % 11);
  const auto length = static_cast<std::uint16_t>(standard_size(format) + data[1] % 5);
  const auto version = static_cast<std::uint8_t>((format < 6 ? 1 : 3) + (data[1] >> 7));
  const std::size_t points = 1 + data[2] + 256u * (data[3] & 3u);
  const std::uint32_t fields = data[4] == 0 ? kAllFields : data[4] * 16u;
  // Decoders outlive chunks, as in a run: what one chunk leaves behind must not matter to the next.
  static std::vector<std::vector<laz::ChunkDecoder>> decoders(11 * 5 * 2);
  auto& slot = decoders[(format * 5u + data[1] % 5u) * 2 + (data[1] >> 7)];
  if (slot.empty()) slot.emplace_back(laz::ChunkLayout{format, length, version});
  std::vector<std::byte> records(points * length);
  laz::decode_chunk(slot[0], std::as_bytes(std::span(data + 5, size - 5)), records, length, fields);
  return 0;
}
