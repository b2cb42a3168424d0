// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as an OBJ file of buildings.
#include <cstdint>

#include "engine/deliverables/solids/model_file.h"
#include "engine/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  try {
    const ModelFile file = parse_obj({reinterpret_cast<const char*>(data), size}, "fuzz.obj", "fuzz");
    for (const PolygonModel& model : file.models) {
      roof_faces(model);
      is_closed(model);
    }
  } catch (const Error&) {
  }
  return 0;
}
