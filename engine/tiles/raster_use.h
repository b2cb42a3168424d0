// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ilot {

// What a raster is for, as Errors about its size or memory say it.
struct RasterUse {
  const char* what = "";    // the beginning of the text: "streets"
  const char* remedy = "";  // the setting that helps, with a comma behind it: "a larger streets.pixel, "; may be empty
};

}  // namespace ilot
