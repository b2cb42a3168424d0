// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/pages/facades_page.h"

#include <gtest/gtest.h>

#include "engine/deliverables/drawings/facade_drawing.h"
#include "tests/support/facades.h"
#include "tests/support/file_bytes.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

Facade listed_facade(std::uint32_t id) {
  FacadeElement hidden = drawn("window", wall_rectangle(1, 1, 2, 3), DrawnStatus::occluded);
  hidden.reason = "behind <a van>";
  FacadeElement partly = drawn("door", wall_rectangle(3, 0, 4, 3));
  partly.edges.assign(4, {DrawnStatus::seen, 9, 0.001, 0.004, 0, {}, 1});
  partly.edges[0].status = DrawnStatus::completed;
  Facade facade = facade_of({hidden, partly, drawn("window", wall_rectangle(5, 1, 6, 3))});
  facade.id = id;
  return facade;
}

TEST(FacadesPage, CountsDrawsAndListsWhatIsDoubtful) {
  const TemporaryFolder folder;
  FacadesPage page(folder.path() / "facades.html", preset_layers("ilot"));
  for (const std::uint32_t id : {1, 2})
    page.add(listed_facade(id), facade_drawing(listed_facade(id)), SvgUnderlay{"facade-001.png", {0, 0, 7, 4}});
  page.finish();
  const std::string html = test::file_bytes(folder.path() / "facades.html");
  EXPECT_NE(html.find("<h1>Facades: 2</h1>"), std::string::npos);
  EXPECT_NE(html.find("6 elements, 8 edges, of them 2 completed and 0 occluded"), std::string::npos);
  EXPECT_NE(html.find("<tr><td>window</td><td class=\"n\">2</td><td class=\"n\">0</td><td class=\"n\">2</td></tr>"),
            std::string::npos);
  EXPECT_EQ(count(html, "<svg"), 2u);
  EXPECT_EQ(count(html, "<image class=\"underlay\" href=\"facade-001.png\""), 2u);
  EXPECT_EQ(count(html, "behind &lt;a van&gt;"), 2u);
  EXPECT_EQ(count(html, "<td>seen</td><td class=\"n\">4</td>"),
            2u);  // the doors; windows that are seen whole are not listed
  EXPECT_EQ(count(html, "<td>occluded</td><td class=\"n\">0</td>"), 2u);
  EXPECT_NE(html.find("href=\"facade-002.dxf\""), std::string::npos);
  EXPECT_EQ(count(html, "<path class=\"note-weak\""), 2u);  // the doors' bottoms
  EXPECT_EQ(count(html, "<path class=\"note-good\""), 6u);
  EXPECT_EQ(count(html, "<title>2 door, left: 9 points, 1.0 mm RMS, along 100 % of it, within 4.0 mm, seen</title>"),
            2u);
  EXPECT_EQ(count(html, "value=\"proof\""), 2u);
  EXPECT_EQ(count(html, "<td>bottom</td><td>completed</td><td class=\"n\">9</td>"), 2u);
}

TEST(FacadesPage, ReportsEdgesThatWereSeenAndHaveNoPoints) {
  const TemporaryFolder folder;
  FacadesPage page(folder.path() / "facades.html", preset_layers("ilot"));
  FacadeElement window = drawn("window", wall_rectangle(1, 1, 2, 3));
  window.edges.assign(4, {DrawnStatus::seen, 9, 0.001, 0.004, 0, {}, 1});
  page.add(facade_of({window}), facade_drawing(facade_of({window})), {});
  window.edges[2] = {DrawnStatus::seen, 0, 0, 0.004, 0, {}, 0};
  window.edges[3].covered_share = 0.4;
  page.add(facade_of({window}), facade_drawing(facade_of({window})), {});
  page.finish();
  const std::string html = test::file_bytes(folder.path() / "facades.html");
  EXPECT_NE(html.find("<p>Everything drawn was seen.</p>"), std::string::npos);
  EXPECT_EQ(count(html, "Of 2 edges half has no points"), 1u);
}

TEST(FacadesPage, IsBounded) {
  const TemporaryFolder folder;
  FacadesPage page(folder.path() / "facades.html", preset_layers("ilot"), 60000);
  Facade large = listed_facade(1);
  for (int i = 0; i < 300; ++i) large.elements.push_back(large.elements[0]);
  page.add(large, facade_drawing(large), {});
  for (std::uint32_t id = 2; id < 9; ++id) page.add(listed_facade(id), facade_drawing(listed_facade(id)), {});
  page.finish();
  const std::string html = test::file_bytes(folder.path() / "facades.html");
  EXPECT_NE(html.find("200 of 302 are listed"), std::string::npos);
  EXPECT_LT(count(html, "<svg"), 8u);
  EXPECT_EQ(count(html, "<summary>Facade "), 8u);
  EXPECT_NE(html.find("of 8 facades are shown"), std::string::npos);
}

}  // namespace
}  // namespace ilot
