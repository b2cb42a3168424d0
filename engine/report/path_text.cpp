// SPDX-License-Identifier: Apache-2.0
#include "engine/report/path_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>

namespace ilot {
namespace {

// Returns the number of bytes of the UTF-8 character at the beginning of the text; 0 when there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return 1;
  const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return 0;
  std::uint32_t code = byte(0) & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  constexpr std::uint32_t kLeast[5]{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < kLeast[length] || surrogate || code > 0x10FFFF ? 0 : length;
}

}  // namespace

std::string path_text(const std::filesystem::path& path) {
  const std::string bytes = path.string();
  std::string text;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = character_length(std::string_view(bytes).substr(at));
    if (length == 0 || bytes[at] == '\\') {
      text += fmt::format("\\x{:02X}", static_cast<unsigned char>(bytes[at++]));
    } else {
      text.append(bytes, at, length);
      at += length;
    }
  }
  return text;
}

std::filesystem::path path_of_text(std::string_view text) {
  std::string bytes;
  for (std::size_t at = 0; at < text.size(); ++at) {
    unsigned value = 0;
    const char* digits = text.data() + at + 2;
    if (text[at] == '\\' && at + 3 < text.size() && text[at + 1] == 'x' &&
        std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
      bytes += static_cast<char>(value);
      at += 3;
    } else {
      bytes += text[at];
    }
  }
  return bytes;
}

}  // namespace ilot
