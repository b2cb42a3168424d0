// SPDX-License-Identifier: Apache-2.0
// Files on web servers and in object stores, read by ranges and written whole through GDAL's virtual file systems.
// GDAL's settings hold for them, as environment variables (AWS_ACCESS_KEY_ID, GDAL_HTTP_TIMEOUT ...).
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace ilot {

// Whether the name is no file of this machine: http://, https://, s3://, gs://, az://, or GDAL's own names, /vsi...
bool is_remote(const std::filesystem::path& path);

// A remote file to read. Throws Error when it cannot be reached. Reads are thread-safe; each thread that reads at the
// same time has a connection of its own.
class RemoteFile {
 public:
  explicit RemoteFile(const std::filesystem::path& path);
  ~RemoteFile();
  RemoteFile(const RemoteFile&) = delete;
  RemoteFile& operator=(const RemoteFile&) = delete;

  std::uint64_t size() const { return size_; }
  std::int64_t modified() const { return modified_; }  // seconds since 1970; 0: not told

  // Fills `out`, which must lie within the file. Throws Error when the connection fails.
  void read_at(std::uint64_t offset, std::span<std::byte> out) const;

 private:
  void* take() const;
  void give_back(void* handle) const;

  std::string name_, virtual_name_;
  std::uint64_t size_ = 0;
  std::int64_t modified_ = 0;
  mutable std::mutex mutex_;
  mutable std::vector<void*> idle_;  // open handles that no thread uses
};

// Whether there is such a file. Throws Error where the server does not say so.
bool remote_exists(const std::filesystem::path& path);

// Whether files can be written there: to object stores, not to plain web servers.
bool is_writable_remote(const std::filesystem::path& path);

// Writes a file of this machine to a remote name, where it appears whole or not at all. Throws Error when the store
// does not take it.
void put_remote(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace ilot
