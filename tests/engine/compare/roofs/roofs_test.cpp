// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/roofs/roofs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ilot {
namespace {

constexpr Vec3 kOrigin{651000, 6861000, 0};

Vec3 at(double x, double y, double z) {
  return kOrigin + Vec3{x, y, z};
}

// A gable over [x0, x0 + 6] x [0, 10], eaves at 5 m, ridge at 8 m in the middle; `lift` raises it all.
std::vector<Ring3> gable(double x0, double lift = 0) {
  const double e = 5 + lift, r = 8 + lift;
  return {{at(x0, 0, e), at(x0 + 3, 0, r), at(x0 + 3, 10, r), at(x0, 10, e)},
          {at(x0 + 3, 0, r), at(x0 + 6, 0, e), at(x0 + 6, 10, e), at(x0 + 3, 10, r)}};
}

TruePlane roof_plane(std::uint32_t id, std::uint32_t building, const Ring3& ring) {
  return {id, "roof", {{0, 0, 1}, 0}, {{building, ring, {}}}};
}

PolygonModel model_of(const std::vector<Ring3>& rings) {
  PolygonModel model{"m", {}, {}};
  for (const Ring3& ring : rings) {
    PolygonFace face{{{}}, FaceKind::roof, 0};
    for (const Vec3& p : ring) {
      face.rings[0].push_back(static_cast<std::uint32_t>(model.vertices.size()));
      model.vertices.push_back(p);
    }
    model.faces.push_back(face);
  }
  return model;
}

std::vector<RoofFace> found_roofs(const std::vector<PolygonModel>& models) {
  return model_roofs(models, kOrigin, 1);
}

std::vector<RoofFace> two_gables() {
  std::vector<TruePlane> planes;
  for (const Ring3& ring : gable(0))
    planes.push_back(roof_plane(static_cast<std::uint32_t>(planes.size()) + 1, 1, ring));
  for (const Ring3& ring : gable(20))
    planes.push_back(roof_plane(static_cast<std::uint32_t>(planes.size()) + 1, 2, ring));
  planes.push_back({9, "wall", {{0, 1, 0}, 0}, {{1, {at(0, 0, 0), at(6, 0, 0), at(6, 0, 5)}, {}}}});
  return true_roofs(planes, kOrigin);
}

TEST(Roofs, TheSameRoofIsRight) {
  const std::vector<RoofFace> truth = two_gables();
  ASSERT_EQ(truth.size(), 4u);
  EXPECT_NEAR(truth[0].area(), 10 * std::sqrt(18.0), 1e-9);
  EXPECT_NEAR(truth[0].height({1.5, 4}), 6.5, 1e-9);
  const RoofResult r = evaluate_roofs(truth, found_roofs({model_of(gable(0)), model_of(gable(20))}));
  EXPECT_EQ(r.true_buildings, 2u);
  EXPECT_EQ(r.found_buildings, 2u);
  EXPECT_EQ(r.matched_faces, 4u);
  EXPECT_EQ(r.classes[0].truth, 4u);
  EXPECT_EQ(r.classes[0].right_neighbours, 4u);
  EXPECT_NEAR(r.rms_m, 0, 1e-9);
  EXPECT_NEAR(r.hausdorff_m, 0, 1e-8);
  EXPECT_NEAR(r.outline_p95_m, 0, 1e-3);
  EXPECT_GT(r.covered, 0.999);
}

TEST(Roofs, MeasuresALiftAndAMissingBuilding) {
  const RoofResult r = evaluate_roofs(two_gables(), found_roofs({model_of(gable(0, 0.1))}));
  EXPECT_EQ(r.found_faces, 2u);
  EXPECT_EQ(r.matched_faces, 2u);
  EXPECT_NEAR(r.rms_m, 0.1, 1e-9);
  EXPECT_NEAR(r.covered, 0.5, 0.02);
  EXPECT_NEAR(r.hausdorff_m, std::hypot(20.0, 3.1), 0.5);  // the far eave of the missing one
}

TEST(Roofs, OnePlaneInsteadOfTwoFacesMatchesNeither) {
  const Ring3 flat{at(0, 0, 6.5), at(6, 0, 6.5), at(6, 10, 6.5), at(0, 10, 6.5)};
  const RoofResult r = evaluate_roofs(two_gables(), found_roofs({model_of({flat}), model_of(gable(20))}));
  EXPECT_EQ(r.matched_faces, 2u);
  EXPECT_EQ(r.classes[0].right_neighbours, 2u);
  EXPECT_EQ(r.found_faces, 3u);
}

TEST(Roofs, FacesTornApartAreNoNeighbours) {
  std::vector<Ring3> torn = gable(0);
  for (Vec3& p : torn[1]) p.x += 0.3;
  const RoofResult r = evaluate_roofs(two_gables(), found_roofs({model_of(torn), model_of(gable(20))}));
  EXPECT_EQ(r.matched_faces, 4u);
  EXPECT_EQ(r.classes[0].matched, 4u);
  EXPECT_EQ(r.classes[0].right_neighbours, 2u);
}

TEST(Roofs, SortsFacesBySize) {
  std::vector<TruePlane> planes;
  for (const double side : {4.0, 2.5, 1.5, 1.0}) {
    const auto id = static_cast<std::uint32_t>(planes.size() + 1);
    const double x = 10.0 * id;
    planes.push_back(roof_plane(id, id, {at(x, 0, 3), at(x + side, 0, 3), at(x + side, side, 3), at(x, side, 3)}));
  }
  const RoofResult r = evaluate_roofs(true_roofs(planes, kOrigin), {});
  for (const RoofSizeClass& size : r.classes) EXPECT_EQ(size.truth, 1u) << size.from_m2;
  EXPECT_EQ(r.matched_faces, 0u);
  EXPECT_TRUE(std::isinf(r.hausdorff_m));
  EXPECT_TRUE(std::isinf(r.rms_m));
}

TEST(Roofs, PolygonsOfOnePlaneAndBuildingAreOneFaceWithItsHoles) {
  TruePlane plane{1, "roof", {{0, 0, 1}, -3}, {}};
  const auto square = [](double x0, double y0, double x1, double y1) {
    return Ring3{at(x0, y0, 3), at(x1, y0, 3), at(x1, y1, 3), at(x0, y1, 3)};
  };
  plane.polygons.push_back({1, square(0, 0, 5, 5), {square(1, 1, 2, 2)}});
  plane.polygons.push_back({1, square(5, 0, 7, 5), {}});
  plane.polygons.push_back({2, square(7, 0, 9, 5), {}});
  const std::vector<RoofFace> faces = true_roofs(std::vector<TruePlane>{plane}, kOrigin);
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_NEAR(faces[0].area(), 24 + 10, 1e-9);
  EXPECT_TRUE(covers(faces[0], {6, 1}));
  EXPECT_FALSE(covers(faces[0], {1.5, 1.5}));
  EXPECT_FALSE(covers(faces[0], {8, 1}));
}

TEST(Roofs, NothingOnEitherSide) {
  const RoofResult r = evaluate_roofs({}, {});
  EXPECT_EQ(r.true_faces + r.found_faces + r.matched_faces, 0u);
  EXPECT_EQ(evaluate_roofs({}, found_roofs({model_of(gable(0))})).found_faces, 2u);
}

}  // namespace
}  // namespace ilot
