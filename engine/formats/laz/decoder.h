// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "engine/formats/laz/bit_model.h"
#include "engine/formats/laz/models.h"

namespace ilot::laz {

// Reads an arithmetic stream of LAZ. It allocates nothing and throws nothing; overrun() reports damage.
class Decoder {
 public:
  static constexpr bool kEncodes = false;
  template <std::uint32_t kCapacity>
  using Model = SymbolModel<kCapacity, true>;

  // Streams are inside `memory`, which bounds every read. `stream` is the declared place of this stream. Bytes behind
  // the stream but inside memory are read without an error, which overrun() reports; bytes behind memory are read as
  // zero.
  void start(std::span<const std::byte> memory, std::span<const std::byte> stream, std::uint32_t epoch) {
    begin_ = at_ = reinterpret_cast<const std::uint8_t*>(stream.data());
    stream_end_ = begin_ + stream.size();
    memory_end_ = reinterpret_cast<const std::uint8_t*>(memory.data()) + memory.size();
    before_ = missing_ = 0;
    epoch_ = epoch;
    length_ = 0xFFFFFFFFu;
    value_ = next_four();
    corrupt_ = value_ >= length_;
    if (corrupt_) value_ = 0;  // value_ < length_ always holds: it bounds every table index below
    skip(4);
  }

  // Continues in `memory`, which belongs completely to this stream and begins with its byte number consumed().
  void move_to(std::span<const std::byte> memory) {
    before_ += static_cast<std::size_t>(at_ - begin_);
    begin_ = at_ = reinterpret_cast<const std::uint8_t*>(memory.data());
    stream_end_ = memory_end_ = begin_ + memory.size();
  }

  // Returns the bytes that the symbols have used so far; more than the size of the stream when it is damaged.
  std::size_t consumed() const { return before_ + static_cast<std::size_t>(at_ - begin_) + missing_; }
  bool overrun() const { return at_ > stream_end_ || missing_ != 0 || corrupt_; }

  template <std::uint32_t kCapacity>
  [[gnu::always_inline]] std::uint32_t symbol(Model<kCapacity>& model, std::uint32_t = 0,
                                              std::uint32_t symbols = kCapacity) {
    model.prepare(epoch_, symbols);
    const std::uint32_t unit = length_ >> kSymbolShift;
    // renormalise() keeps length_ at 2^24 and above. NOLINTNEXTLINE(clang-analyzer-core.DivideZero)
    const std::uint32_t s = model.find(value_ / unit);
    const std::uint32_t low = model.below(s) * unit;
    const std::uint32_t last = s == model.last_symbol(), mask = 0u - last;  // no branch that depends on the data
    const std::uint32_t high = (length_ & mask) | (model.below(s + 1) * unit & ~mask);
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
    const std::uint32_t mask = 0u - b;
    value_ -= split & mask;
    length_ = split + ((length_ - 2 * split) & mask);
    renormalise();
    model.count(b);
    return b;
  }

  // Reads k equally likely bits, 1 <= k <= 32.
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

  // There is no branch that depends on the data: the number of whole leading zero bytes of length_ is at most 3.
  [[gnu::always_inline]] void renormalise() {
    const std::uint32_t shift = static_cast<std::uint32_t>(std::countl_zero(length_)) & 24u;
    const std::uint64_t window = static_cast<std::uint64_t>(value_) << 32 | next_four();
    value_ = static_cast<std::uint32_t>((window << shift) >> 32);
    length_ <<= shift;
    skip(shift >> 3);
  }

  [[gnu::always_inline]] std::uint32_t next_four() const {
    if (memory_end_ - at_ < 4) [[unlikely]]
      return last_bytes();
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
  std::size_t before_ = 0, missing_ = 0;
  const std::uint8_t* begin_ = nullptr;
  const std::uint8_t* stream_end_ = nullptr;
};

}  // namespace ilot::laz
