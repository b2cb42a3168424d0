// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/planes_neighbours_csv.h"

#include <fmt/format.h>

#include <string>

namespace ilot {

PlanesNeighboursCsv::PlanesNeighboursCsv(const std::filesystem::path& path) : file_(path) {
  file_.append("plane_id,neighbour_id,touching,contact_m,angle_deg,step_m,x,y,z,dx,dy,dz\n");
}

void PlanesNeighboursCsv::add(const PlaneNeighbours& p) {
  file_.append(fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", p.a, p.b,
                           p.touching == Touching::edge ? "edge" : "step", p.contact_m, p.angle_deg, p.step_m,
                           p.place.x, p.place.y, p.place.z, p.direction.x, p.direction.y, p.direction.z));
}

}  // namespace ilot
