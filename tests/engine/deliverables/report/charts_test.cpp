// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/charts.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ilot {
namespace {

TEST(Charts, EveryValueIsInOneBar) {
  const std::array<double, 6> values{-1, 0.5, 1, 1.5, 2, NAN};
  const std::array<int, 6> series{0, 1, 0, 0, 1, 0};
  const std::array<double, 2> edges{1, 2};
  const std::vector<ChartBar> bars = histogram(values, series, 2, edges, 100, 0);
  ASSERT_EQ(bars.size(), 3u);
  EXPECT_EQ(bars[0].parts, (std::vector<double>{1, 1}));
  EXPECT_EQ(bars[1].parts, (std::vector<double>{2, 0}));  // an edge belongs to the bar above it
  EXPECT_EQ(bars[2].parts, (std::vector<double>{0, 1}));
  EXPECT_EQ(bars[0].label, "< 100");
  EXPECT_EQ(bars[1].label, "100–200");
  EXPECT_EQ(bars[2].label, "≥ 200");
}

TEST(Charts, LegendsNameWhatIsDrawn) {
  const std::string svg =
      chart_svg({"<title>", "cm", {"seen", "never", "hidden"}, {{"a", {3, 0, 0}}, {"b", {0, 0, 1}}}});
  EXPECT_NE(svg.find("&lt;title&gt;"), std::string::npos);
  EXPECT_NE(svg.find("</i>seen"), std::string::npos);
  EXPECT_NE(svg.find("</i>hidden"), std::string::npos);
  EXPECT_EQ(svg.find("</i>never"), std::string::npos);
  EXPECT_EQ(chart_svg({"t", "m", {"one"}, {{"a", {0}}}}).find("<rect"), std::string::npos);
}

}  // namespace
}  // namespace ilot
