// SPDX-License-Identifier: Apache-2.0
// Thousands of inputs, few of them open: a process may open 1,024 files as a rule, and libraries and blocks of the
// store need some of these.
#pragma once
#include <cstddef>
#include <list>
#include <mutex>
#include <unordered_map>

namespace ilot {

class InputFile;

// Descriptors of InputFiles that were read last. Thread-safe.
class OpenFiles {
 public:
  explicit OpenFiles(std::size_t most) : most_(most) {}
  ~OpenFiles();
  OpenFiles(const OpenFiles&) = delete;
  OpenFiles& operator=(const OpenFiles&) = delete;

  // Keeps a file open while it is read. When more than `most` are open, the one that was not used for the longest time
  // is closed; those in use stay, so that more threads than `most` have more open.
  class Use {
   public:
    Use(OpenFiles& files, const InputFile& file);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    int descriptor() const { return descriptor_; }

   private:
    OpenFiles& files_;
    const InputFile& file_;
    int descriptor_;
  };

  // Closes the file; nobody uses it any more.
  void forget(const InputFile& file);

 private:
  struct Entry {
    const InputFile* file = nullptr;
    int descriptor = -1;
    int users = 0;
  };
  using Entries = std::list<Entry>;  // the one used last in front

  int take(const InputFile& file);
  void give_back(const InputFile& file);
  void close_unused();

  std::size_t most_;
  std::mutex mutex_;
  Entries entries_;
  std::unordered_map<const InputFile*, Entries::iterator> places_;
};

// The one of the process, since the limit is the process's.
OpenFiles& open_files();

}  // namespace ilot
