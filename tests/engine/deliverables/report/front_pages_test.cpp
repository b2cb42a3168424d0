// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/front_pages.h"

#include <gtest/gtest.h>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

TEST(FrontPages, ReasonsThatDifferInNumbersAreOfOneKind) {
  EXPECT_EQ(reason_kind("facade-012: 3.5 of 4 edges, 1,200 points."), "facade-#: # of # edges, # points.");
  EXPECT_EQ(reason_kind("facade-7: 30 of 41 edges, 9 points."), reason_kind("facade-012: 3 of 4 edges, 1,200 points."));
  EXPECT_NE(reason_kind("no plane has enough points"), reason_kind("no point"));
}

TEST(FrontPages, OneLineAReasonWithItsCount) {
  ResultFolder result;
  result.run["skipped"] = nlohmann::ordered_json::array();
  for (int i = 0; i < 9; ++i)
    result.run["skipped"].push_back(
        {{"what", "unit"}, {"where", "<" + std::to_string(i)}, {"reason", std::to_string(i) + " points"}});
  result.run["rejected"] = {{"<stray>", 12}};
  result.run["warnings"] = {"no station is known"};
  const std::string html = left_out_section(result);
  EXPECT_NE(html.find("<tr><td class=\"n\">9</td><td>unit</td><td>for example: 0 points</td>"), std::string::npos)
      << html;
  EXPECT_NE(html.find("&lt;0, &lt;1"), std::string::npos);
  EXPECT_NE(html.find("<td class=\"n\">12</td><td>&lt;stray&gt;</td>"), std::string::npos);
  EXPECT_NE(html.find("no station is known"), std::string::npos);
}

TEST(ResultFolder, RefusesWhatIsNoResult) {
  const TemporaryFolder folder;
  EXPECT_THROW(open_result(folder.path()), Error);
  for (const char* text : {"", "[]", "{}", "{\"results\": 3, \"products\": []}", "{\"results\": [{\"path\": 1}]}"}) {
    folder.put("run.json", text);
    EXPECT_THROW(open_result(folder.path()), Error) << text;
  }
  folder.put("run.json", R"({"results": [{"path": "a \\xE9.csv", "bytes": 3}], "products": ["planes"]})");
  const ResultFolder result = open_result(folder.path());
  EXPECT_TRUE(result.has("a \xE9.csv"));
  EXPECT_TRUE(result.makes("planes"));
  EXPECT_FALSE(result.makes("roofs"));
  EXPECT_EQ(result.count("roofs", "buildings"), 0u);
}

}  // namespace
}  // namespace ilot
