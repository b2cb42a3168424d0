// SPDX-License-Identifier: Apache-2.0
#include "engine/store/column_cache.h"

#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace ilot {
namespace {

std::atomic<std::uint64_t> allowed_bytes{0}, kept_bytes{0};

struct KeptFile {
  std::shared_ptr<const KeptBytes> bytes;
  std::uint64_t last_use = 0;
};

// The kept files by path.
class KeptFiles {
 public:
  void add(const std::string& path, std::shared_ptr<const KeptBytes> bytes) {
    const std::lock_guard lock(mutex_);
    files_[path] = {std::move(bytes), ++uses_};
  }

  std::shared_ptr<const KeptBytes> find(const std::string& path) {
    const std::lock_guard lock(mutex_);
    const auto found = files_.find(path);
    if (found == files_.end()) return nullptr;
    found->second.last_use = ++uses_;
    return found->second.bytes;
  }

  void erase(const std::string& path) {
    const std::lock_guard lock(mutex_);
    files_.erase(path);
  }

  void erase_all(const std::string& begin) {
    const std::lock_guard lock(mutex_);
    auto file = files_.lower_bound(begin);
    while (file != files_.end() && file->first.starts_with(begin)) file = files_.erase(file);
  }

  void shrink(std::uint64_t bytes) {
    const std::lock_guard lock(mutex_);
    std::vector<std::map<std::string, KeptFile>::iterator> oldest;
    for (auto file = files_.begin(); file != files_.end(); ++file) oldest.push_back(file);
    std::sort(oldest.begin(), oldest.end(),
              [](const auto& a, const auto& b) { return a->second.last_use < b->second.last_use; });
    std::uint64_t freed = 0;
    for (std::size_t i = 0; i < oldest.size() && freed < bytes; ++i) {
      freed += oldest[i]->second.bytes->bytes().size();
      files_.erase(oldest[i]);
    }
  }

 private:
  std::mutex mutex_;
  std::map<std::string, KeptFile> files_;
  std::uint64_t uses_ = 0;
};

KeptFiles& kept_files() {
  static KeptFiles files;
  return files;
}

}  // namespace

void set_column_cache(std::uint64_t most_bytes) {
  allowed_bytes = most_bytes;
  const std::uint64_t now = kept_bytes;
  if (now > most_bytes) kept_files().shrink(now - most_bytes);
}

std::uint64_t column_cache_bytes() {
  return kept_bytes;
}

void forget_folder(const std::filesystem::path& folder) {
  if (kept_bytes != 0) kept_files().erase_all((folder / "").native());
}

void forget_file(const std::filesystem::path& path) {
  if (kept_bytes != 0) kept_files().erase(path.native());
}

KeptBytes::KeptBytes(std::uint32_t type, std::size_t bytes) : type_(type) {
  if (bytes == 0 || allowed_bytes == 0) return;
  if (kept_bytes.fetch_add(bytes) + bytes <= allowed_bytes) {
    void* const data = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (data != MAP_FAILED) {
      data_ = static_cast<std::byte*>(data);
      size_ = bytes;
      return;
    }
  }
  kept_bytes -= bytes;
}

KeptBytes::~KeptBytes() {
  if (data_ == nullptr) return;
  ::munmap(data_, size_);
  kept_bytes -= size_;
}

std::shared_ptr<const KeptBytes> keep_file(const std::filesystem::path& path, KeptBytes bytes) {
  auto kept = std::make_shared<const KeptBytes>(std::move(bytes));
  kept_files().add(path.native(), kept);
  return kept;
}

std::shared_ptr<const KeptBytes> kept_file(const std::filesystem::path& path) {
  return kept_bytes == 0 ? nullptr : kept_files().find(path.native());
}

}  // namespace ilot
