// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/boundaries/boundaries_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "engine/products/planes/boundaries/boundary_edges.h"
#include "engine/products/planes/join/label_pass.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/plane_frame.h"
#include "kernels/delaunay/rings.h"
#include "kernels/delaunay/sampling_step.h"
#include "kernels/delaunay/thinning.h"
#include "tests/support/plane_store.h"

namespace ilot {
namespace {

using test::PlaneStore;

// A leaning roof with two openings over the corner where eight tiles meet, and a wall beside it; a raster without noise
// where `step` divides everything.
std::vector<Index3> house(std::int64_t size, bool raster) {
  std::vector<Index3> points, kept;
  const std::int64_t h = size / 2, step = 60;
  if (raster) {
    for (std::int64_t x = -h; x < h; x += step)
      for (std::int64_t y = -h; y < h; y += step) points.push_back({x, y, x / 2});
  } else {
    test::add_surface(points, {-h, -h, 0}, {size, size, 0}, step, 4, [](double x, double) { return 0.5 * x; });
  }
  for (const Index3 p : points) {
    const bool window = std::abs(p.x) < h / 4 && std::abs(p.y) < h / 3;
    const bool chimney =
        std::hypot(static_cast<double>(p.x - h / 2), static_cast<double>(p.y + h / 2)) < static_cast<double>(h) / 8;
    if (!window && !chimney) kept.push_back(p);
  }
  for (std::int64_t x = -h; x < h; x += step)
    for (std::int64_t z = -h / 2; z < h; z += step) kept.push_back({x, h + 3 * step, 2 * h + z});
  return kept;
}

struct BoundariesResult {
  std::vector<Outline> outlines;
  std::vector<Index3> where;
  std::vector<std::uint8_t> boundary;
};

std::vector<std::uint32_t> every_id(std::size_t planes) {
  std::vector<std::uint32_t> id(planes + 1);
  for (std::uint32_t i = 0; i < id.size(); ++i) id[i] = i;
  return id;
}

using Change = std::function<void(BoundaryParams&)>;

BoundariesResult boundaries(const PlaneStore& s, double tolerance, const Change& change = {}) {
  label_pass(s.cloud.store(), s.cells, s.found, s.joined, {});
  const auto ranges = neighbour_ranges(s.cloud.store(), s.cells, s.found);
  const auto id = every_id(s.joined.planes.size());
  BoundariesResult r;
  BoundaryParams params{1, tolerance, s.joined.planes, id, ranges};
  if (change) change(params);
  boundaries_pass(s.cloud.store(), params, {}, [&](const Outline& o) { r.outlines.push_back(o); });
  r.where = test::positions(s.cloud.store());
  r.boundary = test::whole_column(s.cloud.store(), columns::kBoundary);
  return r;
}

void expect_equal(const Outline& a, const Outline& b) {
  EXPECT_EQ(a.plane_id, b.plane_id);
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t p = 0; p < a.parts.size(); ++p) {
    ASSERT_EQ(a.parts[p].size(), b.parts[p].size());
    for (std::size_t r = 0; r < a.parts[p].size(); ++r) {
      ASSERT_EQ(a.parts[p][r].size(), b.parts[p][r].size());
      for (std::size_t i = 0; i < a.parts[p][r].size(); ++i) {
        const Vec3 u = a.parts[p][r][i], v = b.parts[p][r][i];
        EXPECT_TRUE(u.x == v.x && u.y == v.y && u.z == v.z);
      }
    }
  }
}

// The boundary by one triangulation of all of a plane's points.
Outline outline_at_once(const PlaneStore& s, std::uint32_t id, double tolerance) {
  const Store& store = s.cloud.store();
  const auto where = test::positions(store);
  const auto plane = test::whole_column(store, columns::kPlane);
  std::vector<std::int64_t> farthest;  // all blocks' points one after the other
  for (const auto& block : neighbour_ranges(store, s.cells, s.found))
    for (const NeighbourRange& r : block) farthest.insert(farthest.end(), r.count, r.farthest * 4);
  const JoinedPlane& joined = s.joined.planes[id - 1];
  const PlaneFrame frame = frame_of(joined.plane, {});
  std::vector<Point2> places;
  std::vector<std::int64_t> limit;
  for (std::size_t i = 0; i < where.size(); ++i) {
    if (plane[i] != id) continue;
    places.push_back(project(
        frame, {static_cast<double>(where[i].x - joined.anchor.x), static_cast<double>(where[i].y - joined.anchor.y),
                static_cast<double>(where[i].z - joined.anchor.z)}));
    limit.push_back(farthest[i]);
  }
  std::vector<float> alpha;
  const MeasuredSteps steps = measured_steps(places, 6, *std::max_element(limit.begin(), limit.end()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::int64_t most = limit[i] * limit[i];
    const std::int64_t d2 = steps.reach2[i] < 0 ? most : std::min(most, steps.reach2[i]);
    alpha.push_back(static_cast<float>(raster_step(static_cast<double>(d2), 6)));
  }
  const Triangulation t = delaunay(places);
  const auto keep = shape_triangles(t, places, {TriangleRule::kCircumradius, alpha});
  const Polygons rings = thin_rings(assemble_rings(boundary_edges(t, keep), places), places, tolerance * kPlaneSteps);
  Outline out{id, std::vector<Outline::Part>(rings.count)};
  for (const Ring& ring : rings.rings) {
    auto& points = out.parts[ring.polygon].emplace_back();
    for (std::uint32_t i = 0; i < ring.count; ++i) {
      const Vec3 p = position(frame, places[rings.vertices[ring.first + i]]);
      points.push_back({(static_cast<double>(joined.anchor.x) + p.x) * test::kUnit,
                        (static_cast<double>(joined.anchor.y) + p.y) * test::kUnit,
                        (static_cast<double>(joined.anchor.z) + p.z) * test::kUnit});
    }
  }
  return out;
}

TEST(BoundariesPass, BlocksOfAnySizeEqualOneTriangulationOfEachPlane) {
  for (const bool raster : {false, true}) {
    const auto points = house(6000, raster);
    const PlaneStore whole(points);
    ASSERT_GE(whole.joined.planes.size(), 2u);
    const BoundariesResult expected = boundaries(whole, 5);
    ASSERT_EQ(expected.outlines.size(), whole.joined.planes.size());
    for (std::uint32_t id = 1; id <= expected.outlines.size(); ++id) {
      SCOPED_TRACE("plane " + std::to_string(id));
      expect_equal(expected.outlines[id - 1], outline_at_once(whole, id, 5));
    }
    for (const std::uint64_t block_points : {300u, 2000u}) {
      SCOPED_TRACE("blocks of " + std::to_string(block_points));
      const PlaneStore cut(points, {block_points, 1u << 20, 1});
      EXPECT_GT(cut.cloud.store().blocks().size(), 5u);
      const BoundariesResult r = boundaries(cut, 5);
      ASSERT_EQ(r.outlines.size(), expected.outlines.size());
      for (std::size_t i = 0; i < r.outlines.size(); ++i) expect_equal(r.outlines[i], expected.outlines[i]);
      EXPECT_EQ(r.where, expected.where);
      EXPECT_EQ(r.boundary, expected.boundary);
    }
  }
}

std::size_t rings_of(const BoundariesResult& r) {
  std::size_t rings = 0;
  for (const Outline& o : r.outlines)
    for (const auto& part : o.parts) rings += part.size();
  return rings;
}

// Every way to choose thresholds and triangles, cut into blocks and not.
TEST(BoundariesPass, NoChoiceShowsTheBlocks) {
  const Scanner station{{-2000, -9000, 1500}, {0, 0, 1}, 0.012, 0.012};
  const std::vector<std::pair<const char*, Change>> choices{
      {"stations", [&](BoundaryParams& p) { p.stations = std::span(&station, 1); }},
      {"threshold", [](BoundaryParams& p) { p.threshold = 110; }},
      {"longest edge",
       [](BoundaryParams& p) {
         p.rule = TriangleRule::kLongestEdge;
         p.gamma = 2;
       }},
      {"longest edge in space",
       [](BoundaryParams& p) {
         p.rule = TriangleRule::kLongestEdge;
         p.edge_length = EdgeLength::space;
         p.threshold = 130;
       }},
      {"outside", [](BoundaryParams& p) { p.erosion = Erosion::outside; }}};
  const auto points = house(6000, false);
  const BoundariesResult plain = boundaries(PlaneStore(points), 5);
  for (const auto& [name, change] : choices) {
    SCOPED_TRACE(name);
    const BoundariesResult a = boundaries(PlaneStore(points), 5, change);
    const BoundariesResult b = boundaries(PlaneStore(points, {1000, 1u << 20, 1}), 5, change);
    ASSERT_EQ(a.outlines.size(), b.outlines.size());
    for (std::size_t i = 0; i < a.outlines.size(); ++i) expect_equal(a.outlines[i], b.outlines[i]);
    EXPECT_EQ(a.boundary, b.boundary);
    EXPECT_NE(a.boundary, plain.boundary);
    EXPECT_GT(rings_of(a), 0u);
  }
}

TEST(BoundariesPass, ErodedFromOutsideThereAreNoHoles) {
  const PlaneStore s(house(6000, false));
  const BoundariesResult r = boundaries(s, 5, [](BoundaryParams& p) { p.erosion = Erosion::outside; });
  for (const Outline& o : r.outlines) {
    EXPECT_EQ(o.parts.size(), 1u);
    for (const auto& part : o.parts) EXPECT_EQ(part.size(), 1u);
  }
}

TEST(BoundariesPass, ARoofWithTwoOpeningsIsOnePolygonWithTwoHoles) {
  const PlaneStore s(house(6000, false));
  const BoundariesResult r = boundaries(s, 5);
  const std::size_t roof = std::abs(s.joined.planes[0].plane.n.z) > 0.5 ? 0 : 1;
  ASSERT_EQ(r.outlines[roof].parts.size(), 1u);
  EXPECT_EQ(r.outlines[roof].parts[0].size(), 3u);
  const JoinedPlane& plane = s.joined.planes[roof];
  double area = 0;
  for (const auto& ring : r.outlines[roof].parts[0])
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 p = ring[i], q = ring[(i + 1) % ring.size()];
      area += (p.x * q.y - q.x * p.y) / 2;
      const Vec3 offset{p.x / test::kUnit - static_cast<double>(plane.anchor.x),
                        p.y / test::kUnit - static_cast<double>(plane.anchor.y),
                        p.z / test::kUnit - static_cast<double>(plane.anchor.z)};
      EXPECT_NEAR(signed_distance(plane.plane, offset), 0, 1e-6);
    }
  // Rings lie inside of the true edges by up to a step of 60 mm: 24 m around the roof, 7 and 2.4 around the openings.
  const double truth = 36 - 1.5 * 2 - M_PI * 0.375 * 0.375;
  EXPECT_NEAR(area, truth, 0.06 * (24 + 7 + 2.4));
}

TEST(BoundariesPass, PointsAtOnePlaceShareTheirFlag) {
  auto points = house(3000, true);
  const std::size_t n = points.size();
  points.insert(points.end(), points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n));
  const PlaneStore s(points, {500, 1u << 20, 1});
  const BoundariesResult r = boundaries(s, 0);
  const auto plane = test::whole_column(s.cloud.store(), columns::kPlane);
  std::size_t flagged = 0;
  for (std::size_t i = 1; i < r.where.size(); ++i) {
    if (r.where[i] == r.where[i - 1] && plane[i] == plane[i - 1]) {
      EXPECT_EQ(r.boundary[i], r.boundary[i - 1]);
      flagged += r.boundary[i];
    }
  }
  EXPECT_GT(flagged, 100u);
}

