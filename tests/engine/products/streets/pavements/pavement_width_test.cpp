// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/pavements/pavement_width.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ilot {
namespace {

using Pixel = PavementPixel;

// Five metres of kerb, of which the middle one is measured, and six metres of ground; pixels of 10 cm.
PavementStrip ground_strip() {
  PavementStrip strip;
  strip.step = 0.1;
  strip.rows = 50, strip.columns = 60, strip.first = 20, strip.last = 30;
  strip.pixels.assign(50 * 60, Pixel::ground);
  strip.heights.assign(50 * 60, 30);
  return strip;
}

void put(PavementStrip& strip, Pixel pixel, std::uint32_t from_row, std::uint32_t to_row, std::uint32_t from_column,
         std::uint32_t to_column) {
  for (std::uint32_t r = from_row; r < to_row; ++r)
    for (std::uint32_t c = from_column; c < to_column; ++c) strip.pixels[strip.at(r, c)] = pixel;
}

TEST(PavementWidth, GroundWithoutAnEndIsOpen) {
  const StripWidth w = pavement_width(ground_strip());
  EXPECT_EQ(w.end, PavementEnd::open);
  EXPECT_NEAR(w.width, 6, 1e-9);
  EXPECT_NEAR(w.passable, 6, 1e-9);
  EXPECT_EQ(w.unseen_share, 0);
}

TEST(PavementWidth, OpenGroundEndsWhereNothingIsSeen) {
  PavementStrip strip = ground_strip();
  put(strip, Pixel::unseen, 0, 50, 24, 60);
  const StripWidth w = pavement_width(strip);
  EXPECT_EQ(w.end, PavementEnd::open);
  EXPECT_NEAR(w.width, 2.4, 1e-9);
}

TEST(PavementWidth, AWallWithADoorInIt) {
  PavementStrip strip = ground_strip();
  put(strip, Pixel::unseen, 0, 50, 32, 60);
  put(strip, Pixel::wall, 0, 50, 31, 32);
  put(strip, Pixel::ground, 24, 28, 31, 33), put(strip, Pixel::wall, 24, 28, 33, 34);
  put(strip, Pixel::unseen, 0, 50, 5, 15);  // behind a parked car
  const StripWidth w = pavement_width(strip);
  EXPECT_EQ(w.end, PavementEnd::wall);
  EXPECT_NEAR(w.width, 3.15, 1e-9);
  EXPECT_NEAR(w.passable, 3.15, 1e-9);
  EXPECT_NEAR(w.unseen_share, 0.3, 0.05);
}

TEST(PavementWidth, AWallOfWhichFewRowsAreSeen) {
  PavementStrip strip = ground_strip();
  put(strip, Pixel::unseen, 0, 50, 31, 60);
  for (const std::uint32_t r : {21u, 24u, 27u}) put(strip, Pixel::wall, r, r + 1, 31, 32);
  EXPECT_EQ(pavement_width(strip).end, PavementEnd::wall);
  // Where rows go on behind it, it is a post.
  for (std::uint32_t r = 20; r < 30; ++r)
    if (r % 3 != 0) put(strip, Pixel::ground, r, r + 1, 32, 60);
  EXPECT_EQ(pavement_width(strip).end, PavementEnd::open);
}

TEST(PavementWidth, ObjectsLeaveTheWidestPart) {
  PavementStrip strip = ground_strip();
  put(strip, Pixel::wall, 0, 50, 40, 41);
  put(strip, Pixel::object, 22, 24, 8, 10);   // a bollard
  put(strip, Pixel::loose, 20, 26, 30, 34);   // a bicycle
  put(strip, Pixel::object, 10, 18, 15, 20);  // beside the metre that is measured
  const StripWidth w = pavement_width(strip);
  EXPECT_EQ(w.end, PavementEnd::wall);
  EXPECT_NEAR(w.width, 4.05, 1e-9);
  EXPECT_NEAR(w.passable, 2.1, 1e-9);
  EXPECT_NEAR(w.passable_from, 0.95, 1e-9);
}

TEST(PavementWidth, ARowOfObjectsIsABarrierAndAShortOneIsNot) {
  PavementStrip strip = ground_strip();
  put(strip, Pixel::object, 10, 40, 25, 31);
  const StripWidth w = pavement_width(strip);
  EXPECT_EQ(w.end, PavementEnd::barrier);
  EXPECT_NEAR(w.width, 2.55, 1e-9);
  put(strip, Pixel::ground, 10, 19, 25, 31);  // two metres are left, as of a bench
  EXPECT_EQ(pavement_width(strip).end, PavementEnd::open);
  put(strip, Pixel::loose, 0, 50, 25, 31);  // a lorry
  EXPECT_EQ(pavement_width(strip).end, PavementEnd::open);
}

TEST(PavementWidth, AFenceEndsItAndARailingAtTheKerbDoesNot) {
  PavementStrip strip = ground_strip();
  put(strip, Pixel::fence, 0, 50, 5, 6);
  EXPECT_EQ(pavement_width(strip).end, PavementEnd::open);
  put(strip, Pixel::unseen, 0, 50, 21, 60), put(strip, Pixel::fence, 0, 50, 20, 21);
  const StripWidth w = pavement_width(strip);
  EXPECT_EQ(w.end, PavementEnd::barrier);
  EXPECT_NEAR(w.width, 2.05, 1e-9);
  EXPECT_NEAR(w.passable, 1.5, 1e-9);
}

TEST(PavementWidth, AStepOfTheGroundAndTheNextKerb) {
  PavementStrip strip = ground_strip();
  for (std::uint32_t r = 0; r < strip.rows; ++r)
    for (std::uint32_t c = 0; c < strip.columns; ++c)
      strip.heights[strip.at(r, c)] = 30 + 0.006 * c + (c < 28 ? 0 : 0.3);
  const StripWidth w = pavement_width(strip);
  EXPECT_EQ(w.end, PavementEnd::step);
  EXPECT_NEAR(w.width, 2.8, 0.11);
  PavementWidthParams params;
  params.next_kerb = 1.8;
  EXPECT_NEAR(pavement_width(strip, params).width, 1.8, 1e-9);
}

// Turned strips: the same ground from its other end of the kerb gives the same answer.
TEST(PavementWidth, MirroredStripsHaveTheSameWidth) {
  PavementStrip strip = ground_strip();
  put(strip, Pixel::wall, 0, 50, 40, 41);
  put(strip, Pixel::object, 21, 24, 8, 10), put(strip, Pixel::unseen, 26, 30, 0, 20);
  PavementStrip mirrored = strip;
  for (std::uint32_t r = 0; r < strip.rows; ++r)
    std::copy_n(strip.pixels.begin() + strip.at(r, 0), strip.columns,
                mirrored.pixels.begin() + mirrored.at(strip.rows - 1 - r, 0));
  const StripWidth a = pavement_width(strip), b = pavement_width(mirrored);
  EXPECT_EQ(a.end, b.end);
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.passable, b.passable);
  EXPECT_EQ(a.unseen_share, b.unseen_share);
}

}  // namespace
}  // namespace ilot
