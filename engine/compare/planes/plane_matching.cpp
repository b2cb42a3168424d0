// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/planes/plane_matching.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace ilot {
namespace {

using Totals = std::map<std::uint32_t, std::uint64_t>;
using Judged = std::function<bool(std::uint32_t)>;

// Computes points, main truth and foreign points of every found plane.
std::vector<FoundPlane> describe_found(std::span<const LabelPair> pairs) {
  std::map<std::uint32_t, FoundPlane> planes;
  std::map<std::uint32_t, std::uint64_t> main_points;
  for (const LabelPair& pair : pairs) {
    if (pair.found == 0) continue;
    FoundPlane& plane = planes[pair.found];
    plane.id = pair.found;
    plane.points += pair.points;
    if (pair.truth == 0) continue;
    plane.foreign += pair.points;
    if (std::uint64_t& most = main_points[pair.found]; pair.points > most) {
      most = pair.points;
      plane.main_truth = pair.truth;
    }
  }
  std::vector<FoundPlane> found;
  for (auto& [id, plane] : planes) {
    if (plane.main_truth != 0) plane.foreign -= main_points[id];
    found.push_back(plane);
  }
  return found;
}

bool qualifies(const LabelPair& pair, const Totals& true_points, const Totals& found_points, MatchRule rule) {
  const std::uint64_t found = found_points.at(pair.found);
  if (rule == MatchRule::main) return 2 * pair.points > found;
  return 2 * pair.points >= true_points.at(pair.truth) + found - pair.points;
}

std::vector<PlaneMatch> match_one_to_one(std::span<const LabelPair> pairs, const Totals& true_points,
                                         const Totals& found_points, MatchRule rule) {
  std::vector<LabelPair> candidates;
  for (const LabelPair& pair : pairs)
    if (pair.found != 0 && true_points.contains(pair.truth) && qualifies(pair, true_points, found_points, rule))
      candidates.push_back(pair);
  std::sort(candidates.begin(), candidates.end(), [](const LabelPair& a, const LabelPair& b) {
    return std::tie(b.points, a.truth, a.found) < std::tie(a.points, b.truth, b.found);
  });
  std::set<std::uint32_t> taken_truth, taken_found;
  std::vector<PlaneMatch> matches;
  for (const LabelPair& pair : candidates) {
    if (taken_truth.contains(pair.truth) || taken_found.contains(pair.found)) continue;
    taken_truth.insert(pair.truth);
    taken_found.insert(pair.found);
    matches.push_back({pair.truth, pair.found, pair.points});
  }
  std::sort(matches.begin(), matches.end(), [](const auto& a, const auto& b) { return a.truth < b.truth; });
  return matches;
}

// Counts the found planes that contain most points of at least two true planes.
std::uint64_t count_under(std::span<const LabelPair> pairs, const Totals& true_points) {
  std::map<std::uint32_t, int> under_segmented;
  for (const LabelPair& pair : pairs)
    if (pair.found != 0 && true_points.contains(pair.truth) && 2 * pair.points > true_points.at(pair.truth))
      ++under_segmented[pair.found];
  return static_cast<std::uint64_t>(std::count_if(under_segmented.begin(), under_segmented.end(),
                                                  [](const auto& entry) { return entry.second > 1; }));
}

std::uint64_t count_over(std::span<const FoundPlane> found) {
  std::map<std::uint32_t, int> pieces;
  for (const FoundPlane& plane : found)
    if (plane.main_truth != 0) ++pieces[plane.main_truth];
  return static_cast<std::uint64_t>(
      std::count_if(pieces.begin(), pieces.end(), [](const auto& entry) { return entry.second > 1; }));
}

}  // namespace

std::vector<LabelPair> LabelPairs::sorted() const {
  std::vector<LabelPair> pairs;
  pairs.reserve(counts_.size());
  for (const auto& [key, points] : counts_)
    pairs.push_back({static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key), points});
  std::sort(pairs.begin(), pairs.end(),
            [](const auto& a, const auto& b) { return std::tie(a.truth, a.found) < std::tie(b.truth, b.found); });
  return pairs;
}

PlaneMatching match_planes(std::span<const LabelPair> pairs, const Judged& counts, MatchRule rule) {
  const Judged judged = [&](std::uint32_t truth) { return truth != 0 && (!counts || counts(truth)); };
  PlaneMatching result;
  Totals true_points, found_points;
  for (const LabelPair& pair : pairs)
    if (judged(pair.truth)) true_points[pair.truth] += pair.points;
  result.found = describe_found(pairs);
  for (const FoundPlane& plane : result.found) found_points[plane.id] = plane.points;
  std::erase_if(result.found, [&](const FoundPlane& plane) {
    return plane.main_truth == 0 ? static_cast<bool>(counts) : !judged(plane.main_truth);
  });
  result.matches = match_one_to_one(pairs, true_points, found_points, rule);
  result.true_planes = true_points.size();
  result.found_planes = result.found.size();
  result.missed = result.true_planes - result.matches.size();
  result.over = count_over(result.found);
  result.under = count_under(pairs, true_points);
  for (const auto& [id, points] : true_points) result.points += points;
  for (const PlaneMatch& match : result.matches) result.carrying += match.shared;
  return result;
}

PlaneMatching match_planes(std::span<const std::uint32_t> truth, std::span<const std::uint32_t> found) {
  LabelPairs pairs;
  for (std::size_t i = 0; i < std::min(truth.size(), found.size()); ++i) pairs.add(truth[i], found[i]);
  return match_planes(pairs.sorted());
}

}  // namespace ilot
