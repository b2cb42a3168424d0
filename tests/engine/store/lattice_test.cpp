// SPDX-License-Identifier: Apache-2.0
#include "engine/store/lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr std::int64_t kEdge = std::int64_t{1} << kTileBits;
constexpr std::int64_t kFar = (std::int64_t{1} << 51) - 1;

RecordLayout layout(double scale, double offset) {
  RecordLayout l;
  l.scale = {scale, scale, scale};
  l.offset = {offset, offset, offset};
  return l;
}

TEST(Lattice, KeysByHand) {
  EXPECT_EQ(key_of({0, 0, 0}), (PointKey{{0, 0, 0}, 0}));
  EXPECT_EQ(key_of({1, 2, 4}), (PointKey{{0, 0, 0}, 0b100'010'001}));
  EXPECT_EQ(key_of({-1, 0, kEdge}).tile, (Tile{-1, 0, 1}));
  EXPECT_EQ(key_of({-1, -1, -1}).code, (std::uint64_t{1} << 63) - 1);
  EXPECT_EQ(corner({-1, 0, 2}), (Index3{-kEdge, 0, 2 * kEdge}));
}

TEST(Lattice, KeysComeBackEverywhere) {
  std::vector<std::int64_t> values{0, 1, -1, kFar, -kFar};
  for (const std::int64_t tile : {-3, -1, 0, 1, 4}) {
    for (const std::int64_t by : {-1, 0, 1}) values.push_back(tile * kEdge + by);
  }
  for (const std::int64_t x : values)
    for (const std::int64_t y : values)
      for (const std::int64_t z : values) {
        const PointKey key = key_of({x, y, z});
        ASSERT_EQ(index_of(key), (Index3{x, y, z}));
        ASSERT_TRUE((Node{key.tile, 0, 0}.box().contains({x, y, z})));
      }
}

TEST(Lattice, AShiftByWholeTilesKeepsTheCode) {
  Rng rng(1);
  for (int i = 0; i < 1000; ++i) {
    const auto draw = [&] { return static_cast<std::int64_t>(rng.below(1u << 30)) - (1 << 29); };
    const Index3 p{draw(), draw(), draw()};
    const PointKey a = key_of(p), b = key_of({p.x + 1000 * kEdge, p.y - 3 * kEdge, p.z});
    EXPECT_EQ(a.code, b.code);
    EXPECT_EQ(b.tile, (Tile{a.tile.x + 1000, a.tile.y - 3, a.tile.z}));
  }
}

TEST(Lattice, NodesContainWhatTheirBoxContains) {
  Rng rng(2);
  for (int level = 0; level <= kTileBits; ++level) {
    const Index3 p{-5 - static_cast<std::int64_t>(rng.below(1u << 21)), static_cast<std::int64_t>(rng.below(1u << 21)),
                   77};
    const PointKey key = key_of(p);
    const Node node = Node{key.tile, kTileBits, key.code}.ancestor(level);
    EXPECT_TRUE(node.box().contains(p));
    EXPECT_EQ(node.box().max.x - node.box().min.x + 1, node.edge());
    EXPECT_LE(node.first_code, key.code);
    EXPECT_GE(node.last_code(), key.code);
    EXPECT_EQ(index_of({node.tile, node.last_code()}), node.box().max);
    if (level == kTileBits) continue;
    std::uint64_t next = node.first_code;
    for (int octant = 0; octant < 8; ++octant) {
      const Node child = node.child(octant);
      EXPECT_EQ(child.first_code, next);
      next = child.last_code() + 1;
      EXPECT_TRUE(node.contains(child));
      EXPECT_FALSE(child.contains(node));
      EXPECT_EQ(child.ancestor(level), node);
      EXPECT_TRUE(node.box().contains(child.box().min) && node.box().contains(child.box().max));
      if (octant > 0) {
        EXPECT_TRUE(before(node.child(octant - 1), child));
      }
    }
    EXPECT_EQ(next, node.last_code() + 1);
  }
}

TEST(Lattice, NamesOfNodesDiffer) {
  std::set<std::string> names;
  for (const int x : {-2147483647, -1, 0, 1, 11})
    for (const int y : {-1, 0, 1})
      for (int level = 0; level < 22; ++level) names.insert(Node{{x, y, 0}, level, 0}.name());
  names.insert(Node{{0, 0, 0}, 21, 0xffffffffffffffffull}.name());
  EXPECT_EQ(names.size(), 5u * 3 * 22 + 1);
  for (const std::string& n : names) EXPECT_EQ(n.find_first_of("/ ."), std::string::npos);
}

TEST(LatticeMap, IsExactForMultiplesOfTheUnitOnNationalGrids) {
  // Lambert 93 and UTM eastings and northings at a millimetre, the file at a centimetre.
  const LatticeMap map(layout(0.01, 6543210.12), 0.001);
  EXPECT_TRUE(map.exact());
  Rng rng(3);
  for (int i = 0; i < 10000; ++i) {
    const auto raw = static_cast<std::int32_t>(rng.next());
    Index3 at;
    ASSERT_TRUE(map.map(raw, raw, 0, at));
    ASSERT_EQ(at, (Index3{std::int64_t{raw} * 10 + 6543210120, std::int64_t{raw} * 10 + 6543210120, 6543210120}));
  }
}

TEST(LatticeMap, RoundsWhatIsOffTheLattice) {
  const LatticeMap map(layout(0.0007, 0.0001), 0.001);
  EXPECT_FALSE(map.exact());
  Index3 at;
  for (const std::int32_t raw : {-1000000, -7, 0, 1, 2, 3, 999999, INT32_MAX, INT32_MIN}) {
    ASSERT_TRUE(map.map(raw, raw, raw, at));
    EXPECT_EQ(at.x, std::llround((raw * 0.0007L + 0.0001L) / 0.001L)) << raw;
  }
  EXPECT_FALSE(LatticeMap(layout(0.001, 0.0005), 0.001).exact());
  EXPECT_FALSE(LatticeMap(layout(0.0001, 0), 0.001).exact());
}

// "Exact" must hold for every raw value: a scale that is nearly a multiple is off by units far from the offset.
TEST(LatticeMap, ANearMultipleIsNoMultiple) {
  const double scale = 0.001 * (1 + 8e-10);
  Index3 at;
  ASSERT_TRUE(LatticeMap(layout(scale, 0), 0.001).map(INT32_MAX, INT32_MAX, INT32_MAX, at));
  EXPECT_EQ(at.x, std::llround(static_cast<long double>(scale) * INT32_MAX / 0.001L));
}

TEST(LatticeMap, RefusesWhatIsTooFarOut) {
  Index3 at;
  for (const double offset : {0x1p50, 0x1p51 - 1, 0x1p52, 1e300, -1e300, HUGE_VAL, std::nan("")}) {
    for (const double scale : {1.0, 1024.0, 524288.0, 0.3, 1e200, 1e-300}) {
      const LatticeMap map(layout(scale, offset), 1);
      for (const std::int32_t raw : {0, 1, INT32_MAX, INT32_MIN}) {
        const bool near = std::abs(raw * scale + offset) < 0x1p51;
        ASSERT_EQ(map.map(raw, raw, raw, at), near) << offset << " " << scale << " " << raw;
        if (near) {
          ASSERT_EQ(index_of(key_of(at)), at);
        }
      }
    }
  }
}

}  // namespace
}  // namespace ilot
