// SPDX-License-Identifier: Apache-2.0
#include "engine/run/packed_image.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace ilot {
namespace {

constexpr std::size_t kEight = 8;  // values looked at together
constexpr std::uint16_t kPackedNone = 0xffff, kPackedAbove = 0xfffe;

// A word 2 n + 1 and a value: n times the value; a word 2 n: n values follow. The codes of values: two bytes above
// `base`, or four as they are.
struct Narrow {
  static constexpr std::size_t kWords = 1;
  Height base;

  std::uint16_t code(Height v) const {
    const auto above = static_cast<std::uint16_t>(static_cast<std::uint32_t>(v) - static_cast<std::uint32_t>(base));
    return v == kNoHeight ? kPackedNone : v == kAboveAll ? kPackedAbove : above;
  }
  Height value(std::uint16_t code) const {
    const auto v = static_cast<Height>(static_cast<std::uint32_t>(base) + code);
    return code == kPackedNone ? kNoHeight : code == kPackedAbove ? kAboveAll : v;
  }
  void put(const Height* __restrict values, std::size_t n, std::uint16_t* __restrict words) const {
    for (std::size_t i = 0; i < n; ++i) words[i] = code(values[i]);
  }
  void get(const std::uint16_t* __restrict words, std::size_t n, Height* __restrict out) const {
    for (std::size_t i = 0; i < n; ++i) out[i] = value(words[i]);
  }
};

struct Wide {
  static constexpr std::size_t kWords = 2;

  static void put(const Height* values, std::size_t n, std::uint16_t* words) {
    std::memcpy(words, values, n * sizeof(Height));
  }
  static void get(const std::uint16_t* words, std::size_t n, Height* out) {
    std::memcpy(out, words, n * sizeof(Height));
  }
};

bool all_equal(const Height* v) {
  Height differ = 0;
  for (std::size_t i = 0; i < kEight; ++i) differ |= v[i] ^ v[0];
  return differ == 0;
}

template <class Code>
class RowPacker {
 public:
  RowPacker(const Code& code, std::span<const Height> row, std::vector<std::uint16_t>& words)
      : code_(code), row_(row), words_(words) {}

  // A run is found by the eight values that it must hold from a multiple of eight on.
  void pack() {
    std::size_t literal = 0;  // first value that is not yet written
    for (std::size_t i = 0; i + kEight <= row_.size();) {
      if (!all_equal(row_.data() + i)) {
        i += kEight;
        continue;
      }
      std::size_t from = i, to = i + kEight;
      while (from > literal && row_[from - 1] == row_[i]) --from;
      while (to < row_.size() && row_[to] == row_[i]) ++to;
      put_values(literal, from);
      put(2 * (to - from) + 1, from, 1);
      literal = to;
      i = (to + kEight - 1) / kEight * kEight;
    }
    put_values(literal, row_.size());
  }

 private:
  void put_values(std::size_t from, std::size_t to) {
    if (from < to) put(2 * (to - from), from, to - from);
  }
  void put(std::size_t head, std::size_t from, std::size_t n) {
    const std::size_t at = words_.size();
    words_.resize(at + 1 + n * Code::kWords);
    words_[at] = static_cast<std::uint16_t>(head);
    code_.put(row_.data() + from, n, words_.data() + at + 1);
  }

  const Code& code_;
  std::span<const Height> row_;
  std::vector<std::uint16_t>& words_;
};

// Values [from, from + length) of a row.
template <class Code>
void unpack_row(const Code& code, std::span<const std::uint16_t> words, std::size_t from, std::size_t length,
                Height* out) {
  const std::size_t end = from + length;
  std::size_t at = 0;
  for (std::size_t w = 0; w < words.size() && at < end;) {
    const std::size_t n = words[w] >> 1;
    const bool run = (words[w] & 1) != 0;
    const std::size_t first = std::max(at, from), last = std::min(at + n, end);
    const std::uint16_t* values = words.data() + w + 1;
    if (first < last) {
      Height* to = out + (first - from);
      if (run) {
        Height v;
        code.get(values, 1, &v);
        std::fill(to, to + (last - first), v);
      } else {
        code.get(values + (first - at) * Code::kWords, last - first, to);
      }
    }
    at += n;
    w += 1 + (run ? 1 : n) * Code::kWords;
  }
}

// The least and the greatest of the heights; above all and none where there is none.
struct Range {
  Height low = kAboveAll, high = kNoHeight;
};

Range range_of(const Image& image) {
  Range range;
  for (const Height v : image.values) {
    range.low = std::min(range.low, v == kNoHeight ? kAboveAll : v);
    range.high = std::max(range.high, v == kAboveAll ? kNoHeight : v);
  }
  return range;
}

template <class Code>
void pack_rows(const Code& code, const Image& image, PackedImage& packed) {
  packed.rows.reserve(image.height + 1);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    packed.rows.push_back(static_cast<std::uint32_t>(packed.words.size()));
    const auto row = std::span(image.values).subspan(std::size_t{y} * image.width, image.width);
    RowPacker<Code>(code, row, packed.words).pack();
  }
  packed.rows.push_back(static_cast<std::uint32_t>(packed.words.size()));
}

template <class Code>
void unpack_rows(const Code& code, const PackedImage& packed, std::span<const std::uint16_t> words,
                 const TileFrame& part, const PixelRows& out) {
  const std::uint32_t first = packed.rows[part.y];
  for (std::uint32_t y = 0; y < part.height; ++y) {
    const std::uint32_t from = packed.rows[part.y + y] - first, to = packed.rows[part.y + y + 1] - first;
    unpack_row(code, words.subspan(from, to - from), part.x, part.width, out.first + y * out.stride);
  }
}

}  // namespace

PackedImage packed_image(const Image& image) {
  assert(image.width < (1u << 15));
  const Range range = range_of(image);
  PackedImage packed;
  packed.base = range.low == kAboveAll ? 0 : range.low;
  packed.wide = range.high > range.low && std::int64_t{range.high} - range.low >= kPackedAbove;
  packed.wide ? pack_rows(Wide{}, image, packed) : pack_rows(Narrow{packed.base}, image, packed);
  packed.words.shrink_to_fit();
  return packed;
}

void unpack(const PackedImage& packed, std::span<const std::uint16_t> words, const TileFrame& part,
            const PixelRows& out) {
  packed.wide ? unpack_rows(Wide{}, packed, words, part, out)
              : unpack_rows(Narrow{packed.base}, packed, words, part, out);
}

}  // namespace ilot
