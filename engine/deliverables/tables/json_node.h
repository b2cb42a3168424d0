// SPDX-License-Identifier: Apache-2.0
// Reads JSON that must have a given form. Every fault is an Error that begins with its place in the file.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/error.h"
#include "kernels/core/types.h"

namespace ilot {

// A value and its place in the file, for messages. The JSON is not owned.
struct JsonNode {
  const nlohmann::json& json;
  std::string place;

  [[noreturn]] void fail(const std::string& what) const { throw Error(place + ": " + what); }

  bool has(const char* key) const { return json.is_object() && json.contains(key); }
  JsonNode at(const char* key) const {
    if (!has(key)) fail(std::string("'") + key + "' is missing");
    return {json[key], place + "." + key};
  }

  template <class Visit>
  void each(Visit visit) const {
    if (!json.is_array()) fail("needs a list");
    for (std::size_t i = 0; i < json.size(); ++i) visit(JsonNode{json[i], place + "[" + std::to_string(i) + "]"});
  }
  template <class Make>
  auto list(Make make) const {
    std::vector<decltype(make(*this))> items;
    each([&](const JsonNode& item) { items.push_back(make(item)); });
    return items;
  }

  double number() const {
    if (!json.is_number() || !std::isfinite(json.get<double>())) fail("needs a finite number");
    return json.get<double>();
  }
  std::uint64_t count() const {
    if (!json.is_number_integer() || json < 0) fail("needs a whole number from 0 on");
    return json.get<std::uint64_t>();
  }
  std::uint32_t id() const {
    const std::uint64_t value = count();
    if (value > std::numeric_limits<std::uint32_t>::max()) fail("needs a whole number below 2^32");
    return static_cast<std::uint32_t>(value);
  }
  std::string text() const {
    if (!json.is_string()) fail("needs a text");
    return json.get<std::string>();
  }
  bool flag() const {
    if (!json.is_boolean()) fail("needs true or false");
    return json.get<bool>();
  }
  Vec3 position() const {
    if (!json.is_array() || json.size() != 3) fail("needs three numbers");
    return {JsonNode{json[0], place}.number(), JsonNode{json[1], place}.number(), JsonNode{json[2], place}.number()};
  }
  // The index of a text among `names`. `what` says for a message what is expected.
  template <std::size_t N>
  std::size_t choice(const std::array<const char*, N>& names, const std::string& what) const {
    const std::string name = text();
    for (std::size_t i = 0; i < N; ++i)
      if (name == names[i]) return i;
    fail("'" + name + "' is no " + what);
  }
};

}  // namespace ilot
