// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/drawing.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/error.h"

namespace ilot {
namespace {

TEST(Drawing, TextsBecomeCleanUtf8) {
  EXPECT_EQ(clean_text("F\xC3\xA9n\xC3\xAAtre"), "F\xC3\xA9n\xC3\xAAtre");
  EXPECT_EQ(clean_text("a\nb\tc\x7F"), "a b c ");
  EXPECT_EQ(clean_text(std::string("a\0b", 3)), "a b");
  EXPECT_EQ(clean_text("\xC2\x85x\xE2\x80\xA8"), " x ");
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(clean_text("\xE9"), bad);                      // Latin-1
  EXPECT_EQ(clean_text("\xC0\xAF"), bad + bad);            // overlong
  EXPECT_EQ(clean_text("\xED\xA0\x80"), bad + bad + bad);  // a surrogate
  EXPECT_EQ(clean_text("\xF0\x9F\x8F\xA0"), "\xF0\x9F\x8F\xA0");
  EXPECT_EQ(clean_text("\xF0\x9F\x8F"), bad + bad + bad);  // cut
  EXPECT_EQ(code_points("\xF0\x9F\x8F\xA0\xC3\xA9"), (std::vector<char32_t>{0x1F3E0, 0xE9}));
}

TEST(Drawing, NumbersAreNumbers) {
  EXPECT_EQ(decimal(-0.001, 2), "0.00");
  EXPECT_EQ(decimal(-0.01, 2), "-0.01");
  EXPECT_EQ(decimal(12, 0), "12");
  EXPECT_THROW(decimal(std::numeric_limits<double>::quiet_NaN(), 2), Error);
  EXPECT_THROW(decimal(std::numeric_limits<double>::infinity(), 2), Error);
}

TEST(Drawing, ExtentContainsArcs) {
  Drawing drawing;
  EXPECT_EQ(extent_of(drawing).width(), 0);
  drawing.lines.push_back({DrawingRole::opening, {{0, 0, 0}, {2, 0, 0}, {2, 3, 1}, {0, 3, 0}}, true});
  const FlatBox box = extent_of(drawing);
  EXPECT_EQ(box.min.y, 0);
  EXPECT_EQ(box.max.y, 4);  // the crown of the half circle
  EXPECT_EQ(box.max.x, 2);
}

TEST(Drawing, KeysOfLinesThatLieOnEachOther) {
  const std::vector<DrawingCorner> ring{{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<DrawingCorner> turned{{1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0.5}};
  const std::vector<DrawingCorner> back{{1, 1, -0.5}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(place_key(ring, true), place_key(turned, true));
  EXPECT_EQ(place_key(ring, true), place_key(back, true));
  EXPECT_NE(place_key(ring, false), place_key(turned, false));
  std::vector<DrawingCorner> straight = ring;
  straight[1].bulge = 0;
  EXPECT_NE(place_key(ring, true), place_key(straight, true));
  EXPECT_EQ(place_key({{0, 0, 0}, {1, 2, 0}}, false), place_key({{1, 2, 0}, {0, 0, 0}}, false));
  EXPECT_TRUE(place_key({}, true).empty());
}

}  // namespace
}  // namespace ilot
