// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/beam.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ilot::scan {
namespace {

// Two walls across the line of sight, along y: the right one stands `step` metres behind the left one.
SceneModel stepped_walls(double step) {
  SceneModel model;
  model.add_surface({1, 1, 0, Material::white_target});
  model.add_surface({2, 2, 0, Material::white_target});
  model.parts.push_back(Panel{{-10, 10, -10}, {1, 0, 0}, {0, 0, 1}, {{0, 0}, {10, 0}, {10, 20}, {0, 20}}, {}, 0});
  model.parts.push_back(
      Panel{{-10, 10 + step, -10}, {1, 0, 0}, {0, 0, 1}, {{9, 0}, {20, 0}, {20, 20}, {9, 20}}, {}, 1});
  return model;
}

constexpr Aim kAhead{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};

BeamParams quiet_beam() {
  BeamParams beam;
  beam.angle_noise_deg = 0;
  return beam;
}

std::vector<Echo> echoes_at(const SceneModel& model, const BeamParams& beam, double x) {
  const PartScene scene(model.parts, 0.05);
  BeamTracer tracer(model, scene, beam);
  std::vector<Echo> echoes;
  Rng rng(1);
  tracer.trace({x, 0, 0}, kAhead, rng, echoes);
  return echoes;
}

TEST(Beam, AWallGivesOneEchoAtItsRange) {
  const auto echoes = echoes_at(stepped_walls(0.05), quiet_beam(), -3);
  ASSERT_EQ(echoes.size(), 1u);
  EXPECT_NEAR(echoes[0].range, 10, 1e-6);
  EXPECT_NEAR(echoes[0].energy, reflectance(Material::white_target), 1e-6);
  EXPECT_EQ(echoes[0].surface, 0u);
  EXPECT_EQ(echoes[0].range, echoes[0].surface_range);
}

TEST(Beam, AFootprintOnAnEdgeGivesAMixedRange) {
  const SceneModel model = stepped_walls(0.05);
  const BeamParams beam = quiet_beam();
  const double radius = footprint_radius(beam, 10);
  for (double x : {-0.55 * radius, -0.1 * radius, 0.1 * radius, 0.55 * radius}) {
    const auto echoes = echoes_at(model, beam, x);
    ASSERT_EQ(echoes.size(), 1u);
    EXPECT_GT(echoes[0].range, 10 + 0.004);
    EXPECT_LT(echoes[0].range, 10.05 - 0.004);
    EXPECT_NEAR(echoes[0].surface_range, x < 0 ? 10 : 10.05, 1e-6);
  }
  // Beyond its footprint there is nothing to mix.
  EXPECT_NEAR(echoes_at(model, beam, -1.01 * radius)[0].range, 10, 1e-6);
  EXPECT_NEAR(echoes_at(model, beam, 1.01 * radius)[0].range, 10.05, 1e-6);
}

TEST(Beam, TheShareOfTheFootprintDecidesTheMixture) {
  // Just left of the edge, two rays of the ring (1/8 each) and the one to the right pass it: 3/8 of the light.
  const auto echoes = echoes_at(stepped_walls(0.08), quiet_beam(), -1e-5);
  ASSERT_EQ(echoes.size(), 1u);
  EXPECT_NEAR(echoes[0].range, 10 + 0.08 * 3 / 8, 1e-5);
}

// Two pieces of one plane, seen at 20 degrees: nothing mixes where they meet.
TEST(Beam, PiecesOfOnePlaneCountAsOneSurface) {
  SceneModel model;
  const Vec3 along{0.9396926207859084, 0.3420201433256687, 0};
  for (std::uint32_t piece = 0; piece < 2; ++piece) {
    model.add_surface({1, 5, 0, Material::white_target});
    const double from = piece == 0 ? -10 : 0;
    model.parts.push_back(
        Panel{{0, 10, -10}, along, {0, 0, 1}, {{from, 0}, {from + 10, 0}, {from + 10, 20}, {from, 20}}, {}, piece});
  }
  const auto together = echoes_at(model, quiet_beam(), 0);
  ASSERT_EQ(together.size(), 1u);
  EXPECT_NEAR(together[0].surface_range, together[0].range, 1e-12);
  model.surfaces[1].plane = 6;
  const auto apart = echoes_at(model, quiet_beam(), 0);
  EXPECT_GT(std::abs(apart[0].surface_range - apart[0].range), 1e-4);
}

TEST(Beam, SurfacesFurtherApartThanTheReceiverSeparatesGiveTwoEchoes) {
  BeamParams beam = quiet_beam();
  beam.separation = 0.3;
  const auto echoes = echoes_at(stepped_walls(0.5), beam, -1e-5);
  ASSERT_EQ(echoes.size(), 2u);
  EXPECT_NEAR(echoes[0].range, 10, 1e-6);
  EXPECT_NEAR(echoes[1].range, 10.5, 1e-6);
  EXPECT_NEAR(echoes[0].energy / echoes[1].energy, 5.0 / 3, 1e-6);
}

TEST(Beam, ABeamWithoutWidthNeverMixes) {
  BeamParams beam = quiet_beam();
  beam.divergence_mrad = beam.diameter = 0;
  for (double x : {-1e-3, -1e-5, 1e-5, 1e-3}) {
    const auto echoes = echoes_at(stepped_walls(0.05), beam, x);
    ASSERT_EQ(echoes.size(), 1u);
    EXPECT_NEAR(echoes[0].range, x < 0 ? 10 : 10.05, 1e-9);
  }
}

TEST(Beam, GlassSendsBackLittleAndLetsSomeThrough) {
  SceneModel model = stepped_walls(0);
  model.surfaces[0].material = Material::glass;
  model.parts[1] = Panel{{-10, 12, -10}, {1, 0, 0}, {0, 0, 1}, {{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {}, 1};
  const PartScene scene(model.parts, 0.05);
  BeamTracer tracer(model, scene, quiet_beam());
  std::vector<Echo> echoes;
  int none = 0, pane = 0, behind = 0;
  const int pulses = 20000;
  for (int i = 0; i < pulses; ++i) {
    Rng rng(3, static_cast<std::uint64_t>(i));
    tracer.trace({-5, 0, 0}, kAhead, rng, echoes);
    ASSERT_LE(echoes.size(), 1u);
    none += echoes.empty();
    if (echoes.empty()) continue;
    (echoes[0].range < 11 ? pane : behind) += 1;
  }
  const Transmission glass = transmission(Material::glass);
  EXPECT_NEAR(none, pulses * glass.lost, 5 * std::sqrt(pulses * 0.25));
  EXPECT_NEAR(behind, pulses * glass.through, 5 * std::sqrt(pulses * 0.25));
  EXPECT_GT(pane, 0);
}

// A pane at 45 degrees that mirrors everything: the wall beside the beam appears behind the pane, at the whole way.
TEST(Beam, AMirrorShowsWhatStandsBesideIt) {
  SceneModel model;
  model.add_surface({1, 1, 4, Material::glass});
  model.add_surface({2, 2, 0, Material::white_target});
  const double d = std::sqrt(0.5);
  model.parts.push_back(Panel{{-d, 10 - d, -1}, {d, d, 0}, {0, 0, 1}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}, 0});
  model.parts.push_back(Panel{{6, 0, -5}, {0, 1, 0}, {0, 0, 1}, {{0, 0}, {20, 0}, {20, 10}, {0, 10}}, {}, 1});
  BeamParams beam = quiet_beam();
  beam.glass = {0, 0, 1};
  const PartScene scene(model.parts, 0.05);
  BeamTracer tracer(model, scene, beam);
  std::vector<Echo> echoes;
  Rng rng(1);
  tracer.trace({0, 0, 0}, kAhead, rng, echoes);
  ASSERT_EQ(echoes.size(), 1u);
  EXPECT_NEAR(echoes[0].range, 16, 1e-4);
  EXPECT_EQ(echoes[0].surface, 1u);
  EXPECT_EQ(echoes[0].pane, 0u);
  EXPECT_EQ(tracer.first_surface(), 0u);
  beam.glass = {1, 0, 0};
  BeamTracer lost(model, scene, beam);
  lost.trace({0, 0, 0}, kAhead, rng, echoes);
  EXPECT_TRUE(echoes.empty());
  EXPECT_EQ(lost.first_surface(), 0u);
}

}  // namespace
}  // namespace ilot::scan
