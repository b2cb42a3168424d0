// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/neighbour_index.h"

#include <algorithm>
#include <limits>

namespace ilot {
namespace {

constexpr std::size_t kFan = 8;
constexpr std::size_t kNodeFloats = 6 * kFan;
constexpr float kFar = std::numeric_limits<float>::max();

std::vector<float> empty_nodes(std::size_t children) {
  const std::size_t nodes = (children + kFan - 1) / kFan;
  std::vector<float> boxes(nodes * kNodeFloats);
  for (std::size_t i = 0; i < nodes; ++i) {
    // An absent child is at the far end of the axis, at an infinite squared distance from any query.
    std::fill_n(boxes.begin() + static_cast<std::ptrdiff_t>(i * kNodeFloats), kNodeFloats, kFar);
  }
  return boxes;
}

struct Box {
  float min[3]{kFar, kFar, kFar};
  float max[3]{-kFar, -kFar, -kFar};
};

void put_box(std::vector<float>& boxes, std::size_t child, const Box& box) {
  float* node = boxes.data() + child / kFan * kNodeFloats + child % kFan;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node[axis * kFan] = box.min[axis];
    node[(axis + 3) * kFan] = box.max[axis];
  }
}

Box leaf_box(Points p, std::size_t leaf) {
  Box box;
  const std::size_t end = std::min(p.size, (leaf + 1) * kFan);
  for (std::size_t i = leaf * kFan; i < end; ++i) {
    const float v[3]{p.x[i], p.y[i], p.z[i]};
    for (int axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], v[axis]);
      box.max[axis] = std::max(box.max[axis], v[axis]);
    }
  }
  return box;
}

Box node_box(const std::vector<float>& boxes, std::size_t node, std::size_t children) {
  Box box;
  const float* p = boxes.data() + node * kNodeFloats;
  const std::size_t count = std::min(kFan, children - node * kFan);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < count; ++i) {
      box.min[axis] = std::min(box.min[axis], p[axis * kFan + i]);
      box.max[axis] = std::max(box.max[axis], p[(axis + 3) * kFan + i]);
    }
  }
  return box;
}

}  // namespace

NeighbourIndex build_neighbour_index(Points points) {
  NeighbourIndex index{points, {}};
  std::size_t children = (points.size + kFan - 1) / kFan;
  index.boxes.push_back(empty_nodes(children));
  for (std::size_t leaf = 0; leaf < children; ++leaf) put_box(index.boxes[0], leaf, leaf_box(points, leaf));
  while (children > kFan) {
    const std::size_t nodes = (children + kFan - 1) / kFan;
    index.boxes.push_back(empty_nodes(nodes));
    const auto& below = index.boxes[index.boxes.size() - 2];
    for (std::size_t node = 0; node < nodes; ++node) put_box(index.boxes.back(), node, node_box(below, node, children));
    children = nodes;
  }
  return index;
}

}  // namespace ilot
