// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/rays/registration_error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace ilot {
namespace {

// Choice: registration by targets is good to some 2 mm, from cloud to cloud to 5 to 10 mm and 0.01 degrees; a scan
// without any error has stated errors that are too large.
constexpr double kUsual = 0.005;  // metres: standard deviation where the cloud itself says nothing
// Choice: two measurements between scans outweigh what is usual.
constexpr double kUsualWeight = 2;  // measurements that this counts for
// Choice: walls bow by less than a millimetre in that.
constexpr double kCell = 0.7;         // metres
constexpr std::uint64_t kFewest = 8;  // points of a station in a cell
// Derived: 95 % of normal errors are within two standard deviations.
constexpr double kBound = 2;

struct Sum {
  double w = 0;
  std::uint64_t count = 0;
};

}  // namespace

double registration_error(const RaySamples& samples) {
  if (!samples.oblique()) return 0;
  const auto stations = samples.site().stations.size();
  // Each cell and station; the order of the keys is that of the sums below.
  std::map<std::pair<std::int64_t, SiteStation>, Sum> sums;
  for (const Ray& ray : samples.all()) {
    if (stations < 2) break;
    if (!samples.on_wall(ray) || samples.eye_of(ray) == nullptr) continue;
    const auto column = static_cast<std::int64_t>(std::floor(static_cast<double>(ray.at.u) / kCell));
    const auto row = static_cast<std::int64_t>(std::floor(static_cast<double>(ray.at.v) / kCell));
    Sum& sum = sums[{row * (1 << 20) + column, ray.station}];
    sum.w += static_cast<double>(ray.at.w), ++sum.count;
  }
  double squares = 0, freedom = 0;
  std::map<SiteStation, std::uint64_t> compared;
  for (auto first = sums.begin(); first != sums.end();) {
    auto end = first;
    std::vector<double> means;
    for (; end != sums.end() && end->first.first == first->first.first; ++end)
      if (end->second.count >= kFewest) means.push_back(end->second.w / static_cast<double>(end->second.count));
    if (means.size() > 1) {
      double mean = 0;
      for (const double m : means) mean += m / static_cast<double>(means.size());
      for (const double m : means) squares += (m - mean) * (m - mean);
      freedom += static_cast<double>(means.size() - 1);
      for (auto at = first; at != end; ++at)
        if (at->second.count >= kFewest) ++compared[at->first.second];
    }
    first = end;
  }
  const double others = compared.empty() ? 0 : static_cast<double>(compared.size() - 1);
  const double measured = freedom > 0 ? squares / freedom : 0;
  return kBound * std::sqrt((kUsualWeight * kUsual * kUsual + others * measured) / (kUsualWeight + others));
}

}  // namespace ilot
