// SPDX-License-Identifier: Apache-2.0
// Measures how well found planes agree with true ones, point by point.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

namespace ilot {

// The number of points that carry this pair of labels; 0 = none.
struct LabelPair {
  std::uint32_t truth = 0, found = 0;
  std::uint64_t points = 0;
};

// Counts pairs of labels as points stream by. Memory grows with the number of different pairs, not of points.
class LabelPairs {
 public:
  void add(std::uint32_t truth, std::uint32_t found) { ++counts_[(std::uint64_t{truth} << 32) | found]; }

  // Returns the pairs ascending by truth, then by found.
  std::vector<LabelPair> sorted() const;

 private:
  std::unordered_map<std::uint64_t, std::uint64_t> counts_;
};

struct PlaneMatch {
  std::uint32_t truth = 0, found = 0;
  std::uint64_t shared = 0;  // points that carry both
};

// A found plane and the true plane that most of its points belong to.
struct FoundPlane {
  std::uint32_t id = 0, main_truth = 0;
  std::uint64_t points = 0;   // all that carry it
  std::uint64_t foreign = 0;  // points of true planes other than main_truth (points of no true plane are not foreign)
  double foreign_share() const { return points == 0 ? 0 : static_cast<double>(foreign) / static_cast<double>(points); }
};

struct PlaneMatching {
  std::uint64_t true_planes = 0;
  std::uint64_t found_planes = 0;
  std::vector<PlaneMatch> matches;  // one to one, ascending by truth
  std::uint64_t missed = 0;         // true planes without a partner
  std::uint64_t over = 0;           // true planes that are the main truth of at least two found planes (over-segmented)
  std::uint64_t under = 0;        // found planes that contain most points of at least two true planes (under-segmented)
  std::uint64_t points = 0;       // points of true planes
  std::uint64_t carrying = 0;     // points that carry the partner of their plane
  std::vector<FoundPlane> found;  // ascending by id

  double share() const { return points == 0 ? 0 : static_cast<double>(carrying) / static_cast<double>(points); }
};

// The rule by which a true and a found plane may be partners.
enum class MatchRule : std::uint8_t {
  main,     // their common points are more than half of the found plane's
  overlap,  // their common points are at least half of the points of both together (intersection over union)
};

// Pairs that qualify by the rule are matched one to one in the order of the points they share (ties: smaller truth,
// then smaller found). `counts` decides which true planes are judged (for instance roofs only; empty = all). A found
// plane is judged, with all of its points, when its main truth is judged. A found plane whose points belong to no true
// plane is judged only when all true planes are judged. `pairs` are in the order of LabelPairs::sorted(). O(n log n) in
// the number of pairs.
PlaneMatching match_planes(std::span<const LabelPair> pairs, const std::function<bool(std::uint32_t)>& counts = {},
                           MatchRule rule = MatchRule::main);

// The same from the labels of points, in arrays of equal length; 0 = none.
PlaneMatching match_planes(std::span<const std::uint32_t> truth, std::span<const std::uint32_t> found);

}  // namespace ilot
