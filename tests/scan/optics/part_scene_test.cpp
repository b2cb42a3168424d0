// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/part_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/core/rng.h"

namespace ilot::scan {
namespace {

Vec3 place_about(Rng& rng, Vec3 about, double reach) {
  return about +
         Vec3{reach * (2 * rng.uniform() - 1), reach * (2 * rng.uniform() - 1), reach * (2 * rng.uniform() - 1)};
}

// All kinds of parts, thin and thick, about a place.
std::vector<Part> clutter(Vec3 about) {
  Rng rng(11);
  std::vector<Part> parts;
  for (int i = 0; i < 150; ++i) {
    const Vec3 p = place_about(rng, about, 30);
    const double size = 0.02 + 5 * rng.uniform();
    switch (i % 4) {
      case 0:
        parts.push_back(prism(std::array{p, p + Vec3{size, 0, 0}, p + Vec3{size, 0.03, 0}, p + Vec3{0, 0.03, 0}},
                              {0.1, 0.2, size}, 0));
        break;
      case 1:
        parts.push_back(cylinder(p, {0, 0.6, 0.8}, size, 0.05 * size, 0));
        break;
      case 2:
        parts.push_back(sphere(p, size, 0));
        break;
      default:
        parts.push_back(Panel{p, {1, 0, 0}, {0, 0, 1}, {{0, 0}, {size, 0}, {0, size}}, {}, 0});
    }
  }
  return parts;
}

TEST(PartScene, FindsWhatBruteForceFinds) {
  for (Vec3 about : {Vec3{0, 0, 0}, Vec3{3000, -2500, 100}}) {
    const std::vector<Part> parts = clutter(about);
    const PartScene scene(parts);
    Rng rng(2);
    int met = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 from = place_about(rng, about, 60), way = place_about(rng, about, 30) - from;
      const Ray ray{from, (1 / norm(way)) * way};
      const auto quick = scene.cast(ray);
      std::optional<PartHit> slow;
      for (const Part& part : parts)
        if (const auto hit = meet(ray, part, 0); hit && (!slow || hit->t < slow->t)) slow = hit;
      ASSERT_EQ(quick.has_value(), slow.has_value());
      if (!quick) continue;
      ++met;
      EXPECT_EQ(quick->t, slow->t);
    }
    EXPECT_GT(met, 2000);
  }
}

TEST(PartScene, CandidatesOfTheAxisServeTheWholeBeam) {
  const double reach = 0.02;
  const std::vector<Part> parts = clutter({0, 0, 0});
  const PartScene wide(parts, reach), exact(parts);
  Rng rng(4);
  std::vector<Candidate> candidates;
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 from = place_about(rng, {0, 0, 0}, 60), way = place_about(rng, {0, 0, 0}, 30) - from;
    const Ray axis{from, (1 / norm(way)) * way};
    wide.candidates(axis, candidates);
    ASSERT_TRUE(std::is_sorted(candidates.begin(), candidates.end(),
                               [](const Candidate& a, const Candidate& b) { return a.enters < b.enters; }));
    // Diverges by at most reach within 150 m.
    const Vec3 target = place_about(rng, axis.direction, 0.7 * reach / 150);
    const Ray ray{from, (1 / norm(target)) * target};
    const auto shared = wide.nearest(ray, candidates), own = exact.cast(ray);
    ASSERT_EQ(shared.has_value(), own.has_value());
    if (!own) continue;
    ++met;
    EXPECT_EQ(shared->t, own->t);
  }
  EXPECT_GT(met, 2000);
}

TEST(PartScene, OfEqualHitsTheSmallerIndexWins) {
  const std::vector<Part> parts{sphere({5, 0, 0}, 1, 8), sphere({5, 0, 0}, 1, 9)};
  const auto hit = PartScene(parts).cast({{0, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->surface, 8u);
}

TEST(PartScene, AnEmptySceneIsEmpty) {
  EXPECT_FALSE(PartScene({}).cast({{0, 0, 0}, {1, 0, 0}}));
}

}  // namespace
}  // namespace ilot::scan
