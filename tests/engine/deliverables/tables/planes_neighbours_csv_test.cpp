// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/planes_neighbours_csv.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

TEST(PlanesNeighboursCsv, OneLineAPair) {
  const TemporaryFolder folder;
  const PlaneNeighbours pairs[]{{1, 2, Touching::edge, 4.5, 90, 0, {1.5, 2, 3}, {0, 0, 1}},
                                {1, 7, Touching::step, 0.25, 0.5, -0.125, {1, 2, 3.5}, {}}};
  PlanesNeighboursCsv file(folder.path() / "n.csv");
  for (const PlaneNeighbours& pair : pairs) file.add(pair);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "n.csv"));
  file.finish();
  std::ostringstream text;
  text << std::ifstream(folder.path() / "n.csv").rdbuf();
  EXPECT_EQ(text.str(),
            "plane_id,neighbour_id,touching,contact_m,angle_deg,step_m,x,y,z,dx,dy,dz\n"
            "1,2,edge,4.5,90,0,1.5,2,3,0,0,1\n"
            "1,7,step,0.25,0.5,-0.125,1,2,3.5,0,0,0\n");
}

}  // namespace
}  // namespace ilot
