// SPDX-License-Identifier: Apache-2.0
#include "engine/streets/whole_things.h"

namespace ilot {

std::vector<std::uint8_t> whole_things(std::span<const Thing> things, std::span<const ThingClass> classes) {
  std::vector<double> best(things.size(), 0);
  std::vector<std::uint8_t> better(things.size(), 0), taken(things.size(), 0), inside(things.size(), 0);
  for (std::size_t i = 0; i < things.size(); ++i) {  // parts come first
    const Thing& t = things[i];
    const double own = t.pixels * classes[i].whole;
    const double parted = t.parts[0] == 0 ? 0 : best[t.parts[0] - 1] + best[t.parts[1] - 1];
    better[i] = own >= parted;
    best[i] = better[i] ? own : parted;
  }
  for (std::size_t i = things.size(); i-- > 0;) {
    const Thing& t = things[i];
    taken[i] = inside[i] == 0 && (better[i] != 0 || t.parts[0] == 0);
    if (t.parts[0] == 0) continue;
    for (const std::uint32_t part : t.parts) inside[part - 1] = inside[i] != 0 || taken[i] != 0;
  }
  return taken;
}

std::vector<std::uint32_t> thing_of_part(std::span<const Thing> things, std::span<const std::uint8_t> taken) {
  std::vector<std::uint32_t> holder(things.size() + 1, 0), of{0};
  for (std::size_t i = things.size(); i-- > 0;) {
    if (taken[i] != 0) holder[i + 1] = static_cast<std::uint32_t>(i + 1);
    for (const std::uint32_t part : things[i].parts)
      if (part != 0) holder[part] = holder[i + 1];
  }
  for (std::size_t i = 0; i < things.size() && things[i].parts[0] == 0; ++i) of.push_back(holder[i + 1]);
  return of;
}

}  // namespace ilot
