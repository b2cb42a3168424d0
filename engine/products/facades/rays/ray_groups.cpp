// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/rays/ray_groups.h"

#include <algorithm>
#include <vector>

namespace ilot {
namespace {

// Collects rays until they are written to the column, a few of each group.
class GroupWriter {
 public:
  GroupWriter(RayColumn& column, std::span<const std::uint64_t> counts)
      : column_(column), each_(waiting_of_each(counts)) {
    waiting_.resize(each_ * counts.size());
    filled_.resize(counts.size(), 0);
    std::uint64_t first = 0;
    for (const std::uint64_t count : counts) {
      next_.push_back(first);
      first += count;
    }
  }
  void add(std::size_t group, const Ray& ray) {
    waiting_[group * each_ + filled_[group]++] = ray;
    if (filled_[group] == each_) write(group);
  }
  void finish() {
    for (std::size_t g = 0; g < filled_.size(); ++g) write(g);
  }

 private:
  static constexpr std::size_t kWaiting = std::size_t{1} << 15;  // rays of all groups together

  // No group waits for more rays than it has.
  static std::size_t waiting_of_each(std::span<const std::uint64_t> counts) {
    if (counts.empty()) return 1;
    return std::max<std::size_t>(1, std::min<std::uint64_t>(kWaiting / counts.size(), std::ranges::max(counts)));
  }

  void write(std::size_t group) {
    column_.write(next_[group], {waiting_.data() + group * each_, filled_[group]});
    next_[group] += filled_[group];
    filled_[group] = 0;
  }

  RayColumn& column_;
  std::size_t each_;
  std::vector<Ray> waiting_;
  std::vector<std::size_t> filled_;
  std::vector<std::uint64_t> next_;
};

}  // namespace

RayColumn grouped_rays(const RayColumn& rays, std::span<const std::uint64_t> counts,
                       const std::function<std::size_t(const Ray&)>& group_of, RayColumn grouped) {
  std::uint64_t all = 0;
  for (const std::uint64_t count : counts) all += count;
  grouped.resize(all);
  GroupWriter writer(grouped, counts);
  for (const Ray& ray : Rays(rays, {{0, rays.size()}}))
    if (const std::size_t group = group_of(ray); group != kNoGroup) writer.add(group, ray);
  writer.finish();
  return grouped;
}

}  // namespace ilot
