// SPDX-License-Identifier: Apache-2.0
// An orthoimage of a facade in few bytes, for a page.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "engine/deliverables/drawings/drawing.h"

namespace ilot {

struct SmallImage {
  std::string jpeg;  // the bytes of the file
  FlatBox place;     // in the drawing, from the world file beside the image
};

// Reads an image with a world file (.pgw) and returns it with at most `most_pixels` a side; what is transparent becomes
// white. Nullopt when one of the two files cannot be read.
std::optional<SmallImage> small_image(const std::filesystem::path& png, int most_pixels);

}  // namespace ilot
