// SPDX-License-Identifier: Apache-2.0
// Data inside of a page: compressed (RFC 1950), then base64 (RFC 4648). Browsers unpack it without a library.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ilot {

// Returns the bytes compressed and in base64. The same bytes give the same text. Throws Error without memory.
std::string packed(std::string_view bytes);

std::string base64(std::string_view bytes);

// Returns an element that holds packed data; scripts find it by its name.
std::string packed_element(std::string_view name, std::string_view bytes);

// Whole numbers in few bytes: seven bits a byte, the lowest first; signed ones as 2n or -2n - 1.
void put_whole(std::string& bytes, std::uint64_t value);
void put_signed(std::string& bytes, std::int64_t value);

// The way back, of bytes that came from there. `at` moves on.
std::uint64_t take_whole(std::string_view bytes, std::size_t& at);
std::int64_t take_signed(std::string_view bytes, std::size_t& at);

// Appends the values of a column as little-endian words.
template <class T>
void put_column(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

}  // namespace ilot
