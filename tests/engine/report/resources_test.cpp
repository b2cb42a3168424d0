// SPDX-License-Identifier: Apache-2.0
#include "engine/report/resources.h"

#include <gtest/gtest.h>

#include <vector>

namespace ilot {
namespace {

TEST(Resources, MemoryIsCounted) {
  const std::uint64_t before = resident_bytes();
  EXPECT_GT(before, 1u << 20);
  std::vector<char> held(64u << 20, 1);
  EXPECT_GT(resident_bytes(), before + (32u << 20));
  EXPECT_GE(peak_resident_bytes(), before);
  EXPECT_EQ(held[5], 1);
}

TEST(Resources, CpuTimeGrows) {
  const double before = cpu_seconds();
  volatile double sum = 0;
  while (cpu_seconds() < before + 0.01) sum = sum + 1;
  EXPECT_GT(cpu_seconds(), before);
}

TEST(Resources, DiskOfAFolderThatDoesNotExistYet) {
  EXPECT_GT(free_disk_bytes("/tmp/none/such/folder"), 0u);
  EXPECT_GT(free_disk_bytes("relative/none"), 0u);
}

}  // namespace
}  // namespace ilot
