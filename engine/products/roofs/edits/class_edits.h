// SPDX-License-Identifier: Apache-2.0
// Classes of points that a person has set: points in an area are a building's, the ground's or neither.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/columns/point_roles.h"
#include "engine/model/edit.h"
#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

// The edits of roofs that set the class of points, in their order. They must outlive it.
class ClassEdits {
 public:
  // `unit` is that of the store.
  ClassEdits(std::span<const Edit> edits, double unit);

  std::size_t size() const { return edits_.size(); }
  const Edit& operator[](std::size_t i) const { return *edits_[i]; }
  PointRole role(std::size_t i) const;

  // Returns the edits whose areas meet the box, ascending.
  std::vector<std::size_t> near(const IndexBox& box) const;

  // Returns true where the area and the heights of edit i contain the point. O(corners) in the box of the area.
  bool contains(std::size_t i, Index3 point) const;

 private:
  std::vector<const Edit*> edits_;
  double unit_;
};

// Throws a usage Error for two edits that give the points of one area two classes.
void check_class_edits(std::span<const Edit> edits);

// Rewrites the column "role" of the points in the areas; where areas overlap the last edit counts. Returns for each
// edit the number of points in its area, whatever their role was. O(points of the blocks that meet an area).
std::vector<std::uint64_t> edit_roles(const Store& store, const ClassEdits& edits, const PassContext& context);

}  // namespace ilot
