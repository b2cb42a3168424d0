// SPDX-License-Identifier: Apache-2.0
// Which faces of a model belong together.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scan/models/model_input.h"

namespace ilot::scan {

// Metres: faces whose boxes are nearer than that touch.
constexpr double kTouching = 0.01;

// Calls `pair` with the indices of all faces whose boxes touch, the smaller index first, in a fixed order. O(n log n)
// and the number of pairs that overlap in x.
void for_touching(std::span<const ScannedFace> faces, const std::function<void(std::uint32_t, std::uint32_t)>& pair);

// Returns for each face the number of its element, from 1; 0 = none. Elements are windows, doors and installations.
// All faces of a semantic surface are one. Of faces without semantics, those of one class and building that touch are
// one.
std::vector<std::uint32_t> element_of_faces(const ScannedModel& model);

// Returns for each face the number of its plane, dense, from 0, in the order of first faces.
std::vector<std::uint32_t> plane_of_faces(const ScannedModel& model, std::span<const std::uint32_t> elements);

}  // namespace ilot::scan
