// SPDX-License-Identifier: Apache-2.0
#include "engine/run/folder_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

class FolderLockTest : public testing::Test {
 protected:
  fs::path folder() const { return holder_.path() / "a" / "out"; }
  fs::path file() const { return folder() / kLockFile; }

  TemporaryFolder holder_;
};

TEST_F(FolderLockTest, NothingStays) {
  {
    const FolderLock lock(folder(), "");
    EXPECT_TRUE(lock.works());
    EXPECT_TRUE(fs::exists(file()));
  }
  EXPECT_TRUE(fs::is_empty(holder_.path())) << "folders that were made are empty, so they go too";
}

TEST_F(FolderLockTest, AFolderWithContentStaysAndSoDoesOneThatWasThere) {
  {
    const FolderLock lock(folder(), "");
    std::ofstream(folder() / "result") << "1";
  }
  EXPECT_FALSE(fs::exists(file()));
  fs::remove(folder() / "result");
  { const FolderLock lock(folder(), ""); }
  EXPECT_TRUE(fs::is_empty(folder()));
  {
    FolderLock lock(folder(), "");
    lock.remove_empty_folder();
  }
  EXPECT_FALSE(fs::exists(folder()));
}

TEST_F(FolderLockTest, TheSecondIsGivenTheHolder) {
  const FolderLock first(folder(), "");
  try {
    const FolderLock second(folder(), "or give another -o");
    FAIL() << "two locks";
  } catch (const Error& fault) {
    EXPECT_EQ(fault.code(), ExitCode::usage);
    const std::string text = fault.what();
    EXPECT_NE(text.find("process " + std::to_string(getpid()) + " on "), std::string::npos) << text;
    EXPECT_NE(text.find(" since 2"), std::string::npos) << text;
    EXPECT_NE(text.find("or give another -o"), std::string::npos) << text;
  }
  EXPECT_TRUE(folder_holder(folder()).has_value());
  EXPECT_TRUE(fs::exists(file())) << "the first one's file stays";
}

TEST_F(FolderLockTest, AKilledProcessLeavesTheFileButNoLock) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    const FolderLock lock(folder(), "");
    if (write(ready[1], "x", 1) == 1) pause();
    _exit(1);
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_THROW(FolderLock(folder(), ""), Error);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(file()));
  EXPECT_FALSE(folder_holder(folder()).has_value());
  const FolderLock again(folder(), "");
  std::stringstream text;
  text << std::ifstream(file()).rdbuf();
  EXPECT_NE(text.str().find("process " + std::to_string(getpid()) + " "), std::string::npos);
  close(ready[0]);
  close(ready[1]);
}

TEST_F(FolderLockTest, OneAtATimeWhateverTheMoment) {
  std::atomic<int> inside = 0, most = 0, taken = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 200; ++i) {
        try {
          const FolderLock lock(folder(), "");
          most = std::max(most.load(), ++inside);
          ++taken;
          --inside;
        } catch (const Error& fault) {
          EXPECT_EQ(fault.code(), ExitCode::usage) << fault.what();
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(most, 1);
  EXPECT_GT(taken, 0);
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(FolderLockTest, WhereNoFolderCanBe) {
  std::ofstream(holder_.path() / "a") << "a file";
  EXPECT_THROW(FolderLock(folder(), ""), Error);
}

}  // namespace
}  // namespace ilot
