// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "scan/streets/artefact.h"

namespace ilot::scan {
namespace {

// Returns eight corners on an ellipse with the given half axes.
std::array<FlatPoint, 8> oval(double x, double y) {
  constexpr double kDiagonal = 0.70710678118654752;
  return {{{x, 0},
           {kDiagonal * x, kDiagonal * y},
           {0, y},
           {-kDiagonal * x, kDiagonal * y},
           {-x, 0},
           {-kDiagonal * x, -kDiagonal * y},
           {0, -y},
           {kDiagonal * x, -kDiagonal * y}}};
}

void add_legs(Artefact& body, double h, double stride) {
  for (double side : {-1.0, 1.0}) {
    const Vec3 hip{0, side * 0.055 * h, 0.5 * h}, foot{side * stride * h, side * 0.055 * h, 0.03 * h};
    body.rod(foot, hip, 0.045 * h, Material::cloth);
    body.box(foot + Vec3{0.03 * h, 0, -0.005 * h}, {0.15 * h, 0.055 * h, 0.05 * h}, Material::iron);
  }
}

void add_arms(Artefact& body, double h, double stride, bool raised) {
  for (double side : {-1.0, 1.0}) {
    const Vec3 shoulder{0, side * 0.125 * h, 0.79 * h};
    const Vec3 hand = raised && side > 0 ? Vec3{0.16 * h, 0.07 * h, 0.86 * h}
                                         : Vec3{-side * 0.8 * stride * h, side * 0.14 * h, 0.45 * h};
    body.rod(hand, shoulder, 0.028 * h, Material::cloth);
  }
}

}  // namespace

Artefact make_pedestrian(std::string_view variant, Rng& rng) {
  const double h = variant == "child" ? 1.0 + 0.35 * rng.uniform() : 1.55 + 0.32 * rng.uniform();
  const bool moving = variant == "walking" || variant == "bag" || variant == "child";
  const double stride = moving ? 0.06 + 0.08 * rng.uniform() : 0.01;
  Artefact body;
  add_legs(body, h, stride);
  body.column(oval(0.07 * h, 0.105 * h), 0.46 * h, 0.6 * h, Material::cloth);
  body.column(oval(0.075 * h, 0.13 * h), 0.6 * h, 0.83 * h, Material::cloth);
  add_arms(body, h, stride, variant == "phone" || variant == "umbrella");
  body.rod({0, 0, 0.82 * h}, {0, 0, 0.9 * h}, 0.03 * h, Material::wood);
  body.ball({0.01 * h, 0, 0.934 * h}, 0.066 * h, Material::wood);
  if (variant == "bag") body.box({0.02, -0.17 * h, 0.33 * h}, {0.36, 0.12, 0.3}, Material::cloth);
  if (variant == "backpack") body.box({-0.12 * h, 0, 0.69 * h}, {0.2, 0.3, 0.45}, Material::cloth);
  if (variant == "umbrella") {
    body.rod({0.16 * h, 0.07 * h, 0.8 * h}, {0.16 * h, 0.07 * h, 1.16 * h}, 0.012, Material::iron);
    body.taper({0.16 * h, 0.07 * h, 1.05 * h}, 0.2, 0.5, 0.02, Material::cloth);
  }
  return body;
}

}  // namespace ilot::scan
