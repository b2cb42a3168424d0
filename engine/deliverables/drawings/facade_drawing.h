// SPDX-License-Identifier: Apache-2.0
// A facade as a surveyor's elevation drawing, before it becomes DXF or SVG.
#pragma once
#include <string>
#include <vector>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/model/facade.h"

namespace ilot {

struct FacadeDrawingParams {
  double scale = 50;           // 1 : scale, sets sizes of texts and paper
  double metres_per_unit = 1;  // of the CRS, in all three axes
  std::string title;           // empty: "Elevation"
  std::string crs_name;        // for people, beside the facade's EPSG code
  std::string heights;         // their datum; empty: said to be those of the points
  std::string data_date;       // of the scan, not of the run; empty: said to be unknown
  std::string source;          // of the points
};

// All that is drawn of it: elements with real arcs by kind and status, shadows hatched, the plan widened by its errors,
// numbers, levels, dimensions, frame, title block. x from the facade's origin to the right seen from outside, y the
// height, in metres.
Drawing facade_drawing(const Facade& facade, const FacadeDrawingParams& params = {});

// What a title block tells of CRS, heights, place (a line of the caller's), date, accuracy and source, a line each.
std::vector<std::string> facade_reference(const Facade& facade, const FacadeDrawingParams& params,
                                          const std::string& place);

// The error that 95 of 100 edges with a known one do not exceed, in metres; 0 when none has one.
double edge_error_95(const Facade& facade);

}  // namespace ilot
