// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/planes_neighbours_csv.h"

#include <fmt/format.h>

#include <string>

#include "engine/whole_file.h"

namespace ilot {

void write_planes_neighbours_csv(const std::filesystem::path& path, std::span<const PlaneNeighbours> pairs) {
  std::string text = "plane_id,neighbour_id,touching,contact_m,angle_deg,step_m,x,y,z,dx,dy,dz\n";
  for (const PlaneNeighbours& p : pairs)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", p.a, p.b,
                        p.touching == Touching::edge ? "edge" : "step", p.contact_m, p.angle_deg, p.step_m, p.place.x,
                        p.place.y, p.place.z, p.direction.x, p.direction.y, p.direction.z);
  write_whole_file(path, text);
}

}  // namespace ilot
