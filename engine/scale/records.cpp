// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/records.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "engine/error.h"

namespace ilot {
namespace {

using nlohmann::json;

constexpr std::size_t kLengthBytes = 8;
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;  // Choice: of a record; a longer one is a damaged length

std::string length_text(std::uint64_t length) {
  std::string text;
  for (std::size_t i = 0; i < kLengthBytes; ++i) text += static_cast<char>(length >> 8 * i & 255);
  return text;
}

std::uint64_t length_of(const std::string& text) {
  std::uint64_t length = 0;
  for (std::size_t i = 0; i < kLengthBytes; ++i) length |= std::uint64_t{static_cast<unsigned char>(text[i])} << 8 * i;
  return length;
}

}  // namespace

RecordFileWriter::RecordFileWriter(const std::filesystem::path& path, const json& head) : file_(path) {
  put(head);
}

void RecordFileWriter::put(const json& value) {
  std::string bytes;
  json::to_cbor(value, bytes);
  bytes.insert(0, length_text(bytes.size()));
  sum_.update(std::as_bytes(std::span(bytes)));
  file_.append(bytes);
}

void RecordFileWriter::add(const json& record) {
  put({{"record", record}});
  ++records_;
}

std::string RecordFileWriter::finish() {
  std::string sum = sum_.hex(), bytes;
  json::to_cbor({{"records", records_}, {"sum", sum}}, bytes);
  file_.append(length_text(bytes.size()) + bytes);
  file_.finish();
  return sum;
}

RecordFileReader::RecordFileReader(const std::filesystem::path& path, std::size_t buffer) : file_(path), size_(buffer) {
  head_ = value();
  if (!head_.is_object()) damaged("it does not begin as such a file does");
}

void RecordFileReader::damaged(const std::string& how) const {
  throw Error(file_.path().string() + ": is damaged: " + how + "; remove it and make it again");
}

std::string RecordFileReader::take(std::size_t bytes) {
  if (buffer_.size() - used_ < bytes) {
    buffer_.erase(0, std::exchange(used_, 0));
    const std::size_t have = buffer_.size();
    buffer_.resize(std::max(bytes, size_));
    const std::size_t got = file_.read_at(offset_, std::as_writable_bytes(std::span(buffer_)).subspan(have));
    offset_ += got;
    buffer_.resize(have + got);
    if (buffer_.size() < bytes) damaged("it ends too early");
  }
  used_ += bytes;
  return buffer_.substr(used_ - bytes, bytes);
}

json RecordFileReader::value() {
  const std::string length = take(kLengthBytes);
  if (length_of(length) > kMostBytes) damaged("a length is impossible");
  const std::string bytes = take(length_of(length));
  json value = json::from_cbor(bytes, true, false);
  if (value.is_discarded()) damaged("a record cannot be read");
  if (value.is_object() && value.contains("sum") && value.contains("records")) return value;
  sum_.update(std::as_bytes(std::span(length)));
  sum_.update(std::as_bytes(std::span(bytes)));
  return value;
}

std::optional<json> RecordFileReader::next() {
  if (!told_.empty()) return std::nullopt;
  json read = value();
  if (!read.is_object()) damaged("a record cannot be read");
  if (const auto record = read.find("record"); record != read.end()) {
    ++records_;
    return std::move(*record);
  }
  told_ = read.value("sum", "");
  if (told_ != sum_.hex() || read.value("records", std::uint64_t{0}) != records_) damaged("its sum is another");
  return std::nullopt;
}

}  // namespace ilot
