// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "engine/deliverables/drawings/drawing_layers.h"
#include "engine/deliverables/drawings/drawing_svg.h"
#include "engine/model/facade.h"

namespace ilot {

// facades.html beside the facades' files: what was found, each drawing over its orthoimage with its layers to switch,
// what of it is occluded or completed and why, links to the files; what speaks for each edge, where the
// pointer is, in colour, and in a table with that of the faces. The same facades in the same order give the same
// bytes. Memory is bounded: drawings up to `most_bytes` together are shown, then links alone; of each facade the first
// 200 entries of the list and 1,000 of the table.
class FacadesPage {
 public:
  FacadesPage(const std::filesystem::path& path, const DrawingLayers& layers, std::size_t most_bytes = 64u << 20)
      : path_(path), layers_(layers), most_bytes_(most_bytes) {}

  // The drawing is that of facade_drawing(); the image is where write_facade_image() put it, when there is one.
  void add(const Facade& facade, const Drawing& drawing, const std::optional<SvgUnderlay>& image,
           double metres_per_unit = 1);

  // Writes the file. Throws Error.
  void finish();

 private:
  std::filesystem::path path_;
  DrawingLayers layers_;
  std::size_t most_bytes_;
  std::string body_;
  std::uint64_t facades_ = 0, drawn_ = 0, elements_ = 0, edges_ = 0, completed_edges_ = 0, occluded_edges_ = 0;
  std::map<std::string, std::map<DrawnStatus, std::uint64_t>> by_kind_;
};

}  // namespace ilot
