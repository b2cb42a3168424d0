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

// facades.html beside the files of the facades. For each facade it has counts, the drawing over its orthoimage with
// layers to switch, the occluded or completed parts with the reason, and links to the files. The evidence for each edge
// is shown at the pointer, in colour, and in a table together with that of the faces. The same facades in the same
// order give the same bytes. Memory is bounded: drawings are shown up to `most_bytes` in total, then only links. Of
// each facade the first 200 entries of the list and the first 1,000 of the table are shown.
class FacadesPage {
 public:
  FacadesPage(const std::filesystem::path& path, const DrawingLayers& layers, std::size_t most_bytes = 64u << 20)
      : path_(path), layers_(layers), most_bytes_(most_bytes) {}

  // The drawing is that of facade_drawing(). The image, if there is one, is where write_facade_image() put it.
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
