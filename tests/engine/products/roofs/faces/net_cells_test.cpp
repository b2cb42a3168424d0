// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/net_cells.h"

#include <geos_c.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "engine/geos_context.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Segments = std::vector<NetSegment>;

void add_square(std::int32_t low, std::int32_t high, Segments& segments) {
  const Point2 corners[4]{{low, low}, {high, low}, {high, high}, {low, high}};
  for (int i = 0; i < 4; ++i) segments.push_back({corners[i], corners[(i + 1) % 4], true});
}

std::vector<double> areas_of(const Partition& p) {  // of the regions, ascending, square metres
  std::vector<double> areas = region_areas(p);
  areas.erase(areas.begin());
  std::sort(areas.begin(), areas.end());
  return areas;
}

// The same by GEOS: union on a grid of 1, polygonize, cells whose inner points lie in the square.
std::vector<double> areas_by_geos(const Segments& segments, std::int32_t low, std::int32_t high) {
  GEOSContextHandle_t geos = geos_context();
  std::vector<GEOSGeometry*> lines;
  for (const NetSegment& s : segments) {
    GEOSCoordSequence* ends = GEOSCoordSeq_create_r(geos, 2, 2);
    GEOSCoordSeq_setXY_r(geos, ends, 0, s.a.x, s.a.y);
    GEOSCoordSeq_setXY_r(geos, ends, 1, s.b.x, s.b.y);
    lines.push_back(GEOSGeom_createLineString_r(geos, ends));
  }
  const GeosOwned all(
      GEOSGeom_createCollection_r(geos, GEOS_MULTILINESTRING, lines.data(), static_cast<unsigned>(lines.size())));
  const GeosOwned net(GEOSUnaryUnionPrec_r(geos, all.get(), 1));
  const GEOSGeometry* nets[1]{net.get()};
  const GeosOwned polygons(GEOSPolygonize_r(geos, nets, 1));
  std::vector<double> areas;
  for (int i = 0; i < GEOSGetNumGeometries_r(geos, polygons.get()); ++i) {
    const GEOSGeometry* polygon = GEOSGetGeometryN_r(geos, polygons.get(), i);
    const GeosOwned inner(GEOSPointOnSurface_r(geos, polygon));
    double x = 0, y = 0, area = 0;
    GEOSGeomGetX_r(geos, inner.get(), &x);
    GEOSGeomGetY_r(geos, inner.get(), &y);
    GEOSArea_r(geos, polygon, &area);
    if (x > low && x < high && y > low && y < high) areas.push_back(area * 1e-6);
  }
  std::sort(areas.begin(), areas.end());
  return areas;
}

TEST(NetCells, ASquareIsOneAndSquaresWithinTakeTurns) {
  Segments segments;
  add_square(0, 10000, segments);
  EXPECT_EQ(areas_of(cells_inside(snap_rounded(segments))), (std::vector<double>{100}));
  add_square(2000, 8000, segments);  // a courtyard
  EXPECT_EQ(areas_of(cells_inside(snap_rounded(segments))), (std::vector<double>{64}));
  add_square(4000, 6000, segments);  // a house in it
  EXPECT_EQ(areas_of(cells_inside(snap_rounded(segments))), (std::vector<double>{4, 64}));
}

TEST(NetCells, LinesThatReachNothingPartNothing) {
  Segments segments;
  add_square(0, 10000, segments);
  add_square(4000, 6000, segments);
  segments.push_back({{-500, 5000}, {4500, 5000}, false});  // from outside over the first side, then the hole's
  segments.push_back({{1000, 1000}, {2000, 2000}, false});  // afloat
  const Partition p = cells_inside(snap_rounded(segments));
  EXPECT_EQ(areas_of(p), (std::vector<double>{96}));
  for (const PartitionEdge& e : p.edges) EXPECT_NE(e.left, e.right);
}

TEST(NetCells, IslandsOfLinesLieInTheFaceAroundThem) {
  Segments segments;
  add_square(0, 10000, segments);
  segments.push_back({{2000, 2000}, {4000, 2000}, false});
  segments.push_back({{4000, 2000}, {3000, 4000}, false});
  segments.push_back({{3000, 4000}, {2000, 2000}, false});
  segments.push_back({{3000, 2500}, {3000, 3000}, false});  // afloat in the triangle
  EXPECT_EQ(areas_of(cells_inside(snap_rounded(segments))), (std::vector<double>{2, 98}));
}

TEST(NetCells, AgreesWithGeosOnLinesOfAllKinds) {
  Rng rng(17);
  for (int round = 0; round < 150; ++round) {
    Segments segments;
    add_square(0, 10000, segments);
    for (std::uint64_t i = rng.below(30); i-- > 0;) {
      const std::uint64_t grid = rng.below(2) == 0 ? 1 : 500;  // along each other and through corners, or anywhere
      const auto at = [&] { return static_cast<std::int32_t>(rng.below(14000 / grid) * grid) - 2000; };
      segments.push_back({{at(), at()}, {at(), at()}, false});
    }
    const std::vector<double> ours = areas_of(cells_inside(snap_rounded(segments)));
    const std::vector<double> theirs = areas_by_geos(segments, 0, 10000);
    ASSERT_NEAR(std::accumulate(ours.begin(), ours.end(), 0.0), 100, 0.1);
    // GEOS rounds crossings found in floating point, so cells of a few square millimetres come and go.
    const auto large = [](const std::vector<double>& areas) {
      return std::count_if(areas.begin(), areas.end(), [](double a) { return a > 1e-4; });
    };
    ASSERT_EQ(large(ours), large(theirs)) << "round " << round;
    for (auto a = ours.rbegin(), b = theirs.rbegin(); a != ours.rbegin() + large(ours); ++a, ++b)
      ASSERT_NEAR(*a, *b, 0.03) << "round " << round;
  }
}

}  // namespace
}  // namespace ilot
