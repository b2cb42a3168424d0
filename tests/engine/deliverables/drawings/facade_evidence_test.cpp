// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_evidence.h"

#include <gtest/gtest.h>

#include "tests/support/facades.h"

namespace ilot {
namespace {

FacadeElement a_window() {
  FacadeElement window = drawn("window", wall_rectangle(1, 2, 2, 4));
  window.id = 5;
  window.edges = {{DrawnStatus::completed, 12, 0.001, 0.005, 0.01, 0.25, 0.3},
                  {DrawnStatus::seen, 143, 0.0021, 0.004, 0, 0.0, 0.98},
                  {DrawnStatus::seen, 0, 0, 0.004, 0, {}},
                  {DrawnStatus::seen, 143, 0.0021, 0.004, 0, 0.5, 0.9}};
  window.faces = {{"front", 900, 0.003, 0.1}, {"left", 0, 0, 1.0}};
  return window;
}

TEST(FacadeEvidence, SaysWhyAnEdgeIsBelieved) {
  FacadeElement window = a_window();
  EXPECT_EQ(words_of(window, "right", window.edges[1]),
            "5 window, right: 143 points, 2.1 mm RMS, along 98 % of it, 0 % occluded, within 4.0 mm, seen");
  EXPECT_EQ(words_of(window, "top", window.edges[2]), "5 window, top: 0 points, within 4.0 mm, seen");
  window.reason = "behind its sill";
  EXPECT_EQ(words_of(window, "bottom", window.edges[0]),
            "5 window, bottom: 12 points, 1.0 mm RMS, along 30 % of it, 25 % occluded, within 5.0 mm, completed "
            "(behind its sill)");
}

TEST(FacadeEvidence, EdgesAreNamedAndBelievedByWhatIsKnown) {
  const FacadeElement window = a_window();
  const Facade facade = facade_of({window});
  const std::vector<SvgNote> notes = edge_notes(window, flat_element(facade, window, 1));
  ASSERT_EQ(notes.size(), 4u);
  const char* sides[] = {"bottom", "right", "top", "left"};
  const char* kinds[] = {"weak", "good", "none", "weak"};  // completed, seen, without points, half hidden
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NE(notes[i].text.find(std::string(", ") + sides[i] + ":"), std::string::npos) << notes[i].text;
    EXPECT_EQ(notes[i].kind, kinds[i]) << i;
  }
  FacadeElement bare = window;
  bare.edges[1].covered_share = 0.4;
  EXPECT_EQ(edge_notes(bare, flat_element(facade, bare, 1))[1].kind, "weak") << "most of it has no points";
  EXPECT_EQ(notes[1].from.x, 2);
  EXPECT_EQ(notes[1].to.y, 4);
}

TEST(FacadeEvidence, RowsOfEdgesAndFaces) {
  const FacadeElement window = a_window();
  const FlatElement flat = flat_element(facade_of({window}), window, 1);
  std::string rows;
  EXPECT_EQ(add_evidence_rows(window, flat, 100, rows), 6u);
  EXPECT_NE(rows.find("<td>left face</td><td></td><td class=\"n\">0</td><td class=\"n\"></td><td class=\"n\"></td><td "
                      "class=\"n\"></td><td class=\"n\">100</td>"),
            std::string::npos)
      << rows;
  rows.clear();
  EXPECT_EQ(add_evidence_rows(window, flat, 1, rows), 6u) << "there are as many, one is listed";
  EXPECT_EQ(rows.find("right"), std::string::npos);
  EXPECT_NE(rows.find("bottom"), std::string::npos);
}

TEST(FacadeEvidence, NothingIsSaidOfEdgesThatNobodyKnows) {
  const FacadeElement bare = drawn("band", wall_rectangle(0, 0, 1, 1));
  EXPECT_TRUE(edge_notes(bare, flat_element(facade_of({bare}), bare, 1)).empty());
}

}  // namespace
}  // namespace ilot
