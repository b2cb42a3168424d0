// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/shapes_csv.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

TEST(ShapesCsv, ALineAShape) {
  CurvedSegment cone;
  cone.id = 2;
  cone.content_id = 255;
  cone.kind = ShapeKind::kCone;
  cone.points = 1234;
  cone.position = {652000.5, 6862000.25, 7};
  cone.axis = {0, 0, -1};
  cone.half_angle_deg = 20;
  cone.epsilon_m = 0.005;
  cone.rms_m = 0.0015;
  cone.min = {1, 2, 3};
  cone.max = {4, 5, 6};
  const TemporaryFolder folder;
  const auto path = folder.path() / "shapes.csv";
  write_shapes_csv(path, std::span(&cone, 1));
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(text,
            "shape_id,content_id,kind,points,x,y,z,axis_x,axis_y,axis_z,radius_m,half_angle_deg,epsilon_m,rms_m,"
            "min_x,min_y,min_z,max_x,max_y,max_z\n"
            "2,00000000000000ff,cone,1234,652000.5,6862000.25,7,0,0,-1,0,20,0.005,0.0015,1,2,3,4,5,6\n");
  EXPECT_THROW(write_shapes_csv(folder.path() / "none" / "shapes.csv", {}), Error);
}

}  // namespace
}  // namespace ilot
