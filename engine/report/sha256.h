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
  std::string hex();  // 64 digits; ends the computation, call it once

 private:
  std::shared_ptr<void> context_;
};

// Returns the hash over product_files(folder, store) in their order: path, a zero byte, the size as 8 bytes
// little-endian, the content. Reads in pieces of 1 MiB. Throws Error when a file cannot be read.
std::string result_hash(const std::filesystem::path& folder, const std::filesystem::path& store = {});

}  // namespace ilot
