// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/framed_windows.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/products/facades/leaves/leaf_judge.h"

namespace ilot {
namespace {

// Choice: the errors of the sides of small panes take a tenth; what reaches farther out is in another window.
constexpr double kPaneInFrame = 0.9;  // share of a pane that lies in its frame
// Choice: one of two sashes; a pane in a strip that goes on over storeys is not a pane of it.
constexpr double kLeastOfFrame = 0.4;  // height of the panes over that of their frame
// Choice: lower plates are signs, panels and boxes of blinds.
constexpr double kLowestFrame = 0.8;  // metres, height

// What was made of a plate.
enum class PlateUse : std::uint8_t { none, frame, closed };

// The openings in a plate, by number.
std::vector<std::size_t> panes_in(const FlatPlate& plate, const std::vector<FoundRectangle>& openings) {
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < openings.size(); ++i)
    if (common_area(plate.shape.box(), openings[i].box()) > kPaneInFrame * area_of(openings[i].box()))
      inside.push_back(i);
  return inside;
}

// The rectangle around some openings, with the errors of the sides that lie farthest out.
FoundRectangle around(const std::vector<FoundRectangle>& openings, const std::vector<std::size_t>& members) {
  FoundRectangle all = openings[members.front()];
  for (const std::size_t m : members)
    for (const Side side : kSides)
      if (outwards(side) * (openings[m].at(side) - all.at(side)) > 0) all.side(side) = openings[m].side(side);
  return all;
}

// Extends the openings that are panes of a frame, and says which plates are frames.
void fill_frames(const std::vector<FlatPlate>& plates, const LeafJudge& judge, std::vector<FoundRectangle>& openings,
                 std::vector<PlateUse>& uses) {
  for (std::size_t i = 0; i < plates.size(); ++i) {
    const std::vector<std::size_t> inside = panes_in(plates[i], openings);
    if (inside.empty()) continue;
    const FoundRectangle panes = around(openings, inside);
    if (!judge.are_panes_of(plates[i], panes) || panes.box().height() < kLeastOfFrame * plates[i].shape.box().height())
      continue;
    const std::size_t largest = *std::max_element(inside.begin(), inside.end(), [&](std::size_t a, std::size_t b) {
      return area_of(openings[a].box()) < area_of(openings[b].box());
    });
    make_rectangle(openings[largest]);
    widen(plates[i], openings[largest]);
    uses[i] = PlateUse::frame;
  }
}

}  // namespace

std::vector<ShutterLeaf> find_framed_windows(double most_depth, double alike, double cell,
                                             std::vector<FoundRectangle>& relief,
                                             std::vector<FoundRectangle>& openings) {
  const LeafJudge judge(alike, cell);
  std::vector<FlatPlate> plates;
  std::vector<std::size_t> of_relief;
  for (std::size_t i = 0; i < relief.size(); ++i)
    if (relief[i].depth > 0 && relief[i].depth <= most_depth && relief[i].box().height() >= kLowestFrame)
      plates.push_back({relief[i], {1, 1, 1, 1}}), of_relief.push_back(i);
  std::vector<PlateUse> uses(plates.size(), PlateUse::none);
  fill_frames(plates, judge, openings, uses);
  std::vector<ShutterLeaf> leaves;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < plates.size(); ++i) {
      if (uses[i] != PlateUse::none) continue;
      const bool is_free = std::none_of(openings.begin(), openings.end(),
                                        [&](const FoundRectangle& o) { return judge.excludes(o, plates[i]); });
      if (!is_free || std::none_of(openings.begin(), openings.end(),
                                   [&](const FoundRectangle& o) { return judge.is_as_large(plates[i], o); }))
        continue;
      uses[i] = PlateUse::closed;
      openings.push_back(outlined_by(plates[i]));
      if (plates[i].shape.depth <= kFlatRelief) leaves.push_back({plates[i].shape, LeafState::closed});
      more = true;
    }
  }
  std::vector<bool> taken(relief.size(), false);
  for (std::size_t i = 0; i < plates.size(); ++i)
    taken[of_relief[i]] =
        uses[i] == PlateUse::frame || (uses[i] == PlateUse::closed && plates[i].shape.depth <= kFlatRelief);
  std::size_t number = 0;
  std::erase_if(relief, [&](const FoundRectangle&) { return taken[number++]; });
  return leaves;
}

}  // namespace ilot
