// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/e57/pages.h"

#include <algorithm>
#include <array>
#include <bit>

#include "engine/cloud/record.h"

namespace ilot::e57 {
namespace {

constexpr std::size_t kWindow = std::size_t{128} << 10;
constexpr std::uint32_t kPolynomial = 0x82F63B78;

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t c = i;
    for (int k = 0; k < 8; ++k) c = c >> 1 ^ (c & 1 ? kPolynomial : 0);
    tables[0][i] = c;
  }
  for (std::size_t t = 1; t < 8; ++t)
    for (std::size_t i = 0; i < 256; ++i) tables[t][i] = tables[t - 1][i] >> 8 ^ tables[0][tables[t - 1][i] & 255];
  return tables;
}

constexpr Tables kTables = make_tables();

}  // namespace

std::uint32_t crc32c(std::span<const std::byte> bytes) {
  std::uint32_t c = 0xFFFFFFFF;
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    const std::uint64_t v = load<std::uint64_t>(&bytes[i]) ^ c;
    c = 0;
    for (std::size_t k = 0; k < 8; ++k) c ^= kTables[7 - k][v >> (8 * k) & 255];
  }
  for (; i < bytes.size(); ++i) c = c >> 8 ^ kTables[0][(c ^ std::to_integer<std::uint32_t>(bytes[i])) & 255];
  return ~c;
}

Pages::Pages(const InputFile& file, std::size_t page_size)
    : file_(&file), page_size_(page_size), payload_(page_size - kChecksum), pages_(file.size() / page_size) {}

std::optional<std::uint64_t> Pages::logical(std::uint64_t physical) const {
  const std::uint64_t page = physical / page_size_, within = physical % page_size_;
  if (page >= pages_ || within >= payload_) return std::nullopt;
  return page * payload_ + within;
}

bool Pages::read(std::uint64_t offset, std::span<std::byte> out) {
  while (!out.empty()) {
    const std::uint64_t page = offset / payload_;
    const auto within = static_cast<std::size_t>(offset % payload_);
    if ((page < first_ || page - first_ >= count_) && !fill(page)) return false;
    const std::size_t part = std::min(out.size(), payload_ - within);
    std::copy_n(&window_[static_cast<std::size_t>(page - first_) * page_size_ + within], part, out.begin());
    out = out.subspan(part);
    offset += part;
  }
  return true;
}

void Pages::release() {
  count_ = 0;
  std::vector<std::byte>().swap(window_);
}

// The window from `page` on ends before the first damaged page.
bool Pages::fill(std::uint64_t page) {
  first_ = failed_ = page;
  count_ = 0;
  if (page >= pages_) return false;
  const std::uint64_t wanted = std::min<std::uint64_t>(pages_ - page, kWindow / page_size_);
  window_.resize(static_cast<std::size_t>(wanted) * page_size_);
  const std::uint64_t got = file_->read_at(page * page_size_, window_) / page_size_;
  while (count_ < got) {
    const std::byte* begin = &window_[static_cast<std::size_t>(count_) * page_size_];
    if (__builtin_bswap32(load<std::uint32_t>(begin + payload_)) != crc32c({begin, payload_})) break;
    ++count_;
  }
  return count_ > 0;
}

}  // namespace ilot::e57
