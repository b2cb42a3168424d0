// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_styles.h"

#include <algorithm>
#include <utility>

#include "scan/districts/dormers.h"
#include "scan/roofs/roof_wings.h"

namespace ilot::scan {
namespace {

Integer step(Rng& rng, Integer from, Integer by, std::uint64_t choices) {
  return from + by * static_cast<Integer>(rng.below(choices));
}

bool happens(Rng& rng, double chance) {
  return rng.uniform() < chance;
}

// The body of a house. Its ridge is parallel to u.
struct Body {
  Integer length = 0, depth = 0, eave = 0, slope = 0;
  GridRect rect() const { return {0, 0, length, depth}; }
  Integer ridge() const { return eave + slope * depth / (2 * kSlopeUnit); }
};

Body draw_body(Rng& rng) {
  Body body;
  body.length = step(rng, 8000, 500, 15);
  body.depth = step(rng, 7000, 500, 9);
  body.eave = step(rng, 2750, 250, 15);
  body.slope = step(rng, 7, 1, 10);
  return body;
}

void turn_at_random(Rng& rng, std::vector<Wing>& wings) {
  const GridRect bounds = bounds_of(wings);
  const bool flip_u = happens(rng, 0.5), flip_v = happens(rng, 0.5);
  for (Wing& wing : wings) {
    wing = moved(wing, -bounds.u0, -bounds.v0, 0);
    if (flip_u) wing = mirrored_u(wing, bounds.u1 - bounds.u0);
    if (flip_v) wing = mirrored_v(wing, bounds.v1 - bounds.v0);
  }
}

// Adds a lower building against the right end: a garage under a flat or a shed roof.
void add_annex(Rng& rng, const Body& body, std::vector<Wing>& wings) {
  const Integer from = step(rng, 0, 500, 4), depth = std::min(body.depth - from, step(rng, 4000, 500, 6));
  const GridRect rect{body.length, from, body.length + step(rng, 2500, 500, 5), from + depth};
  const Integer height = std::min(body.eave - 500, step(rng, 2250, 250, 4));
  if (happens(rng, 0.5))
    wings.push_back(flat_wing(rect, height));
  else
    wings.push_back(shed_wing(rect, height - 250, 3, Uphill::west));
}

// Returns a wing that leaves the body southwards. Its ridge is parallel to v and ends below the ridge of the body.
Wing cross_wing(Rng& rng, const Body& body, Integer from, Integer width) {
  const GridRect rect{from, -step(rng, 0, 750, 8), from + width, body.depth / 2};
  const Integer eave = happens(rng, 0.7) ? body.eave : body.eave - step(rng, 500, 250, 3);
  Wing wing = gable_wing(rect, Axis::v, eave, body.slope);
  if (happens(rng, 0.35)) wing.planes.push_back(shed_wing(rect, eave, body.slope, Uphill::north).planes[0]);
  return wing;
}

// Draws L, T, U, H and cross forms: a body with cross wings on either side, and dormers on the free parts of the
// slopes.
std::vector<Wing> draw_winged(Rng& rng) {
  Body body = draw_body(rng);
  body.length = std::max(body.length, Integer{11000});
  std::vector<Wing> wings;
  const double style = rng.uniform();
  if (style < 0.5)
    wings.push_back(gable_wing(body.rect(), Axis::u, body.eave, body.slope));
  else if (style < 0.75)
    wings.push_back(hip_wing(body.rect(), body.eave, body.slope, body.slope));
  else
    wings.push_back(half_hip_wing(body.rect(), Axis::u, body.eave, body.slope, 1500));
  const bool ends_slope = style >= 0.5;
  for (int flank = 0; flank < 2; ++flank) {
    const std::uint64_t layout = flank == 0 ? 1 + rng.below(4) : rng.below(5);
    const Integer width = std::min({step(rng, 4000, 500, 8), body.depth, (body.length - 2000) / 2});
    std::vector<Wing> side;
    if (layout == 1 || layout == 3) side.push_back(cross_wing(rng, body, 0, width));
    if (layout == 2 || layout == 3) side.push_back(cross_wing(rng, body, body.length - width, width));
    if (layout == 4) side.push_back(cross_wing(rng, body, (body.length - width) / 2, width));
    Integer from = layout == 1 || layout == 3 ? width : 0, to = body.length - (layout == 2 || layout == 3 ? width : 0);
    if (ends_slope && from == 0) from = body.depth / 2 - 1000;
    if (ends_slope && to == body.length) to -= body.depth / 2 - 1000;
    if (layout == 4) to = (body.length - width) / 2;
    if (happens(rng, 0.65)) add_dormers(rng, {from, to, body.eave, body.slope, body.depth / 2}, side);
    for (Wing& wing : side) wings.push_back(flank == 0 ? wing : mirrored_v(wing, body.depth));
  }
  if (happens(rng, 0.2)) add_annex(rng, body, wings);
  return wings;
}

std::vector<Wing> draw_dormered(Rng& rng) {
  Body body = draw_body(rng);
  body.slope = std::max(body.slope, Integer{11});
  body.depth = std::max(body.depth, Integer{9000});
  const double style = rng.uniform();
  std::vector<Wing> wings{style < 0.6   ? gable_wing(body.rect(), Axis::u, body.eave, body.slope)
                          : style < 0.8 ? half_hip_wing(body.rect(), Axis::u, body.eave, body.slope, 2000)
                                        : hip_wing(body.rect(), body.eave, body.slope, body.slope)};
  const Integer end = style < 0.6 ? 0 : style < 0.8 ? 1000 : body.depth / 2 - 1500;
  for (int flank = 0; flank < 2; ++flank) {
    std::vector<Wing> side;
    if (flank == 0 || happens(rng, 0.6))
      add_dormers(rng, {end, body.length - end, body.eave, body.slope, body.depth / 2}, side);
    for (Wing& wing : side) wings.push_back(flank == 0 ? wing : mirrored_v(wing, body.depth));
  }
  return wings;
}

std::vector<Wing> draw_half_hip(Rng& rng) {
  const Body body = draw_body(rng);
  std::vector<Wing> wings{half_hip_wing(body.rect(), Axis::u, body.eave, body.slope, step(rng, 1000, 250, 4))};
  if (happens(rng, 0.6)) add_annex(rng, body, wings);
  return wings;
}

std::vector<Wing> draw_mansard(Rng& rng, BuiltForm built_form) {
  Body body = draw_body(rng);
  body.eave = step(rng, 5500, 250, 10);
  const Integer steep = 40, shallow = 6, knee = 2400;
  std::vector<Wing> wings{built_form == BuiltForm::terraced || happens(rng, 0.3)
                              ? gambrel_wing(body.rect(), Axis::u, body.eave, steep, shallow, knee)
                              : mansard_wing(body.rect(), body.eave, steep, shallow, knee)};
  const Integer width = 1500, pitch = step(rng, 2750, 250, 4);
  for (Integer u = 2000; u + width + 2000 <= body.length; u += pitch)
    for (int flank = 0; flank < 2; ++flank) {
      const Wing dormer = flat_wing({u, 250, u + width, 2500}, body.eave + 2000);
      wings.push_back(flank == 0 ? dormer : mirrored_v(dormer, body.depth));
    }
  return wings;
}

// Draws flat roofs at two to four levels.
std::vector<Wing> draw_stepped(Rng& rng, BuiltForm built_form) {
  Body body = draw_body(rng);
  body.eave = step(rng, 5000, 500, 8);
  body.depth += 2000;
  const Integer split = step(rng, 3000, 500, static_cast<std::uint64_t>((body.length - 6000) / 500 + 1));
  std::vector<Wing> wings{flat_wing({0, 0, split, body.depth}, body.eave),
                          flat_wing({split, 0, body.length, body.depth}, body.eave - step(rng, 1000, 500, 5))};
  if (happens(rng, 0.7))
    wings.push_back(flat_wing({1000, 2000, split - 500, body.depth - 2000}, body.eave + step(rng, 1000, 500, 4)));
  if (built_form == BuiltForm::detached && happens(rng, 0.5))
    wings.push_back(flat_wing({split - 1500, -2500, split + 1000, 1000}, 3000));
  return wings;
}

// Draws two sheds back to back with a step between them, or a saw-tooth roof.
std::vector<Wing> draw_sheds(Rng& rng, BuiltForm built_form) {
  const Body body = draw_body(rng);
  if (built_form == BuiltForm::detached && happens(rng, 0.25)) {
    std::vector<Wing> teeth;
    const Integer tooth = step(rng, 3500, 500, 4);
    for (Integer i = 0; i < 2 + static_cast<Integer>(rng.below(4)); ++i)
      teeth.push_back(shed_wing({i * tooth, 0, (i + 1) * tooth, body.depth + 4000}, body.eave + 1500, 8, Uphill::east));
    return teeth;
  }
  const Integer split = body.depth * step(rng, 4, 1, 3) / 10;
  return {shed_wing({0, 0, body.length, split}, body.eave, body.slope, Uphill::north),
          shed_wing({0, split, body.length, body.depth}, body.eave - step(rng, 0, 250, 3), 6, Uphill::south)};
}

// Draws two gables side by side with a valley between them, or a gable with a lower one beside it.
std::vector<Wing> draw_double(Rng& rng, BuiltForm built_form) {
  Body body = draw_body(rng);
  const Integer second = step(rng, 5000, 500, 7), lower = happens(rng, 0.5) ? 0 : step(rng, 750, 250, 5);
  const Integer from = built_form == BuiltForm::detached ? step(rng, 0, 1000, 4) : 0;
  const GridRect beside{from, body.depth, body.length, body.depth + second};
  return {gable_wing(body.rect(), Axis::u, body.eave, body.slope),
          gable_wing(beside, Axis::u, std::max(body.eave - lower, Integer{2250}), body.slope)};
}

// Draws a gable or hip with a square tower at a corner or in the middle of the front.
std::vector<Wing> draw_tower(Rng& rng) {
  const Body body = draw_body(rng);
  std::vector<Wing> wings{happens(rng, 0.5) ? gable_wing(body.rect(), Axis::u, body.eave, body.slope)
                                            : hip_wing(body.rect(), body.eave, body.slope, body.slope)};
  const Integer side = step(rng, 3500, 500, 4), out = step(rng, 1000, 500, 3);
  const Integer from = happens(rng, 0.5) ? -out : (body.length - side) / 2;
  const Integer height = std::max(body.ridge(), body.eave + 2000) + step(rng, 250, 250, 4);
  const GridRect rect{from, -out, from + side, side - out};
  const Integer slope = step(rng, 12, 2, 3);
  wings.push_back(hip_wing(rect, height, slope, slope));
  if (happens(rng, 0.5)) add_annex(rng, body, wings);
  return wings;
}

std::vector<Wing> draw_complex(Rng& rng, BuiltForm built_form) {
  const double style = rng.uniform();
  if (built_form == BuiltForm::terraced) {
    if (style < 0.4) return draw_dormered(rng);
    if (style < 0.6) return draw_mansard(rng, built_form);
    if (style < 0.75) return draw_stepped(rng, built_form);
    return style < 0.9 ? draw_sheds(rng, built_form) : draw_double(rng, built_form);
  }
  if (style < 0.44) return draw_winged(rng);
  if (style < 0.58) return draw_dormered(rng);
  if (style < 0.66) return draw_half_hip(rng);
  if (style < 0.74) return draw_mansard(rng, built_form);
  if (style < 0.82) return draw_stepped(rng, built_form);
  if (style < 0.88) return draw_sheds(rng, built_form);
  return style < 0.94 ? draw_double(rng, built_form) : draw_tower(rng);
}

std::vector<Wing> draw_simple(Rng& rng, RoofKind kind, BuiltForm built_form) {
  const Body body = draw_body(rng);
  if (kind == RoofKind::hip) return {hip_wing(body.rect(), body.eave, body.slope, step(rng, body.slope, 2, 3))};
  const Axis ridge = built_form == BuiltForm::terraced || happens(rng, 0.7) ? Axis::u : Axis::v;
  return {gable_wing(body.rect(), ridge, body.eave, body.slope)};
}

// A chimney is 60 x 60 cm and ends 1.2 m above the roof.
void add_chimney(Rng& rng, std::vector<Wing>& wings) {
  const GridRect& body = wings[0].rect;
  const Integer u = body.u0 + step(rng, 1250, 500, static_cast<std::uint64_t>((body.u1 - body.u0 - 3000) / 500 + 1));
  const Integer v = (body.v0 + body.v1) / 2 + step(rng, -1300, 1700, 2);
  const double roof = height_mm(wings[0], static_cast<double>(u + 300), static_cast<double>(v + 300));
  wings.push_back(flat_wing({u, v, u + 600, v + 600}, static_cast<Integer>(roof) + 1200));
}

}  // namespace

const char* name_of(RoofKind kind) {
  switch (kind) {
    case RoofKind::gable:
      return "gable";
    case RoofKind::hip:
      return "hip";
    default:
      return "complex";
  }
}

RoofDesign draw_roof(Rng& rng, RoofKind kind, BuiltForm built_form, double chimneys) {
  RoofDesign design{kind,
                    kind == RoofKind::complex ? draw_complex(rng, built_form) : draw_simple(rng, kind, built_form)};
  if (happens(rng, chimneys)) add_chimney(rng, design.wings);
  turn_at_random(rng, design.wings);
  return design;
}

GridRect bounds_of(const std::vector<Wing>& wings) {
  GridRect bounds = wings[0].rect;
  for (const Wing& wing : wings) {
    bounds.u0 = std::min(bounds.u0, wing.rect.u0);
    bounds.v0 = std::min(bounds.v0, wing.rect.v0);
    bounds.u1 = std::max(bounds.u1, wing.rect.u1);
    bounds.v1 = std::max(bounds.v1, wing.rect.v1);
  }
  return bounds;
}

}  // namespace ilot::scan
