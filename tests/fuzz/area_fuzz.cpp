// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as an area in GeoJSON or WKT, and as the text of --bounds.
#include <cstdint>

#include "engine/error.h"
#include "engine/run/inputs/read_area.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const Area area = parse_area(text, "fuzz.geojson");
    area.contains((area.min_x + area.max_x) / 2, area.min_y);
  } catch (const Error&) {
  }
  try {
    parse_bounds(text);
  } catch (const Error&) {
  }
  return 0;
}
