// SPDX-License-Identifier: Apache-2.0
#include "engine/report/allowed_memory.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

class AllowedMemory : public testing::Test {
 protected:
  void write(const std::filesystem::path& name, const std::string& text) {
    std::filesystem::create_directories((folder_.path() / name).parent_path());
    std::ofstream(folder_.path() / name) << text;
  }
  std::uint64_t bytes() const { return allowed_memory_bytes(folder_.path() / "proc", folder_.path() / "groups"); }

  TemporaryFolder folder_;
};

TEST_F(AllowedMemory, OfThisMachine) {
  EXPECT_GT(allowed_memory_bytes(), 64u << 20);
  EXPECT_LT(allowed_memory_bytes(), UINT64_MAX);
}

TEST_F(AllowedMemory, NothingSays) {
  EXPECT_EQ(bytes(), UINT64_MAX);
}

TEST_F(AllowedMemory, OfTheMachine) {
  write("proc/meminfo", "MemTotal:        2048 kB\nMemFree:         1 kB\n");
  EXPECT_EQ(bytes(), 2048u * 1024);
  write("proc/self/cgroup", "0::/\n");
  write("groups/memory.max", "max\n");
  EXPECT_EQ(bytes(), 2048u * 1024);
}

TEST_F(AllowedMemory, OfAGroupOfVersion2AndItsParents) {
  write("proc/meminfo", "MemTotal:        9000 kB\n");
  write("proc/self/cgroup", "0::/user/job 7\n");
  write("groups/user/job 7/memory.max", "max\n");
  write("groups/user/memory.max", "4096000\n");
  EXPECT_EQ(bytes(), 4096000u);
  write("groups/user/job 7/memory.max", "1000\n");
  EXPECT_EQ(bytes(), 1000u);
}

TEST_F(AllowedMemory, OfAGroupOfVersion1) {
  write("proc/meminfo", "MemTotal:        9000 kB\n");
  write("proc/self/cgroup", "5:devices:/a\n4:cpu,memory:/a/b\n0::/\n");
  write("groups/memory/memory.limit_in_bytes", "9223372036854771712\n");
  write("groups/memory/a/b/memory.limit_in_bytes", "5000000\n");
  write("groups/devices/a/memory.limit_in_bytes", "3\n");
  EXPECT_EQ(bytes(), 5000000u);
}

TEST_F(AllowedMemory, OfAContainerThatSeesItsOwnGroupAsTheRoot) {
  write("proc/meminfo", "MemTotal:        9000 kB\n");
  write("proc/self/cgroup", "4:memory:/docker/0123\n");
  write("groups/memory/memory.limit_in_bytes", "700\n");
  EXPECT_EQ(bytes(), 700u);
}

}  // namespace
}  // namespace ilot
