// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/outline_repair.h"

#include <geos_c.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

const std::vector<Point2> kSquare{{0, 0}, {10000, 0}, {10000, 10000}, {0, 10000}};

// Oracle: GEOS's own judgement of what came out.
bool is_valid(const SitePolygon& polygon) {
  GEOSContextHandle_t geos = GEOS_init_r();
  const auto ring_of = [&](const std::vector<Point2>& ring) {
    GEOSCoordSequence* s = GEOSCoordSeq_create_r(geos, static_cast<unsigned>(ring.size() + 1), 2);
    for (unsigned i = 0; i <= ring.size(); ++i)
      GEOSCoordSeq_setXY_r(geos, s, i, ring[i % ring.size()].x, ring[i % ring.size()].y);
    return GEOSGeom_createLinearRing_r(geos, s);
  };
  std::vector<GEOSGeometry*> holes;
  for (std::size_t i = 1; i < polygon.size(); ++i) holes.push_back(ring_of(polygon[i]));
  GEOSGeometry* g =
      GEOSGeom_createPolygon_r(geos, ring_of(polygon[0]), holes.data(), static_cast<unsigned>(holes.size()));
  const bool valid = GEOSisValid_r(geos, g) == 1;
  GEOSGeom_destroy_r(geos, g);
  GEOS_finish_r(geos);
  return valid;
}

TEST(OutlineRepair, AValidOutlineKeepsItsVertices) {
  const SitePolygon given{{kSquare}, {{4000, 4000}, {4000, 6000}, {6000, 6000}, {6000, 4000}}};
  const RepairedOutline repaired = repair_outline(given, 0.01);
  ASSERT_EQ(repaired.polygons.size(), 1u);
  EXPECT_EQ(repaired.polygons[0], given);
  EXPECT_EQ(repaired.repair, "");
  EXPECT_DOUBLE_EQ(area_of(repaired.polygons[0]), 96);
}

TEST(OutlineRepair, RingsAreTurnedAndStartAtTheirSmallestVertex) {
  const SitePolygon given{{{10000, 10000}, {10000, 0}, {0, 0}, {0, 10000}},
                          {{6000, 4000}, {6000, 6000}, {4000, 6000}, {4000, 4000}}};
  const RepairedOutline repaired = repair_outline(given, 0.01);
  ASSERT_EQ(repaired.polygons.size(), 1u);
  EXPECT_EQ(repaired.polygons[0][0], kSquare);
  EXPECT_EQ(repaired.polygons[0][1], (std::vector<Point2>{{4000, 4000}, {4000, 6000}, {6000, 6000}, {6000, 4000}}));
}

TEST(OutlineRepair, ABowTieBecomesTwoParts) {
  const RepairedOutline repaired = repair_outline({{{0, 0}, {10000, 10000}, {10000, 0}, {0, 8000}}}, 0.01);
  ASSERT_EQ(repaired.polygons.size(), 2u);
  EXPECT_NE(repaired.repair, "");
  EXPECT_GE(area_of(repaired.polygons[0]), area_of(repaired.polygons[1])) << "the largest first";
  for (const SitePolygon& p : repaired.polygons) EXPECT_TRUE(is_valid(p));
}

TEST(OutlineRepair, NothingIsLeftOfWhatHasNoArea) {
  for (const SitePolygon& given :
       {SitePolygon{}, SitePolygon{{}}, SitePolygon{{{0, 0}}}, SitePolygon{{{0, 0}, {9, 9}}},
        SitePolygon{{{0, 0}, {9000, 0}, {5000, 0}}}, SitePolygon{{{0, 0}, {0, 0}, {0, 0}, {7, 0}}},
        SitePolygon{{{0, 0}, {50, 0}, {50, 50}, {0, 50}}}}) {
    const RepairedOutline repaired = repair_outline(given, 0.01);
    EXPECT_TRUE(repaired.polygons.empty());
    EXPECT_NE(repaired.repair, "") << "a reason";
  }
}

TEST(OutlineRepair, RepeatedVerticesAreOne) {
  std::vector<Point2> ring;
  for (const Point2 p : kSquare) ring.insert(ring.end(), 3, p);
  ring.push_back(kSquare[0]);
  const RepairedOutline repaired = repair_outline({ring}, 0.01);
  ASSERT_EQ(repaired.polygons.size(), 1u);
  EXPECT_EQ(repaired.polygons[0][0], kSquare);
}

TEST(OutlineRepair, VerticesOfAMillimetreAreOneTheSameForBothNeighbours) {
  const std::vector<Point2> ring{{0, 0}, {10000, 0}, {10000, 5000}, {10000, 5001}, {10000, 10000}, {0, 10000}, {0, 1}};
  const std::vector<Point2> whole{{0, 0}, {10000, 0}, {10000, 5000}, {10000, 10000}, {0, 10000}};
  for (std::size_t start = 0; start < ring.size(); ++start) {
    std::vector<Point2> turned = ring;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
    EXPECT_EQ(repair_outline({turned}, 0.01).polygons.at(0)[0], whole) << start;
    std::reverse(turned.begin(), turned.end());
    EXPECT_EQ(repair_outline({turned}, 0.01).polygons.at(0)[0], whole) << start;
  }
}

TEST(OutlineRepair, AnyScribbleComesOutValidOrWithAReason) {
  Rng rng(4);
  for (int i = 0; i < 300; ++i) {
    SitePolygon given(1 + rng.below(3));
    for (auto& ring : given)
      for (std::uint64_t n = 3 + rng.below(9); n > 0; --n)
        ring.push_back({static_cast<std::int32_t>(rng.below(3000)), static_cast<std::int32_t>(rng.below(3000))});
    const RepairedOutline repaired = repair_outline(given, 0.01);
    EXPECT_TRUE(!repaired.polygons.empty() || !repaired.repair.empty());
    for (const SitePolygon& p : repaired.polygons) {
      EXPECT_TRUE(is_valid(p)) << "scribble " << i;
      EXPECT_GE(area_of(p), 0.01);
      for (const auto& ring : p)
        for (std::size_t v = 0; v < ring.size(); ++v) EXPECT_NE(ring[v], ring[(v + 1) % ring.size()]);
    }
  }
}

TEST(OutlineRepair, SharedAreaIsThatOfTheIntersection) {
  const SitePolygon square{kSquare}, beside{{{10000, 0}, {20000, 0}, {20000, 10000}, {10000, 10000}}},
      across{{{5000, 5000}, {15000, 5000}, {15000, 15000}, {5000, 15000}}};
  EXPECT_DOUBLE_EQ(shared_area(square, beside), 0) << "a common wall";
  EXPECT_DOUBLE_EQ(shared_area(square, across), 25);
  EXPECT_DOUBLE_EQ(shared_area(square, square), 100);
}

}  // namespace
}  // namespace ilot
