// SPDX-License-Identifier: Apache-2.0
#include "engine/report/path_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ilot {
namespace {

TEST(PathText, OrdinaryPathsStay) {
  for (const char* path : {"", "/a/b c.laz", "gr\xC3\xBC\xC3\x9F.las", "\xE2\x82\xAC \xF0\x9F\x8F\x99.las", "a\nb\""})
    EXPECT_EQ(path_text(path), path);
}

TEST(PathText, OtherBytesAreEscaped) {
  EXPECT_EQ(path_text("caf\xE9.las"), "caf\\xE9.las");
  EXPECT_EQ(path_text("a\\b"), "a\\x5Cb");
  EXPECT_EQ(path_text("\xC0\x80\xED\xA0\x80"), "\\xC0\\x80\\xED\\xA0\\x80") << "overlong, and half of a pair";
  EXPECT_EQ(path_text("\xE2\x82"), "\\xE2\\x82") << "cut off";
}

TEST(PathText, EveryPathOfTwoBytesComesBackAndIsJson) {
  for (int a = 1; a < 256; ++a) {
    for (int b = 1; b < 256; ++b) {
      const std::string bytes{static_cast<char>(a), static_cast<char>(b)};
      const std::string text = path_text(bytes);
      EXPECT_EQ(path_of_text(text).string(), bytes);
      EXPECT_NO_THROW(nlohmann::json(text).dump());
    }
  }
}

TEST(PathText, WhatIsNoEscapeStays) {
  for (const char* text : {"\\", "\\x", "\\x4", "\\xg0", "\\y41", "x41"}) EXPECT_EQ(path_of_text(text), text);
}

}  // namespace
}  // namespace ilot
