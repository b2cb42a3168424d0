// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/labels/reliability.h"

#include <algorithm>
#include <cmath>

namespace ilot {

Reliability reliability(std::span<const JudgedProbability> statements) {
  Reliability result;
  const double width = static_cast<double>(result.bins.size());
  for (const JudgedProbability& s : statements) {
    const double place = std::clamp(std::floor(s.probability * width), 0.0, width - 1);
    ReliabilityBin& bin = result.bins[static_cast<std::size_t>(place)];
    ++bin.count;
    bin.mean_probability += s.probability;
    bin.right += s.right;
  }
  result.count = statements.size();
  for (ReliabilityBin& bin : result.bins) {
    if (bin.count == 0) continue;
    result.calibration_error += std::abs(bin.right - bin.mean_probability) / static_cast<double>(result.count);
    bin.mean_probability /= static_cast<double>(bin.count);
    bin.right /= static_cast<double>(bin.count);
  }
  return result;
}

}  // namespace ilot
