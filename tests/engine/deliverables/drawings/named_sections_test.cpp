// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/named_sections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/deliverables/drawings/facade_section.h"
#include "engine/error.h"
#include "tests/support/facades.h"

namespace ilot {
namespace {

// A wall 10 x 6 in y = 0 with a window 0.3 deep from 4 to 6, 2 to 4. The street lies at y < 0.
Facade sectioned_facade() {
  FacadeElement window = drawn("window", wall_rectangle(4, 2, 6, 4));
  window.depth_m = -0.3;
  return facade_of({window, drawn("outline", wall_rectangle(0, 0, 10, 6))});
}

struct Extent {
  double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9;
};

Extent extent_of_cut(const NamedSection& section) {
  Extent extent;
  for (const FlatEdge& e : cut_faces(facade_faces(sectioned_facade()), section.plane))
    for (const FlatPoint p : {e.a, e.b})
      extent = {std::min(extent.x0, p.x), std::max(extent.x1, p.x), std::min(extent.y0, p.y), std::max(extent.y1, p.y)};
  return extent;
}

TEST(NamedSections, AnUprightOneHasTheStreetAtItsRight) {
  const auto sections = named_sections(sectioned_facade(), {{}, {5, 0.5, 10.5, -1}, {}}, 1);
  ASSERT_EQ(sections.size(), 2u) << "beyond its ends there is no wall";
  EXPECT_EQ(sections[0].file, "section-x-5.00");
  EXPECT_EQ(sections[0].title, "Section at x = 5.00");
  const Extent window = extent_of_cut(sections[0]), wall = extent_of_cut(sections[1]);
  EXPECT_NEAR(window.x0, -0.3, 1e-9) << "the pane";
  EXPECT_NEAR(window.x1, 0, 1e-9) << "the wall";
  EXPECT_NEAR(window.y1, 6, 1e-9);
  EXPECT_NEAR(wall.x0, 0, 1e-9);
}

TEST(NamedSections, ALineCutsBetweenItsEndsAlone) {
  // Aslant through the window; along the wall's left half in its reveals; before the wall; one that ends before it.
  const std::vector<double> lines{4, -1, 6, 1, 0, 0.1, 5, 0.1, 0, -1, 10, -1, 5, -3, 5, -0.5};
  const auto sections = named_sections(sectioned_facade(), {{}, {}, lines}, 1);
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_EQ(sections[0].file, "section-line-1");
  EXPECT_EQ(sections[1].file, "section-line-2");
  EXPECT_EQ(sections[0].title, "Section from E 4.00 N -1.00 to E 6.00 N 1.00");
  const Extent aslant = extent_of_cut(sections[0]);
  EXPECT_NEAR(aslant.x0, std::sqrt(2.0), 1e-9) << "x = 0 at its first place";
  EXPECT_NEAR(aslant.x1, 1.3 * std::sqrt(2.0), 1e-9) << "the pane, 0.3 behind the wall";
  const Extent reveal = extent_of_cut(sections[1]);
  EXPECT_NEAR(reveal.x0, 4, 1e-9);
  EXPECT_LE(reveal.x1, 5 + 1e-9) << "it ends in the window's middle";
}

TEST(NamedSections, LevelsAreNamedByTheirHeight) {
  const auto sections = named_sections(sectioned_facade(), {{3, -0.001}, {}, {}}, 1);
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_EQ(sections[0].file, "section-level-3.00");
  EXPECT_EQ(sections[1].file, "section-level-0.00");
}

TEST(NamedSections, LinesHaveFourNumbersAndALength) {
  EXPECT_NO_THROW(check_section_lines({}));
  EXPECT_THROW(check_section_lines(std::vector<double>{1, 2, 3}), Error);
  EXPECT_THROW(check_section_lines(std::vector<double>{1, 2, 1, 2}), Error);
  EXPECT_THROW(named_sections(sectioned_facade(), {{}, {}, {1, 2, 3}}, 1), Error);
}

}  // namespace
}  // namespace ilot
