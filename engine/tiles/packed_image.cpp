// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/packed_image.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "kernels/rasters/narrow_heights.h"

namespace ilot {
namespace {

constexpr std::size_t kEight = 8;   // values that are compared together
constexpr Height kMiddle = 0x7fff;  // middle of the codes

// The format of a row: a word 2 n + 1 and a value stand for n times the value; a word 2 n stands for the n values that
// follow. The code of a value is two bytes relative to `base`, or four bytes as it is. put() returns whether all values
// have a code.
struct Narrow {
  static constexpr std::size_t kWords = 1;
  Height base;

  bool put(const Height* values, std::size_t n, std::uint16_t* words) const {
    return narrow_heights({values, n}, base, {words, n});
  }
  void get(const std::uint16_t* words, std::size_t n, Height* out) const { widen_codes({words, n}, base, {out, n}); }
};

struct Wide {
  static constexpr std::size_t kWords = 2;

  static bool put(const Height* values, std::size_t n, std::uint16_t* words) {
    std::memcpy(words, values, n * sizeof(Height));
    return true;
  }
  static void get(const std::uint16_t* words, std::size_t n, Height* out) {
    std::memcpy(out, words, n * sizeof(Height));
  }
};

bool all_equal_to(Height value, const Height* v) {
  Height differ = 0;
  for (std::size_t i = 0; i < kEight; ++i) differ |= v[i] ^ value;
  return differ == 0;
}

template <class Code>
class RowPacker {
 public:
  RowPacker(const Code& code, std::span<const Height> row, std::vector<std::uint16_t>& words)
      : code_(code), row_(row), words_(words) {}

  // Packs a row. A run is found by the eight equal values that it must contain from a multiple of eight on. Returns
  // false when a value has no code.
  bool pack() {
    std::size_t literal = 0;  // first value that is not yet written
    bool all = true;
    for (std::size_t i = 0; i + kEight <= row_.size();) {
      const Height value = row_[i];
      if (row_[i + 1] != value || !all_equal_to(value, row_.data() + i)) {
        i += kEight;
        continue;
      }
      std::size_t from = i, to = i + kEight;
      while (from > literal && row_[from - 1] == value) --from;
      while (to + kEight <= row_.size() && all_equal_to(value, row_.data() + to)) to += kEight;
      while (to < row_.size() && row_[to] == value) ++to;
      all &= put_values(literal, from) && put(2 * (to - from) + 1, from, 1);
      literal = to;
      i = (to + kEight - 1) / kEight * kEight;
    }
    return put_values(literal, row_.size()) && all;
  }

 private:
  bool put_values(std::size_t from, std::size_t to) { return from == to || put(2 * (to - from), from, to - from); }

  bool put(std::size_t head, std::size_t from, std::size_t n) {
    const std::size_t at = words_.size();
    words_.resize(at + 1 + n * Code::kWords);
    words_[at] = static_cast<std::uint16_t>(head);
    return code_.put(row_.data() + from, n, words_.data() + at + 1);
  }

  const Code& code_;
  std::span<const Height> row_;
  std::vector<std::uint16_t>& words_;
};

// Unpacks the values [from, from + length) of a row.
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

Height lowest(const Image& image) {
  Height low = kAboveAll;
  for (const Height v : image.values) low = std::min(low, v == kNoHeight ? kAboveAll : v);
  return low;
}

// Returns false when a value has no code.
template <class Code>
bool pack_rows(const Code& code, const Image& image, PackedImage& packed) {
  packed.rows.clear();
  packed.words.clear();
  packed.rows.reserve(image.height + 1);
  packed.words.reserve(image.size() / 2);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    packed.rows.push_back(static_cast<std::uint32_t>(packed.words.size()));
    const auto row = std::span(image.values).subspan(std::size_t{y} * image.width, image.width);
    if (!RowPacker<Code>(code, row, packed.words).pack()) return false;
  }
  packed.rows.push_back(static_cast<std::uint32_t>(packed.words.size()));
  return true;
}

// Packs the image with two-byte values around the first height. If that fails, it packs two-byte values from the least
// height on, and then four-byte values.
void pack_somehow(const Image& image, PackedImage& packed) {
  for (const Height v : image.values) {
    if (v == kNoHeight || v == kAboveAll) continue;
    packed.base = v - kMiddle;
    break;
  }
  if (pack_rows(Narrow{packed.base}, image, packed)) return;
  packed.base = lowest(image);
  if (pack_rows(Narrow{packed.base}, image, packed)) return;
  packed.wide = true;
  pack_rows(Wide{}, image, packed);
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
  PackedImage packed;
  pack_somehow(image, packed);
  packed.words.shrink_to_fit();
  return packed;
}

void unpack(const PackedImage& packed, std::span<const std::uint16_t> words, const TileFrame& part,
            const PixelRows& out) {
  packed.wide ? unpack_rows(Wide{}, packed, words, part, out)
              : unpack_rows(Narrow{packed.base}, packed, words, part, out);
}

}  // namespace ilot
