// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace ilot {

// A file that appears complete or not at all (like that of write_whole_file()), written piece by piece. No file is
// under `path` before finish(). Memory: a buffer of 64 KiB. Errors name the file.
class WholeFileWriter {
 public:
  explicit WholeFileWriter(std::filesystem::path path);
  ~WholeFileWriter();
  WholeFileWriter(const WholeFileWriter&) = delete;
  WholeFileWriter& operator=(const WholeFileWriter&) = delete;

  void append(std::string_view text);
  void finish();

 private:
  [[noreturn]] void fail();
  void flush();

  std::filesystem::path path_;
  std::string beside_, buffer_;
  int file_ = -1;
};

}  // namespace ilot
