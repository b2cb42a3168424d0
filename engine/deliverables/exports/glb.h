// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 in one binary file (GLB) [Khronos: glTF 2.0, 4.4].
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

enum class GlbTarget : std::uint16_t { none = 0, vertices = 34962, indices = 34963 };

// Collects the arrays of a glTF file. Numbers of views and accessors are those in the file.
class Glb {
 public:
  nlohmann::ordered_json json;  // all but buffers, bufferViews and accessors

  std::size_t add_view(std::span<const std::byte> bytes, GlbTarget target);
  std::size_t add_vectors(std::span<const float> xyz, bool with_bounds);  // VEC3 of float, 3 numbers each
  std::size_t add_scalars(std::span<const float> values);                 // of vertices
  std::size_t add_indices(std::span<const std::uint32_t> values);         // 16 bits each where that is enough

  // Returns the whole file. Throws Error when it would exceed 4 GiB, which the format cannot state; `name` is for that.
  std::string file(const std::string& name) const;

 private:
  std::size_t add_accessor(std::size_t view, int component, std::size_t count, const char* type);
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array(), accessors_ = nlohmann::ordered_json::array();
  std::string binary_;
};

// Binary files of glTF and 3D Tiles: numbers of 32 bits, and chunks that end at a multiple of 8 bytes.
void append_number(std::string& text, std::uint64_t value);
std::string padded(std::string text, char with);

// Returns the asset and the three materials of buildings, "roof", "wall", "ground", in the order of SurfaceKind.
nlohmann::ordered_json glb_start();

// The rotation of a node whose content has z up, as a quaternion x, y, z, w: glTF has y up.
nlohmann::ordered_json z_up();

// A place with z up, as the same place with y up: what a translation beside z_up() must be.
nlohmann::ordered_json y_up_place(Vec3 place);

}  // namespace ilot
