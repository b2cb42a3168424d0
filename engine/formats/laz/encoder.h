// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "engine/cloud/record.h"

#include "engine/formats/laz/bit_model.h"
#include "engine/formats/laz/models.h"

namespace ilot::laz {

// Writes an arithmetic stream of LAZ into its own buffer, which it keeps between streams.
class Encoder {
 public:
  static constexpr bool kEncodes = true;
  template <std::uint32_t kCapacity>
  using Model = SymbolModel<kCapacity, false>;

  void start(std::uint32_t epoch) {
    size_ = 0;
    base_ = 0;
    length_ = 0xFFFFFFFFu;
    epoch_ = epoch;
  }

  template <std::uint32_t kCapacity>
  std::uint32_t symbol(Model<kCapacity>& model, std::uint32_t s, std::uint32_t symbols = kCapacity) {
    model.prepare(epoch_, symbols);
    const std::uint32_t unit = length_ >> kSymbolShift;
    const std::uint32_t low = model.below(s) * unit;
    const std::uint32_t high = s == model.last_symbol() ? length_ : model.below(s + 1) * unit;
    narrow(low, high - low);
    model.count(s);
    return s;
  }

  std::uint32_t bit(BitModel& model, std::uint32_t b) {
    model.prepare(epoch_);
    const std::uint32_t split = model.zero_share() * (length_ >> kBitShift);
    narrow(b ? split : 0, b ? length_ - split : split);
    model.count(b);
    return b;
  }

  std::uint32_t raw(std::uint32_t k, std::uint32_t v) {
    if (k > 19) {
      few_bits(16, v & 0xFFFF);
      few_bits(k - 16, v >> 16);
    } else {
      few_bits(k, v);
    }
    return v;
  }

  // Ends the stream; the result is valid until the next start().
  std::span<const std::byte> finish() {
    const bool extra = length_ > 2 * kMinLength;
    narrow(extra ? kMinLength : kMinLength >> 1, extra ? kMinLength >> 1 : kMinLength >> 9);
    for (int zeros = extra ? 3 : 2; zeros > 0; --zeros) {
      make_room();
      out_[size_++] = 0;
    }
    return std::as_bytes(std::span(out_.get(), size_));
  }

 private:
  void few_bits(std::uint32_t k, std::uint32_t v) {
    const std::uint32_t unit = length_ >> k;
    narrow(v * unit, unit);
  }

  void narrow(std::uint32_t low, std::uint32_t length) {
    base_ += low;
    if (base_ < low) [[unlikely]]
      carry();
    // The upper bytes that no later step changes but by a carry go out: as many as keep the length above kMinLength.
    // All four are stored and so many of them counted, because a branch for each would often be mispredicted.
    assert(length > 0);
    static_assert(kMinLength == 1u << 24 && std::endian::native == std::endian::little);
    const auto bytes = static_cast<std::uint32_t>(std::countl_zero(length)) / 8;
    make_room();
    store(reinterpret_cast<std::byte*>(&out_[size_]), __builtin_bswap32(base_));
    size_ += bytes;
    base_ <<= 8 * bytes;
    length_ = length << 8 * bytes;
  }
  // Bytes behind the stream are not written to, so that they take no memory yet.
  void make_room() {
    constexpr std::size_t kFirst = 1024, kStored = 4;
    if (room_ >= size_ + kStored) [[likely]]
      return;
    room_ = std::max(kFirst, 2 * room_);
    auto larger = std::make_unique_for_overwrite<std::uint8_t[]>(room_);
    std::copy_n(out_.get(), size_, larger.get());
    out_ = std::move(larger);
  }
  // The sum of all bytes so far is below one, so there is a byte that takes the carry.
  void carry() {
    std::size_t i = size_ - 1;
    while (out_[i] == 0xFF) out_[i--] = 0;
    ++out_[i];
  }

  std::uint32_t base_ = 0, length_ = 0xFFFFFFFFu;
  std::uint32_t epoch_ = 0;
  std::unique_ptr<std::uint8_t[]> out_;  // only grows
  std::size_t room_ = 0, size_ = 0;      // bytes; of the stream
};

}  // namespace ilot::laz