// Noise puts the points of a plane at z = 0 on both sides of a border of tiles, one by one.
TEST(BoundariesPass, APlaneAlongABorderOfCellsIsNotTorn) {
  std::vector<Index3> points;
  test::add_surface(points, {0, 0, 0}, {6000, 6000, 0}, 60, 4, [](double, double) { return 0.0; });
  const PlaneStore s(points);
  ASSERT_EQ(s.joined.planes.size(), 1u);
  ASSERT_GE(s.cloud.store().blocks().size(), 2u);
  const BoundariesResult r = boundaries(s, 0);
  expect_equal(r.outlines[0], outline_at_once(s, 1, 0));
  std::size_t edges = 0, around = 0;
  for (std::uint32_t b = 0; b < s.cloud.store().blocks().size(); ++b)
    edges += read_column<SeamEdge>(s.cloud.store().path(b, columns::kSeamEdges)).size();
  for (const std::uint8_t flag : r.boundary) around += flag;
  EXPECT_LT(edges, around + around / 10) << "edges inside would be given by both sides";
}

// More points in a block than are looked at together.
TEST(BoundariesPass, StretchesOfABlockLeaveNoSeam) {
  const auto points = house(18000, false);
  const PlaneStore s(points);
  ASSERT_GT(points.size(), 80000u);
  const BoundariesResult r = boundaries(s, 0);
  for (std::uint32_t id = 1; id <= r.outlines.size(); ++id) expect_equal(r.outlines[id - 1], outline_at_once(s, id, 0));
}

}  // namespace
}  // namespace ilot
