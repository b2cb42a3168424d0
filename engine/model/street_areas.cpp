// SPDX-License-Identifier: Apache-2.0
#include "engine/model/street_areas.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "kernels/core/union_find.h"

namespace ilot {
namespace {

// Choice: on a page across two such squares a car is still a tenth of a millimetre wide.
constexpr double kSquare = 1000;  // metres; side of the squares that are joined where they touch

using Square = std::pair<std::int64_t, std::int64_t>;  // row, column

// The squares in which there is something, joined to areas where they touch.
class AreaSquares {
 public:
  AreaSquares(const StreetPlan& plan, double metres_per_unit) : metres_(metres_per_unit) {
    for (const StreetObject& o : plan.objects) add(o.middle);
    for (const auto* parts : {&plan.blocks, &plan.gaps})
      for (const FacadePart& part : *parts) add(part.from), add(part.to);
    for (const StreetTree& tree : plan.trees) add(tree.position);
    for (const StreetKerb& kerb : plan.kerbs) add(kerb.line);
    for (const PavementWidth& width : plan.widths) add(width.from);
    for (const Pavement& pavement : plan.pavements) add(pavement.ring);
    for (const Carriageway& road : plan.carriageways) add(road.ring);
    join();
  }
  std::size_t count() const { return areas_; }
  std::size_t area_of(Vec3 p) const { return squares_.at(square_of(p)); }

 private:
  Square square_of(Vec3 p) const {
    return {static_cast<std::int64_t>(std::floor(p.y * metres_ / kSquare)),
            static_cast<std::int64_t>(std::floor(p.x * metres_ / kSquare))};
  }
  void add(Vec3 p) { squares_.emplace(square_of(p), squares_.size()); }
  void add(const std::vector<Vec3>& line) {
    for (const Vec3& p : line) add(p);
  }
  // A line reaches from vertex to vertex through squares that touch, or nearly so: none is a kilometre long.
  void join() {
    std::vector<std::uint32_t> parents(squares_.size());
    UnionFind sets(parents);
    for (const auto& [at, number] : squares_)
      for (std::int64_t row = at.first - 1; row <= at.first; ++row)
        for (std::int64_t column = at.second - 1; column <= at.second + 1; ++column)
          if (const auto beside = squares_.find({row, column}); beside != squares_.end())
            sets.unite(static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(beside->second));
    std::map<std::uint32_t, std::size_t> areas;
    for (auto& [at, number] : squares_)
      number = areas.emplace(sets.find(static_cast<std::uint32_t>(number)), areas.size()).first->second;
    areas_ = areas.size();
  }

  double metres_;
  std::size_t areas_ = 0;
  std::map<Square, std::size_t> squares_;  // a number, after join() that of the area
};

}  // namespace

std::vector<StreetPlan> street_areas(const StreetPlan& plan, double metres_per_unit) {
  const AreaSquares squares(plan, metres_per_unit);
  if (squares.count() <= 1) return {plan};
  std::vector<StreetPlan> areas(squares.count());
  const auto at = [&](Vec3 p) -> StreetPlan& { return areas[squares.area_of(p)]; };
  for (const StreetObject& o : plan.objects) at(o.middle).objects.push_back(o);
  for (const FacadePart& block : plan.blocks) at(block.from).blocks.push_back(block);
  for (const FacadePart& gap : plan.gaps) at(gap.from).gaps.push_back(gap);
  for (const StreetTree& tree : plan.trees) at(tree.position).trees.push_back(tree);
  for (const StreetKerb& kerb : plan.kerbs)
    if (!kerb.line.empty()) at(kerb.line.front()).kerbs.push_back(kerb);
  for (const PavementWidth& width : plan.widths) at(width.from).widths.push_back(width);
  for (const Pavement& pavement : plan.pavements)
    if (!pavement.ring.empty()) at(pavement.ring.front()).pavements.push_back(pavement);
  for (const Carriageway& road : plan.carriageways)
    if (!road.ring.empty()) at(road.ring.front()).carriageways.push_back(road);
  return areas;
}

}  // namespace ilot
