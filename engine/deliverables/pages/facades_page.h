// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>

#include "engine/deliverables/pages/facade_sheets.h"

namespace ilot {

// facades.html beside files that `ilot draw` wrote: the sheets of all facades, in the look of the report.
class FacadesPage {
 public:
  FacadesPage(const std::filesystem::path& path, const DrawingLayers& layers, std::size_t most_bytes = 64u << 20)
      : path_(path), sheets_({layers, "", most_bytes}) {}

  // The drawing is that of facade_drawing(). The image, if there is one, is where write_facade_image() put it.
  void add(const Facade& facade, const Drawing& drawing, const std::optional<SvgUnderlay>& image,
           double metres_per_unit = 1) {
    sheets_.add(facade, drawing, image, metres_per_unit);
  }

  // Writes the file. Throws Error.
  void finish();

 private:
  std::filesystem::path path_;
  FacadeSheets sheets_;
};

}  // namespace ilot
