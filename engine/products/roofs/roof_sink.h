// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>

#include "engine/deliverables/solids/roof_files.h"
#include "engine/products/roofs/site_modeller.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"

namespace ilot {

// Takes results in the order of ids, and numbers, writes and counts them.
class RoofSink {
 public:
  // `labels` takes the labels of points; nullptr where there are none, because tasks have left them in their stores.
  RoofSink(const std::filesystem::path& folder, const RoofFilesParams& params, const Crs& crs, RoofLabels* labels,
           RunRecord& record);

  void take(SiteResult& result);
  void finish();

 private:
  void count(const SiteResult& result);

  RoofFiles files_;
  RoofLabels* labels_;
  RunRecord& record_;
  std::uint32_t units_ = 0, planes_ = 0;
};

}  // namespace ilot
