// SPDX-License-Identifier: Apache-2.0
// Keeps only a few of thousands of inputs open. A process can usually open 1,024 files, and libraries and blocks of the
// store need some of these.
#pragma once
#include <cstddef>
#include <list>
#include <mutex>
#include <unordered_map>

namespace ilot {

class InputFile;

// The descriptors of the InputFiles that were read last. Thread-safe.
class OpenFiles {
 public:
  explicit OpenFiles(std::size_t most) : most_(most) {}
  ~OpenFiles();
  OpenFiles(const OpenFiles&) = delete;
  OpenFiles& operator=(const OpenFiles&) = delete;

  // Keeps a file open while it is read. When more than `most` files are open, the least recently used one is closed.
  // Files in use stay open, so more threads than `most` keep more files open.
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

  // Closes the file, which is no longer used.
  void forget(const InputFile& file);

 private:
  struct Entry {
    const InputFile* file = nullptr;
    int descriptor = -1;
    int users = 0;
  };
  using Entries = std::list<Entry>;  // the most recently used one is first

  int take(const InputFile& file);
  void give_back(const InputFile& file);
  void close_unused();

  std::size_t most_;
  std::mutex mutex_;
  Entries entries_;
  std::unordered_map<const InputFile*, Entries::iterator> places_;
};

// Returns the one instance of the process, because the limit is for the process.
OpenFiles& open_files();

}  // namespace ilot
