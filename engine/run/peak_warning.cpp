// SPDX-License-Identifier: Apache-2.0
#include "engine/run/peak_warning.h"

#include "engine/report/resources.h"

namespace ilot {

std::string warn_of_peak(std::uint64_t memory_bytes, Progress& progress) {
  const std::uint64_t peak = peak_resident_bytes();
  if (peak <= memory_bytes) return "";
  const auto mebibytes = [](std::uint64_t bytes) { return std::to_string((bytes + (1u << 20) - 1) >> 20) + " MiB"; };
  std::string warning = "the peak of memory was " + mebibytes(peak) + ", above --memory (" + mebibytes(memory_bytes) +
                        "); docs/limits.md names the steps that can do this";
  progress.warn(warning);
  return warning;
}

}  // namespace ilot
