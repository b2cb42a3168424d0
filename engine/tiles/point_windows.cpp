// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/point_windows.h"

#include <algorithm>
#include <mutex>

#include "engine/pass/pass.h"
#include "engine/store/stretches.h"
#include "kernels/core/integers.h"

namespace ilot {
namespace {

constexpr std::size_t kMostUnsorted = 1 << 14;  // windows of a block, possibly repeated, before they are sorted
constexpr std::uint64_t kBytesOfTask = (kStretchPoints + 4 * kMostUnsorted) * 16;

void keep_each_once(std::vector<PointWindow>& windows) {
  std::sort(windows.begin(), windows.end());
  windows.erase(std::unique(windows.begin(), windows.end()), windows.end());
}

// The windows of a block. Its points come in Morton order, so most points are in the same window as the point before.
std::vector<PointWindow> windows_of(const Store& store, std::uint32_t block, std::int64_t side) {
  const Block& b = store.blocks()[block];
  const PointWindow low{floor_divided(b.box.min.y, side), floor_divided(b.box.min.x, side)};
  if (low == PointWindow{floor_divided(b.box.max.y, side), floor_divided(b.box.max.x, side)}) return {low};
  std::vector<PointWindow> windows;
  std::size_t sorted = 0;
  IndexBox last{{0, 0, 0}, {-1, -1, 0}};
  const std::vector<Slice> whole{{block, 0, b.points, 0}};
  for_each_stretch(store, whole, [&](const Stretch& s) {
    for (std::size_t i = 0; i < s.codes.size(); ++i) {
      const Index3 p = s.position(i);
      if (p.x >= last.min.x && p.x <= last.max.x && p.y >= last.min.y && p.y <= last.max.y) continue;
      const PointWindow at{floor_divided(p.y, side), floor_divided(p.x, side)};
      last = {{at.column * side, at.row * side, 0}, {at.column * side + side - 1, at.row * side + side - 1, 0}};
      windows.push_back(at);
      if (windows.size() < 2 * sorted + kMostUnsorted) continue;
      keep_each_once(windows);
      sorted = windows.size();
    }
  });
  keep_each_once(windows);
  return windows;
}

}  // namespace

std::vector<PointWindow> windows_with_points(const Store& store, const PassContext& context, std::int64_t side) {
  std::vector<PointWindow> all;
  std::mutex mutex;
  const std::vector<PassTask> tasks(store.blocks().size(), {kBytesOfTask, 0});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const std::vector<PointWindow> found = windows_of(store, static_cast<std::uint32_t>(i), side);
    const std::lock_guard lock(mutex);
    const auto middle = static_cast<std::ptrdiff_t>(all.size());
    all.insert(all.end(), found.begin(), found.end());
    std::inplace_merge(all.begin(), all.begin() + middle, all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  });
  return all;
}

}  // namespace ilot
