// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/html.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ilot {
namespace {

TEST(Html, NoTextBecomesMarkup) {
  EXPECT_EQ(html_text("<script>\"a\" & b</script>"), "&lt;script&gt;&quot;a&quot; &amp; b&lt;/script&gt;");
  EXPECT_EQ(html_text(std::string("a\n\tb\0c", 6)), "a  b c");
  HtmlTable table({{"<b>", true}});
  table.add({html_text("<i>")}, "\"x");
  EXPECT_NE(table.html().find("<th class=\"n\">&lt;b&gt;</th>"), std::string::npos);
  EXPECT_NE(table.html().find("<tr id=\"&quot;x\"><td class=\"n\">&lt;i&gt;</td></tr>"), std::string::npos);
}

TEST(Html, LinksLeadToFilesOfAnyName) {
  EXPECT_EQ(url_of_path("points/a b#1%.laz"), "points/a%20b%231%25.laz");
  EXPECT_EQ(url_of_path("\xE9\"'<"), "%E9%22%27%3C");
  EXPECT_EQ(url_of_path("javascript:alert(1)"), "javascript%3Aalert%281%29");
  EXPECT_EQ(file_link("a/b.csv", "<b>"), "<a href=\"a/b.csv\">&lt;b&gt;</a>");
}

TEST(Html, NumbersAreShort) {
  EXPECT_EQ(number_text(1.500, 3), "1.5");
  EXPECT_EQ(number_text(100, 0), "100");
  EXPECT_EQ(number_text(-0.0001, 2), "0");
  EXPECT_EQ(number_text(NAN, 2), "");
  EXPECT_EQ(bytes_text(999), "999 B");
  EXPECT_EQ(bytes_text(3449000), "3.4 MB");
  EXPECT_EQ(bytes_text(999600), "1.0 MB");
  EXPECT_EQ(bytes_text(25'300'000), "25 MB");
}

}  // namespace
}  // namespace ilot
