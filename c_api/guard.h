// SPDX-License-Identifier: Apache-2.0
// The border between C and C++: no exception crosses it. Every function of the C interface is the body of a call of
// guarded().
#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "ilot/error.h"
#include "ilot/geometry.h"
#include "ilot/ilot.h"

namespace ilot::c {

// Notes the sentence for ilot_last_error() of this thread and returns the status.
ilot_status fault(ilot_status status, const char* sentence) noexcept;

// The status of what is being caught.
ilot_status fault_of_exception() noexcept;

// Runs a body that returns a status.
template <typename Body>
ilot_status guarded(const Body& body) noexcept {
  try {
    return body();
  } catch (...) {
    return fault_of_exception();
  }
}

// Outputs are NULL or 0 after a fault, whatever the fault; called before everything else.
template <typename... Outputs>
void clear(Outputs*... outputs) {
  ((outputs != nullptr ? void(*outputs = Outputs{}) : void()), ...);
}

// Throws Error (usage) for NULL.
void need(const void* pointer, const char* name);

// Checked arrays as the functions over points in memory take them.
PointArrays points_of(const double* x, const double* y, const double* z, std::size_t points);

// Memory that ilot_free() takes. Throws std::bad_alloc.
void* allocate(std::size_t bytes);
char* copy_of(const std::string& text);

// Numbers that are none become null; texts that are no UTF-8 are mended.
char* text_of(const nlohmann::json& json);

inline nlohmann::json json_of(Vec3 p) {
  return {p.x, p.y, p.z};
}

}  // namespace ilot::c
