// SPDX-License-Identifier: Apache-2.0
// SHA-256 of bytes and of the products of a run.
#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace ilot {

class Sha256 {
 public:
  Sha256();
  void update(std::span<const std::byte> bytes);
  std::string hex();  // 64 digits; ends the sum, call once

 private:
  std::shared_ptr<void> context_;
};

// Over all regular files below `folder` in the order of their relative paths (bytes, `/` between parts):
// path, a zero byte, the size as 8 bytes little-endian, the content. Left out: run.json, report.html and what
// begins with a dot, each directly below `folder`, and the folder `store` when it stands inside. Reads in
// pieces of 1 MiB. Error when a file cannot be read.
std::string result_hash(const std::filesystem::path& folder, const std::filesystem::path& store = {});

}  // namespace ilot
