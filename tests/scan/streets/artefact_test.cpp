// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/artefact.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace ilot::scan {
namespace {

constexpr std::array kClasses{ArtefactClass::car, ArtefactClass::lamppost, ArtefactClass::pedestrian,
                              ArtefactClass::other};

TEST(Artefact, EveryClassHasAtLeastFiveVariants) {
  for (ArtefactClass c : kClasses) {
    const auto variants = variants_of(c);
    EXPECT_GE(std::set<std::string_view>(variants.begin(), variants.end()).size(), 5u) << name_of(c);
  }
  EXPECT_EQ(variants_of(ArtefactClass::other).size(), 144u);
}

TEST(Artefact, StandsOnTheGroundAndHasTheSizeOfItsKind) {
  Rng rng(1);
  for (ArtefactClass c : kClasses)
    for (std::string_view variant : variants_of(c)) {
      const Artefact artefact = make_artefact(c, variant, rng);
      ASSERT_FALSE(artefact.solids.empty()) << variant;
      const Box3<Vec3> box = bounds_of(artefact);
      EXPECT_NEAR(box.min.z, 0, 0.03) << variant;
      const Vec3 size = box.max - box.min;
      if (c == ArtefactClass::car) {
        EXPECT_GT(size.x, 3.2);
        EXPECT_LT(size.x, 5.6);
        EXPECT_NEAR(size.y, 1.8, 0.25);
        EXPECT_LT(size.z, 2.2);
      }
      if (c == ArtefactClass::lamppost) {
        EXPECT_GT(size.z, 2.8);
        EXPECT_LT(size.z, 10.5);
      }
      if (c == ArtefactClass::pedestrian) {
        EXPECT_GT(size.z, 0.95);
        EXPECT_LT(size.z, 2.4);
        EXPECT_LT(size.x, 1.6);
        EXPECT_LT(size.y, 1.4);
      }
    }
}

TEST(Artefact, ParkingMetersAreAsTallAsPeople) {
  Rng rng(2);
  for (int i = 0; i < 20; ++i)
    for (const char* variant : {"parking_meter", "pay_station"}) {
      const Box3<Vec3> box = bounds_of(make_furniture(variant, rng));
      EXPECT_GT(box.max.z, 1.4);
      EXPECT_LT(box.max.z, 1.95);
      EXPECT_LT(box.max.y - box.min.y, 0.6);
    }
}

// A ray from above meets the highest part below it; one beside it meets nothing.
TEST(Artefact, ABoxAndATaperAreWhereTheyAreSaidToBe) {
  Artefact a;
  a.box({1, 0, 0.5}, {2, 1, 1}, Material::wood);
  a.taper({10, 0, 2}, 1, 0.5, 0.1, Material::iron);
  const Ray down{{1.5, 0.2, 5}, {0, 0, -1}};
  const auto hit = meet(down, a.solids[0], 0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 4, 1e-12);
  EXPECT_EQ(hit->surface, static_cast<SurfaceId>(Material::wood));
  EXPECT_FALSE(meet(Ray{{2.1, 0, 5}, {0, 0, -1}}, a.solids[0], 0));
  // Half way up the cone's radius is 0.3.
  EXPECT_NEAR(meet(Ray{{5, 0, 2.5}, {1, 0, 0}}, a.solids[1], 0)->t, 4.7, 1e-9);
  EXPECT_FALSE(meet(Ray{{5, 0, 3.01}, {1, 0, 0}}, a.solids[1], 0));
}

}  // namespace
}  // namespace ilot::scan
