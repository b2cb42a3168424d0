// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/planes_csv.h"

#include <fmt/format.h>

#include "engine/whole_file.h"

namespace ilot {

void write_planes_csv(const std::filesystem::path& path, std::span<const Segment> segments) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text),
                 "plane_id,content_id,points,nx,ny,nz,d,epsilon_m,rms_m,centroid_x,centroid_y,centroid_z,min_x,min_y,"
                 "min_z,max_x,max_y,max_z\n");
  for (const Segment& s : segments) {
    fmt::format_to(std::back_inserter(text), "{},{:016x},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", s.id,
                   s.content_id, s.points, s.plane.n.x, s.plane.n.y, s.plane.n.z, s.plane.d, s.epsilon_m, s.rms_m,
                   s.centroid.x, s.centroid.y, s.centroid.z, s.min.x, s.min.y, s.min.z, s.max.x, s.max.y, s.max.z);
  }
  write_whole_file(path, {text.data(), text.size()});
}

}  // namespace ilot
