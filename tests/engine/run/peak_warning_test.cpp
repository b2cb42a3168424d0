// SPDX-License-Identifier: Apache-2.0
#include "engine/run/peak_warning.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

TEST(PeakWarning, SaysWhatIsEnoughWhereItWasTooLittle) {
  std::string said;
  ProgressOptions options;
  options.console = [&](std::string_view text) { said += text; };
  Progress progress(options);
  EXPECT_EQ(warn_of_peak(UINT64_MAX, progress), "");
  EXPECT_EQ(said, "");
  const std::string warning = warn_of_peak(std::uint64_t{1} << 20, progress);  // no process is smaller
  EXPECT_NE(warning.find("above --memory (1 MiB)"), std::string::npos);
  EXPECT_NE(said.find(warning), std::string::npos);
}

}  // namespace
}  // namespace ilot
