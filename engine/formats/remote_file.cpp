// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/remote_file.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <cpl_vsi_error.h>

#include <array>
#include <mutex>
#include <utility>

#include "engine/error.h"
#include "engine/formats/file.h"

namespace ilot {
namespace {

// What users write, and GDAL's name for it.
constexpr std::array<std::pair<const char*, const char*>, 5> kSchemes{{{"http://", "/vsicurl/http://"},
                                                                       {"https://", "/vsicurl/https://"},
                                                                       {"s3://", "/vsis3/"},
                                                                       {"gs://", "/vsigs/"},
                                                                       {"az://", "/vsiaz/"}}};
constexpr const char* kOwnNames = "/vsi";

std::string virtual_name_of(const std::string& name) {
  for (const auto& [scheme, own] : kSchemes)
    if (name.starts_with(scheme)) return own + name.substr(std::string(scheme).size());
  return name;
}

// GDAL lists the folder of a file unless it is told not to, and gives up at the first fault.
void set_defaults() {
  constexpr std::array<std::pair<const char*, const char*>, 3> kDefaults{
      {{"GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR"}, {"GDAL_HTTP_MAX_RETRY", "3"}, {"GDAL_HTTP_RETRY_DELAY", "1"}}};
  for (const auto& [key, value] : kDefaults)
    if (CPLGetConfigOption(key, nullptr) == nullptr) CPLSetConfigOption(key, value);
}

// Derived: GDAL reads small pieces in pages of 16 KiB and keeps them, and reads ahead of pieces that follow each other.
// Chunks of points are larger, and the next one is often not needed.
constexpr std::size_t kLarge = 16 << 10;

// Asks for these bytes alone, once. GDAL reads ahead for a list of one range, and not for two, which it joins.
bool read_exactly(VSILFILE* file, std::uint64_t offset, std::span<std::byte> out) {
  const std::array<std::size_t, 2> sizes{out.size() / 2, out.size() - out.size() / 2};
  std::array<void*, 2> halves{out.data(), out.data() + sizes[0]};
  const std::array<vsi_l_offset, 2> offsets{offset, offset + sizes[0]};
  return VSIFReadMultiRangeL(2, halves.data(), offsets.data(), sizes.data(), file) == 0;
}

// Asks again when the server fails.
bool read_ahead(VSILFILE* file, std::uint64_t offset, std::span<std::byte> out) {
  return VSIFSeekL(file, offset, SEEK_SET) == 0 && VSIFReadL(out.data(), 1, out.size(), file) == out.size();
}

void use_gdal() {
  static std::once_flag once;
  std::call_once(once, set_defaults);
  CPLErrorReset();
}

[[noreturn]] void fail(const std::string& name, const std::string& what) {
  const std::string reason = CPLGetLastErrorMsg();
  throw Error(name + ": " + what + (reason.empty() ? "" : ": " + reason) +
              "; check the address, the rights and the network");
}

}  // namespace

bool is_remote(const std::filesystem::path& path) {
  const std::string& name = path.native();
  if (name.starts_with(kOwnNames)) return true;
  for (const auto& scheme : kSchemes)
    if (name.starts_with(scheme.first)) return true;
  return false;
}

RemoteFile::RemoteFile(const std::filesystem::path& path)
    : name_(path.string()), virtual_name_(virtual_name_of(name_)) {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  use_gdal();
  VSIStatBufL status{};
  if (VSIStatExL(virtual_name_.c_str(), &status,
                 VSI_STAT_EXISTS_FLAG | VSI_STAT_NATURE_FLAG | VSI_STAT_SIZE_FLAG | VSI_STAT_SET_ERROR_FLAG) != 0 ||
      VSI_ISDIR(status.st_mode))
    fail(name_, "cannot be opened");
  size_ = static_cast<std::uint64_t>(status.st_size);
  modified_ = status.st_mtime;
}

RemoteFile::~RemoteFile() {
  for (void* handle : idle_) VSIFCloseL(static_cast<VSILFILE*>(handle));
}

void* RemoteFile::take() const {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      void* handle = idle_.back();
      idle_.pop_back();
      return handle;
    }
  }
  void* handle = VSIFOpenL(virtual_name_.c_str(), "rb");
  if (handle == nullptr) fail(name_, "cannot be opened");
  return handle;
}

void RemoteFile::give_back(void* handle) const {
  const std::lock_guard lock(mutex_);
  idle_.push_back(handle);
}

void RemoteFile::read_at(std::uint64_t offset, std::span<std::byte> out) const {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  CPLErrorReset();
  void* const handle = take();
  auto* const file = static_cast<VSILFILE*>(handle);
  const bool whole = (out.size() >= kLarge && read_exactly(file, offset, out)) || read_ahead(file, offset, out);
  give_back(handle);
  if (!whole) fail(name_, "cannot be read at byte " + std::to_string(offset));
}

bool remote_exists(const std::filesystem::path& path) {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  use_gdal();
  VSIErrorReset();
  VSIStatBufL status{};
  if (VSIStatExL(virtual_name_of(path.string()).c_str(), &status,
                 VSI_STAT_EXISTS_FLAG | VSI_STAT_NATURE_FLAG | VSI_STAT_SET_ERROR_FLAG) == 0)
    return !VSI_ISDIR(status.st_mode);
  const std::string reason = VSIGetLastErrorMsg();
  if (VSIGetLastErrorNo() == VSIE_AWSObjectNotFound || reason.ends_with("404")) return false;
  throw Error(path.string() + ": cannot be found: " + reason + "; check the address, the rights and the network");
}

bool is_writable_remote(const std::filesystem::path& path) {
  return is_remote(path) && !virtual_name_of(path.string()).starts_with("/vsicurl/");
}

void put_remote(const std::filesystem::path& from, const std::filesystem::path& to) {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  use_gdal();
  const InputFile file(from);
  const std::string virtual_name = virtual_name_of(to.string());
  VSILFILE* const out = VSIFOpenL(virtual_name.c_str(), "wb");
  if (out == nullptr) fail(to.string(), "cannot be written");
  std::vector<std::byte> bytes(std::size_t{1} << 20);
  bool taken = true;
  for (std::uint64_t at = 0; taken && at < file.size();) {
    const std::size_t got = file.read_at(at, bytes);
    taken = got > 0 && VSIFWriteL(bytes.data(), 1, got, out) == got;
    at += got;
  }
  const bool read = taken;
  taken = VSIFCloseL(out) == 0 && taken && CPLGetLastErrorType() != CE_Failure;
  if (!read) VSIUnlink(virtual_name.c_str());  // closing has sent what there was
  if (!taken) fail(to.string(), "cannot be written");
}

}  // namespace ilot
