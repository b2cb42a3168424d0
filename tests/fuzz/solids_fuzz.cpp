// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a model to validate. The first byte chooses the format.
#include <cstdint>
#include <string_view>

#include "engine/deliverables/solids/city_json_solids.h"
#include "engine/error.h"
#include "engine/validity/validity.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const SolidFileSink sink{[](const CityObject& object) { validate_object(object); }, [](const FormatFault&) {}};
  try {
    if (data[0] == 'o') {
      sink.object(parse_off(text, "fuzz.off"));
    } else if (data[0] == 'p') {
      sink.object(parse_poly(text, "fuzz.poly"));
    } else {
      CityJsonSolids solids("fuzz.json", sink);
      solids.text(text, 0);
      solids.finish();
    }
  } catch (const Error&) {
  }
  return 0;
}
