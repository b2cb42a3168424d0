// SPDX-License-Identifier: Apache-2.0
// Small models for tests: a block of 10 x 8 x 6 m with one recessed window.
#pragma once
#include <fmt/format.h>

#include <string>
#include <utility>

namespace ilot::scan::test_models {

// A ring of four vertices.
inline std::string ring(int a, int b, int c, int d) {
  return fmt::format("[{},{},{},{}]", a, b, c, d);
}

// CityJSON in millimetres. The south wall (y = 0) has a hole of 1.2 x 1.5 m from (2, 1) on. In it, 10 cm behind, stands
// a window: a frame of 6 cm around one pane. `turned` turns all faces inside out. `head` is put into the file's head.
inline std::string block(bool turned = false, const std::string& head = "", bool flush = false) {
  std::string v;
  const auto add = [&](int x, int y, int z) { v += fmt::format("{}[{},{},{}]", v.empty() ? "" : ",", x, y, z); };
  for (const int z : {0, 6000})
    for (const auto& [x, y] : {std::pair{0, 0}, {10000, 0}, {10000, 8000}, {0, 8000}}) add(x, y, z);
  const int back = flush ? 0 : 100;
  for (const int inset : {0, 60})  // 8 to 11: the opening; 12 to 15: the pane
    for (const auto& [x, z] : {std::pair{2000 + inset, 1000 + inset},
                               {3200 - inset, 1000 + inset},
                               {3200 - inset, 2500 - inset},
                               {2000 + inset, 2500 - inset}})
      add(x, inset ? back : 0, z);
  for (const auto& [x, z] : {std::pair{2000, 1000}, {3200, 1000}, {3200, 2500}, {2000, 2500}}) add(x, back, z);
  const auto face = [&](std::string outer, const std::string& hole = "") {
    return "[" + outer + (hole.empty() ? "" : "," + hole) + "]";
  };
  const auto r = [&](int a, int b, int c, int d) { return turned ? ring(d, c, b, a) : ring(a, b, c, d); };
  std::string faces = face(r(3, 2, 1, 0)) + "," + face(r(4, 5, 6, 7)) + "," + face(r(0, 1, 5, 4), r(11, 10, 9, 8)) +
                      "," + face(r(1, 2, 6, 5)) + "," + face(r(2, 3, 7, 6)) + "," + face(r(3, 0, 4, 7)) + "," +
                      face(r(12, 13, 14, 15)) + "," + face(r(16, 17, 18, 19), r(15, 14, 13, 12));
  std::string values = "0,1,2,2,2,2,3,3";
  if (!flush) {  // the reveal
    for (int i = 0; i < 4; ++i) faces += "," + face(r(8 + i, 8 + (i + 1) % 4, 16 + (i + 1) % 4, 16 + i));
    values += ",2,2,2,2";
  }
  return R"({"type":"CityJSON","version":"2.0",)" + head +
         R"("transform":{"scale":[0.001,0.001,0.001],"translate":[678000,5403000,410]},)"
         R"("CityObjects":{"b":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"3","boundaries":[)" +
         faces +
         R"(],"semantics":{"surfaces":[{"type":"GroundSurface"},{"type":"RoofSurface"},{"type":"WallSurface"},)"
         R"({"type":"Window","parent":2}],"values":[)" +
         values + R"(]}}]}},"vertices":[)" + v + "]}";
}

}  // namespace ilot::scan::test_models
