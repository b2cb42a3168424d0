// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/shapes_csv.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "engine/whole_file.h"

namespace ilot {

void write_shapes_csv(const std::filesystem::path& path, std::span<const CurvedSegment> segments) {
  constexpr std::array<const char*, kShapeKinds> kNames{"plane", "sphere", "cylinder", "cone"};
  std::string text =
      "shape_id,content_id,kind,points,x,y,z,axis_x,axis_y,axis_z,radius_m,half_angle_deg,epsilon_m,rms_m,"
      "min_x,min_y,min_z,max_x,max_y,max_z\n";
  for (const CurvedSegment& s : segments)
    text += fmt::format("{},{:016x},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", s.id, s.content_id,
                        kNames[static_cast<std::size_t>(s.kind)], s.points, s.position.x, s.position.y, s.position.z,
                        s.axis.x, s.axis.y, s.axis.z, s.radius_m, s.half_angle_deg, s.epsilon_m, s.rms_m, s.min.x,
                        s.min.y, s.min.z, s.max.x, s.max.y, s.max.z);
  write_whole_file(path, text);
}

}  // namespace ilot
