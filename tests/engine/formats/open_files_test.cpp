// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/open_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <thread>

#include "engine/error.h"
#include "engine/formats/file.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

std::size_t open_descriptors() {
  const fs::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

class OpenFilesTest : public testing::Test {
 protected:
  fs::path write(int i) {
    const fs::path path = folder_.path() / std::to_string(i);
    std::ofstream(path) << "content " << i;
    return path;
  }
  static std::string read(const InputFile& file) {
    std::string text(file.size(), '\0');
    text.resize(file.read_at(0, std::as_writable_bytes(std::span(text))));
    return text;
  }

  TemporaryFolder folder_;
};

TEST_F(OpenFilesTest, ThoseUsedLastStayOpen) {
  const InputFile a(write(1)), b(write(2)), c(write(3));
  OpenFiles files(2);
  const std::size_t before = open_descriptors();
  { const OpenFiles::Use first(files, a), second(files, b); }
  EXPECT_EQ(open_descriptors(), before + 2);
  const int of_a = OpenFiles::Use(files, a).descriptor();
  { const OpenFiles::Use third(files, c); }  // b goes
  EXPECT_EQ(open_descriptors(), before + 2);
  EXPECT_EQ(OpenFiles::Use(files, a).descriptor(), of_a);
  files.forget(c);
  files.forget(b);
  EXPECT_EQ(open_descriptors(), before + 1);
  files.forget(a);
}

TEST_F(OpenFilesTest, ThoseInUseStay) {
  const InputFile a(write(1)), b(write(2)), c(write(3));
  OpenFiles files(1);
  const std::size_t before = open_descriptors();
  {
    const OpenFiles::Use first(files, a), second(files, b), third(files, c);
    EXPECT_EQ(open_descriptors(), before + 3);
    EXPECT_NE(first.descriptor(), third.descriptor());
  }
  for (const InputFile* file : {&a, &b, &c}) files.forget(*file);
  EXPECT_EQ(open_descriptors(), before);
}

TEST_F(OpenFilesTest, ManyFilesAreReadByManyThreads) {
  constexpr int kFiles = 300;
  std::vector<std::unique_ptr<InputFile>> files;
  for (int i = 0; i < kFiles; ++i) files.push_back(std::make_unique<InputFile>(write(i)));
  const std::size_t before = open_descriptors();
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 2 * kFiles; ++i) {
        const int n = (i * 7 + t * 31) % kFiles;
        EXPECT_EQ(read(*files[static_cast<std::size_t>(n)]), "content " + std::to_string(n));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_LT(open_descriptors(), before + 80);
  files.clear();
  EXPECT_LE(open_descriptors(), before);
}

TEST_F(OpenFilesTest, AnotherFileOfTheNameIsRefused) {
  const fs::path path = write(1);
  const InputFile file(path);
  EXPECT_EQ(read(file), "content 1");
  std::ofstream(folder_.path() / "other") << "content 2";
  fs::rename(folder_.path() / "other", path);
  EXPECT_EQ(read(file), "content 1") << "it is open still";
  EXPECT_THROW(file.reopen(), Error);
}

TEST_F(OpenFilesTest, OneThatGrowsIsReadAsItWasAndOneThatShrinksIsRefused) {
  const fs::path path = write(1);
  const InputFile file(path);
  std::ofstream(path, std::ios::app) << " and more";
  EXPECT_EQ(read(file), "content 1");
  open_files().forget(file);
  fs::resize_file(path, 3);
  EXPECT_THROW(read(file), Error);
}

}  // namespace
}  // namespace ilot
