// SPDX-License-Identifier: Apache-2.0
// Lists of values as binary fields of records.
#pragma once
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/error.h"

namespace ilot {

template <class T>
nlohmann::json bytes_json(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return nlohmann::json::binary(std::move(bytes));
}

// Throws nlohmann::json::exception where the field is missing, and Error where it has no whole number of values.
template <class T>
std::vector<T> values_of(const nlohmann::json& record, const char* name) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto& bytes = record.at(name).get_binary();
  if (bytes.size() % sizeof(T) != 0) throw Error(std::string(name) + " of a part is not whole");
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

}  // namespace ilot
