// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/facade_table.h"

#include <gtest/gtest.h>

#include "tests/support/facades.h"

namespace ilot {
namespace {

TEST(FacadeTable, OneLineAnElement) {
  FacadeElement window = drawn("window", wall_rectangle(1, 2.5, 2, 4), DrawnStatus::completed);
  window.family = 3;
  window.row = 2;
  window.column = 1;
  window.width_m = 1;
  window.height_m = 1.5;
  window.depth_m = -0.28;
  window.width_error_m = 0.004;
  window.points = 77;
  window.reason = "from its family, \"3\"";
  window.edges = {{DrawnStatus::completed, 6, 0.001, 0.005, 0.01, 0.5, 0.2},
                  {DrawnStatus::seen, 9, 0, 0, 0, 0.0, 1},
                  {DrawnStatus::occluded, 4, 0.002, 0.003, 0, 1.0, 0},
                  {DrawnStatus::seen, 8, 0, 0, 0, 0.0, 1}};
  const std::string table = facade_table(facade_of({window, drawn("=SUM(A1)", wall_rectangle(0, 0, 1, 1))}));
  EXPECT_NE(
      table.find("\n1,1,window,3,2,1,completed,1.0000,1.5000,-0.2800,0.0040,0.0000,0.0000,1.0000,2.5000,4.0000,4,1,"
                 "1,0.0050,4,0.0020,0.640,0.300,0.0100,0,77,\"from its family, \"\"3\"\"\"\n"),
      std::string::npos)
      << table;
  EXPECT_NE(table.find(",0,0.0000,,,0.0000,0,0,\n"), std::string::npos) << "nothing is known of the other: " << table;
  EXPECT_NE(table.find("\n1,2,\"'=SUM(A1)\",0,"), std::string::npos) << table;
}

}  // namespace
}  // namespace ilot
