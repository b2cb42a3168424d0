// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as CityJSON or CityJSONSeq, and cuts faces with few corners into triangles.
#include <cstdint>

#include "engine/deliverables/solids/model_file.h"
#include "engine/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  try {
    const ModelFile file = parse_city_json({reinterpret_cast<const char*>(data), size}, "fuzz.json");
    for (const PolygonModel& model : file.models) {
      roof_faces(model);
      is_closed(model);
      std::vector<Triangle3> triangles;
      for (const PolygonFace& face : model.faces)
        if (face.rings.size() <= 8 && face.rings[0].size() <= 100) append_triangles(model, face, triangles);
    }
  } catch (const Error&) {
  }
  return 0;
}
