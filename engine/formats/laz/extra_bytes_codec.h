// SPDX-License-Identifier: Apache-2.0
// Extra bytes of point formats 0-5: each byte is predicted from the last point and has its own models.
#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "engine/formats/laz/integer_codec.h"

namespace ilot::laz {

// Item version 2 codes differences modulo 256 as symbols.
template <class Coder>
struct ByteDifferences {
  typename Coder::template Model<256> differences;

  struct Shared {};
  std::uint32_t code(Coder& coder, Shared&, std::uint32_t last, std::uint32_t value) {
    return (last + coder.symbol(differences, (value - last) & 255u)) & 255u;
  }
};

// Item version 1 codes differences as integers of 8 bits. All bytes share the models of the values.
template <class Coder>
struct ByteIntegers {
  using Shared = IntegerCodec<Coder, 8, 1>;
  typename Shared::LengthModel lengths;

  std::uint32_t code(Coder& coder, Shared& shared, std::uint32_t last, std::uint32_t value) {
    return static_cast<std::uint32_t>(
        shared.code(coder, static_cast<std::int32_t>(last), static_cast<std::int32_t>(value), lengths));
  }
};

template <class Coder, class ByteCodec>
class ExtraBytesCodec {
 public:
  using Byte = std::conditional_t<Coder::kEncodes, const std::byte, std::byte>;

  explicit ExtraBytesCodec(std::size_t count) : last_(count), codecs_(count) {}

  void start(const std::byte* first) { last_.assign(first, first + last_.size()); }

  void code(Coder& coder, Byte* bytes) {
    for (std::size_t i = 0; i < last_.size(); ++i) {
      const std::uint32_t value = Coder::kEncodes ? std::to_integer<std::uint32_t>(bytes[i]) : 0;
      last_[i] =
          static_cast<std::byte>(codecs_[i].code(coder, shared_, std::to_integer<std::uint32_t>(last_[i]), value));
      if constexpr (!Coder::kEncodes) bytes[i] = last_[i];
    }
  }

 private:
  std::vector<std::byte> last_;
  std::vector<ByteCodec> codecs_;
  typename ByteCodec::Shared shared_{};
};

}  // namespace ilot::laz
