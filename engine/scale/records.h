// SPDX-License-Identifier: Apache-2.0
// Files of records: a head, any number of records, and an end that proves that the file is whole. Each is a JSON value
// in CBOR, which keeps all bits of numbers. Sites of a plan and parts of a result are such files.
#pragma once
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "engine/formats/file.h"
#include "engine/report/sha256.h"
#include "engine/whole_file_writer.h"

namespace ilot {

class RecordFileWriter {
 public:
  RecordFileWriter(const std::filesystem::path& path, const nlohmann::json& head);
  void add(const nlohmann::json& record);
  // Writes the end; the file appears under its name. Returns the sum over all that stands before the end.
  std::string finish();

 private:
  void put(const nlohmann::json& value);

  WholeFileWriter file_;
  Sha256 sum_;
  std::uint64_t records_ = 0;
};

// Reads a file of records, remote or not, front to back. Any number of readers can work at a time (InputFile). Throws
// Error for a file that is damaged or not whole, at the latest at its end.
class RecordFileReader {
 public:
  explicit RecordFileReader(const std::filesystem::path& path, std::size_t buffer = 1u << 20);
  const nlohmann::json& head() const { return head_; }
  std::optional<nlohmann::json> next();
  // Of a file that was read to its end: the sum that finish() returned.
  const std::string& sum() const { return told_; }

 private:
  [[noreturn]] void damaged(const std::string& how) const;
  std::string take(std::size_t bytes);
  nlohmann::json value();

  InputFile file_;
  std::size_t size_, used_ = 0;
  std::uint64_t offset_ = 0, records_ = 0;
  std::string buffer_, told_;
  Sha256 sum_;
  nlohmann::json head_;
};

}  // namespace ilot
