// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/packed.h"

#include "engine/compressed.h"

namespace ilot {

std::string base64(std::string_view bytes) {
  constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kLetters[word >> (18 - 6 * static_cast<unsigned>(k)) & 63];
  }
  return text;
}

std::string packed(std::string_view bytes) {
  return base64(compressed(bytes));
}

std::string packed_element(std::string_view name, std::string_view bytes) {
  return "<script type=\"text/plain\" data-ilot=\"" + std::string(name) + "\">" + packed(bytes) + "</script>\n";
}

void put_whole(std::string& bytes, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(0x80 | (value & 0x7f));
  bytes += static_cast<char>(value);
}

void put_signed(std::string& bytes, std::int64_t value) {
  put_whole(bytes, static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
}

std::uint64_t take_whole(std::string_view bytes, std::size_t& at) {
  std::uint64_t value = 0;
  for (unsigned shift = 0; at < bytes.size(); shift += 7) {
    const auto byte = static_cast<unsigned char>(bytes[at++]);
    value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if (byte < 0x80) break;
  }
  return value;
}

std::int64_t take_signed(std::string_view bytes, std::size_t& at) {
  const std::uint64_t value = take_whole(bytes, at);
  return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
}

}  // namespace ilot
