// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/thing_relations.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

double of(const Thing& thing, ThingFeature f) {
  return thing.features[static_cast<std::size_t>(f)];
}
double of(const Thing& thing, ComponentFeature f) {
  return thing.features[static_cast<std::size_t>(f)];
}
void set(Thing& thing, ThingFeature f, double value) {
  thing.features[static_cast<std::size_t>(f)] = value;
}

// A thing that nothing is joined with and that joins none.
void stand_alone(Thing& t) {
  const double box = of(t, ThingFeature::length) * of(t, ThingFeature::width);
  set(t, ThingFeature::fill, box > 0 ? of(t, ComponentFeature::area) / box : 0);
  for (const auto f : {ThingFeature::lesser_share, ThingFeature::top_step, ThingFeature::mean_step, ThingFeature::rise})
    set(t, f, 0);
  set(t, ThingFeature::joined_share, 1);
  set(t, ThingFeature::joined_fill, of(t, ThingFeature::fill));
  set(t, ThingFeature::joined_length, of(t, ThingFeature::length));
}

void set_joined(const Thing& whole, const Thing& other, Thing& part) {
  const double area = of(whole, ComponentFeature::area);
  set(part, ThingFeature::joined_share, area > 0 ? of(part, ComponentFeature::area) / area : 0);
  set(part, ThingFeature::rise, of(part, ComponentFeature::max_height) - of(other, ComponentFeature::max_height));
  set(part, ThingFeature::joined_fill, of(whole, ThingFeature::fill));
  set(part, ThingFeature::joined_length, of(whole, ThingFeature::length));
}

}  // namespace

void relate_things(std::span<Thing> things) {
  for (Thing& t : things) stand_alone(t);
  for (Thing& t : things) {
    if (t.parts[0] == 0) continue;
    Thing &a = things[t.parts[0] - 1], &b = things[t.parts[1] - 1];
    const auto step = [&](ComponentFeature f) { return std::abs(of(a, f) - of(b, f)); };
    const double area = of(t, ComponentFeature::area);
    const double lesser = std::min(of(a, ComponentFeature::area), of(b, ComponentFeature::area));
    set(t, ThingFeature::lesser_share, area > 0 ? lesser / area : 0);
    set(t, ThingFeature::top_step, step(ComponentFeature::max_height));
    set(t, ThingFeature::mean_step, step(ComponentFeature::mean_height));
    set_joined(t, b, a);
    set_joined(t, a, b);
  }
}

}  // namespace ilot
