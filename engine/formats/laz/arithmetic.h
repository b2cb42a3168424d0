// SPDX-License-Identifier: Apache-2.0
// The 32-bit range coder of LAZ, both ways with one interface: a codec written once against `Coder` encodes the value
// it hands over, or ignores it and receives the decoded one. Memory only; nothing here allocates on decoding or throws.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "engine/formats/laz/models.h"

namespace ilot::laz {

constexpr std::uint32_t kMinLength = 0x01000000;

class Decoder {
 public:
  static constexpr bool kEncodes = false;
  template <std::uint32_t kCapacity>
  using Model = SymbolModel<kCapacity, true>;

  // Streams lie inside `memory`, which bounds every read; `stream` is where this one is said to lie. Bytes behind the
  // stream but inside memory are read without complaint, which overrun() tells; bytes behind memory are read as zero.
  void start(std::span<const std::byte> memory, std::span<const std::byte> stream, std::uint32_t epoch) {
    begin_ = at_ = reinterpret_cast<const std::uint8_t*>(stream.data());
    stream_end_ = begin_ + stream.size();
    memory_end_ = reinterpret_cast<const std::uint8_t*>(memory.data()) + memory.size();
    missing_ = 0;
    epoch_ = epoch;
    length_ = 0xFFFFFFFFu;
    value_ = next_four();
    corrupt_ = value_ >= length_;
    if (corrupt_) value_ = 0;  // value_ < length_ always: it bounds every table index below
    skip(4);
  }

  // Bytes that the symbols so far have used up; more than the stream's size when it is damaged.
  std::size_t consumed() const { return static_cast<std::size_t>(at_ - begin_) + missing_; }
  bool overrun() const { return at_ > stream_end_ || missing_ != 0 || corrupt_; }

  template <std::uint32_t kCapacity>
  [[gnu::always_inline]] std::uint32_t symbol(Model<kCapacity>& model, std::uint32_t = 0,
                                               std::uint32_t symbols = kCapacity) {
    model.prepare(epoch_, symbols);
    const std::uint32_t unit = length_ >> kSymbolShift;
    const std::uint32_t s = model.find(value_ / unit);
    const std::uint32_t low = model.below(s) * unit;
    const std::uint32_t high = s == model.last_symbol() ? length_ : model.below(s + 1) * unit;
    value_ -= low;
    length_ = high - low;
    renormalise();
    model.count(s);
    return s;
  }

  [[gnu::always_inline]] std::uint32_t bit(BitModel& model, std::uint32_t = 0) {
    model.prepare(epoch_);
    const std::uint32_t split = model.zero_share() * (length_ >> kBitShift);
    const std::uint32_t b = value_ >= split;
    value_ -= b ? split : 0;
    length_ = b ? length_ - split : split;
    renormalise();
    model.count(b);
    return b;
  }

  // k equally likely bits, 1 <= k <= 32.
  std::uint32_t raw(std::uint32_t k, std::uint32_t = 0) {
    if (k <= 19) return few_bits(k);
    const std::uint32_t low = few_bits(16);
    return few_bits(k - 16) << 16 | low;
  }

 private:
  std::uint32_t few_bits(std::uint32_t k) {
    length_ >>= k;
    std::uint32_t v = value_ / length_;
    value_ -= v * length_;
    if (v >> k) [[unlikely]] {
      corrupt_ = true;
      v &= (1u << k) - 1;
    }
    renormalise();
    return v;
  }

  // No branch on the data: the number of whole leading zero bytes of length_ is at most 3.
  [[gnu::always_inline]] void renormalise() {
    const std::uint32_t shift = static_cast<std::uint32_t>(std::countl_zero(length_)) & 24u;
    const std::uint64_t window = static_cast<std::uint64_t>(value_) << 32 | next_four();
    value_ = static_cast<std::uint32_t>((window << shift) >> 32);
    length_ <<= shift;
    skip(shift >> 3);
  }

  [[gnu::always_inline]] std::uint32_t next_four() const {
    if (memory_end_ - at_ < 4) [[unlikely]] return last_bytes();
    std::uint32_t v;
    std::memcpy(&v, at_, 4);
    return __builtin_bswap32(v);
  }
  [[gnu::always_inline]] void skip(std::uint32_t n) {
    if (memory_end_ - at_ < 4) [[unlikely]] {
      const auto left = static_cast<std::uint32_t>(memory_end_ - at_);
      missing_ += n > left ? n - left : 0;
      n = std::min(n, left);
    }
    at_ += n;
  }
  [[gnu::noinline]] std::uint32_t last_bytes() const {
    std::uint32_t v = 0;
    for (int i = 0; i < 4; ++i) v = v << 8 | (memory_end_ - at_ > i ? at_[i] : 0u);
    return v;
  }

  std::uint32_t value_ = 0, length_ = 0xFFFFFFFFu;
  const std::uint8_t* at_ = nullptr;
  const std::uint8_t* memory_end_ = nullptr;
  std::uint32_t epoch_ = 0;
  bool corrupt_ = false;
  std::size_t missing_ = 0;
  const std::uint8_t* begin_ = nullptr;
  const std::uint8_t* stream_end_ = nullptr;
};

class Encoder {
 public:
  static constexpr bool kEncodes = true;
  template <std::uint32_t kCapacity>
  using Model = SymbolModel<kCapacity, false>;

  void start(std::uint32_t epoch) {
    out_.clear();
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

  // Ends the stream; valid until the next start().
  std::span<const std::byte> finish() {
    const bool extra = length_ > 2 * kMinLength;
    narrow(extra ? kMinLength : kMinLength >> 1, extra ? kMinLength >> 1 : kMinLength >> 9);
    out_.insert(out_.end(), extra ? 3 : 2, 0);
    return std::as_bytes(std::span(out_));
  }

 private:
  void few_bits(std::uint32_t k, std::uint32_t v) {
    const std::uint32_t unit = length_ >> k;
    narrow(v * unit, unit);
  }

  void narrow(std::uint32_t low, std::uint32_t length) {
    base_ += low;
    if (base_ < low) [[unlikely]] carry();
    length_ = length;
    while (length_ < kMinLength) {
      out_.push_back(static_cast<std::uint8_t>(base_ >> 24));
      base_ <<= 8;
      length_ <<= 8;
    }
  }
  // The sum of all bytes so far is below one, so a byte that takes the carry exists.
  void carry() {
    std::size_t i = out_.size() - 1;
    while (out_[i] == 0xFF) out_[i--] = 0;
    ++out_[i];
  }

  std::uint32_t base_ = 0, length_ = 0xFFFFFFFFu;
  std::uint32_t epoch_ = 0;
  std::vector<std::uint8_t> out_;
};

// 32 and 64 raw bits, low half first.
template <class Coder>
std::uint32_t raw32(Coder& coder, std::uint32_t v) {
  const std::uint32_t low = coder.raw(16, v & 0xFFFF);
  return coder.raw(16, v >> 16) << 16 | low;
}
template <class Coder>
std::uint64_t raw64(Coder& coder, std::uint64_t v) {
  const std::uint64_t low = raw32(coder, static_cast<std::uint32_t>(v));
  return static_cast<std::uint64_t>(raw32(coder, static_cast<std::uint32_t>(v >> 32))) << 32 | low;
}

}  // namespace ilot::laz
