// SPDX-License-Identifier: Apache-2.0
#include "study/pooled_samples.h"

namespace ilot {

std::vector<TrainingSample> pooled(const std::vector<std::vector<TrainingSample>>& streets, std::size_t different,
                                   bool streets_whole) {
  std::vector<TrainingSample> all;
  for (std::size_t s = 0; s < streets.size(); ++s) {
    const auto before = static_cast<std::uint32_t>(all.size());
    for (TrainingSample sample : streets[s]) {
      sample.group = streets_whole ? static_cast<std::uint32_t>(s % different)
                                   : sample.group + static_cast<std::uint32_t>(1000 * (s % different));
      for (std::uint32_t& part : sample.parts) part += part != 0 ? before : 0;
      all.push_back(sample);
    }
  }
  return all;
}

std::vector<TrainingSample> samples_of(std::span<const Street> streets, std::span<const Street> others,
                                       std::size_t different) {
  std::vector<std::vector<TrainingSample>> lists;
  for (const auto& kind : {streets, others})
    for (const Street& street : kind) lists.push_back(street.samples);
  return pooled(lists, different, different >= kManyStreets);
}

}  // namespace ilot
