// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/stations_file.h"

#include <fmt/format.h>

#include <string>

#include "engine/formats/file.h"

namespace ilot::scan {

std::filesystem::path stations_path(const std::filesystem::path& cloud) {
  std::filesystem::path path = cloud;
  return path.replace_extension(".stations.csv");
}

void write_stations(const std::filesystem::path& path, std::span<const StationParams> stations, Vec3 origin) {
  std::string text = "name,x,y,z,azimuth_step_deg,elevation_step_deg\n";
  for (const StationParams& s : stations) {
    const Vec3 p = origin + s.position;
    text +=
        fmt::format("{},{:.4f},{:.4f},{:.4f},{},{}\n", s.id, p.x, p.y, p.z, s.step_horizontal_deg, s.step_vertical_deg);
  }
  OutputFile file(path);
  file.append(std::as_bytes(std::span(text)));
  file.commit();
}

}  // namespace ilot::scan
