// SPDX-License-Identifier: Apache-2.0
#include "engine/store/box_tree.h"

#include <algorithm>

namespace ilot {
namespace {

constexpr std::size_t kFan = 8;

IndexBox around(std::span<const IndexBox> boxes) {
  IndexBox all = boxes[0];
  for (const IndexBox& b : boxes.subspan(1)) all.add_box(b);
  return all;
}

std::vector<IndexBox> around_eights(std::span<const IndexBox> below) {
  std::vector<IndexBox> level;
  for (std::size_t i = 0; i < below.size(); i += kFan)
    level.push_back(around(below.subspan(i, std::min(kFan, below.size() - i))));
  return level;
}

// Searches the tree from one level down to the list; there are at most eleven levels.
struct Search {
  std::span<const std::vector<IndexBox>> levels;
  std::span<const IndexBox> boxes;
  const IndexBox& box;
  std::vector<std::uint32_t>& found;

  void visit(std::size_t level, std::size_t begin, std::size_t end) const {
    if (level == 0) {
      for (std::size_t i = begin; i < end; ++i)
        if (boxes[i].intersects(box)) found.push_back(static_cast<std::uint32_t>(i));
      return;
    }
    const std::size_t below = level == 1 ? boxes.size() : levels[level - 2].size();
    for (std::size_t i = begin; i < end; ++i)
      if (levels[level - 1][i].intersects(box)) visit(level - 1, i * kFan, std::min(below, (i + 1) * kFan));
  }
};

}  // namespace

BoxTree::BoxTree(std::span<const IndexBox> boxes) {
  while (boxes.size() > kFan) {
    levels_.push_back(around_eights(boxes));
    boxes = levels_.back();
  }
}

void BoxTree::find(std::span<const IndexBox> boxes, const IndexBox& box, std::vector<std::uint32_t>& found) const {
  const std::size_t top = levels_.empty() ? boxes.size() : levels_.back().size();
  Search{levels_, boxes, box, found}.visit(levels_.size(), 0, top);
}

}  // namespace ilot
