// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "engine/cloud/record.h"
#include "tools/render/image.h"

namespace ilot::render {

// Colour of one record.
using Colouring = std::function<Rgb(std::span<const std::byte>)>;

// by: "class" (or "classification"), "height", "intensity", "rgb", or the name of an extra-byte field of
// integers, whose values get colours far apart (0 = dark grey). low, high: heights in world units that
// "height" spreads its colours over. Throws Error (usage) when the cloud has no such field.
Colouring colouring(const std::string& by, const RecordLayout& layout, double low, double high);

}  // namespace ilot::render
