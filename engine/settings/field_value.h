// SPDX-License-Identifier: Apache-2.0
// Converts a field of Settings to a Value and back: one specialisation for each type of field.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/settings/parameters.h"

namespace ilot {

template <class T>
struct FieldValue {
  static constexpr bool kOptional = false;
  static constexpr ParameterKind kKind = std::is_same_v<T, bool>       ? ParameterKind::boolean
                                         : std::is_floating_point_v<T> ? ParameterKind::number
                                                                       : ParameterKind::integer;
  using Stored = std::conditional_t<std::is_same_v<T, bool>, bool,
                                    std::conditional_t<std::is_floating_point_v<T>, double, std::int64_t>>;
  static Value get(const T& field) { return static_cast<Stored>(field); }
  static void set(T& field, const Value& value) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    field = whole != nullptr ? static_cast<T>(*whole) : static_cast<T>(std::get<Stored>(value));
  }
};

template <class T>
struct FieldValue<std::optional<T>> {
  static constexpr bool kOptional = true;
  static constexpr ParameterKind kKind = FieldValue<T>::kKind;
  static Value get(const std::optional<T>& field) { return field ? FieldValue<T>::get(*field) : Value(Auto{}); }
  static void set(std::optional<T>& field, const Value& value) {
    field.reset();
    if (!std::holds_alternative<Auto>(value)) FieldValue<T>::set(field.emplace(), value);
  }
};

template <>
struct FieldValue<std::vector<int>> {
  static constexpr bool kOptional = false;
  static constexpr ParameterKind kKind = ParameterKind::integers;
  static Value get(const std::vector<int>& field) { return std::vector<std::int64_t>(field.begin(), field.end()); }
  static void set(std::vector<int>& field, const Value& value) {
    const auto& list = std::get<std::vector<std::int64_t>>(value);
    field.clear();
    for (std::int64_t entry : list) field.push_back(static_cast<int>(entry));
  }
};

template <>
struct FieldValue<std::vector<double>> {
  static constexpr bool kOptional = false;
  static constexpr ParameterKind kKind = ParameterKind::numbers;
  static Value get(const std::vector<double>& field) { return field; }
  static void set(std::vector<double>& field, const Value& value) {
    if (const auto* whole = std::get_if<std::vector<std::int64_t>>(&value)) {
      field.assign(whole->begin(), whole->end());
    } else {
      field = std::get<std::vector<double>>(value);
    }
  }
};

// A choice among names, in the order of the enumeration.
template <class E>
requires std::is_enum_v<E>
struct FieldValue<E> {
  static constexpr bool kOptional = false;
  static constexpr ParameterKind kKind = ParameterKind::choice;
  static Value get(E field) { return std::string(names_of(field)[static_cast<std::size_t>(field)]); }
  static void set(E& field, const Value& value) {
    const auto names = names_of(field);
    field = static_cast<E>(std::find(names.begin(), names.end(), std::get<std::string>(value)) - names.begin());
  }
};

}  // namespace ilot
