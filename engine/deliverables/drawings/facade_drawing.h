// SPDX-License-Identifier: Apache-2.0
// A facade as a surveyor's elevation drawing, before it is written as DXF or SVG.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/named_sections.h"
#include "engine/model/facade.h"
#include "ilot/settings.h"

namespace ilot {

struct FacadeDrawingParams {
  double scale = 50;           // 1 : scale; sets the sizes of texts and paper
  double metres_per_unit = 1;  // of the CRS, in all three axes
  std::string title;           // empty: "Elevation"
  std::string crs_name;        // for people, beside the facade's EPSG code
  std::string heights;         // their datum; empty: the sheet says that the heights are those of the points
  std::string data_date;       // of the scan, not of the run; empty: the sheet says that it is unknown
  std::string source;          // of the points
  SectionRequests sections;    // where they are cut is marked
  SheetLanguage language = SheetLanguage::english;
};

// Returns everything that is drawn of a facade: elements with real arcs by kind and status, hatched shadows, the plan
// widened by its errors, numbers, levels, dimensions, frame and title block. x runs from the facade's origin to the
// right seen from outside, y is the height, both in metres.
Drawing facade_drawing(const Facade& facade, const FacadeDrawingParams& params = {});

// Returns the houses of a row side by side on one sheet, from left to right in the order given (one at least): their
// lines as facade_drawing() draws them, projected onto the upright plane from the left end of the first to the right
// end of the last one, and below each its number, its width and how far it stands before or behind the one on its left.
// The scale is params.scale or the next of 2, 4, 10 and 20 times it at which the row is at most a metre wide on paper.
Drawing row_drawing(std::span<const Facade> houses, const FacadeDrawingParams& params = {});

// Returns the lines of a title block: CRS, heights, place (a line that the caller gives), date, accuracy and source,
// one line each.
std::vector<std::string> facade_reference(const Facade& facade, const FacadeDrawingParams& params,
                                          const std::string& place);

// Returns "Scale 1:50".
std::string scale_text(const FacadeDrawingParams& params);

}  // namespace ilot
