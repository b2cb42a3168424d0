// SPDX-License-Identifier: Apache-2.0
// The truth in records as most scenes write them: point format 7.
#pragma once
#include "scan/scanners/scan_record.h"

namespace ilot::scan {

inline RecordTruth truth_of(const std::byte* record) {
  static const RecordLayout layout = coloured_layout(0.001);
  return truth_of(record, layout);
}

}  // namespace ilot::scan
