// SPDX-License-Identifier: Apache-2.0
#include "engine/store/columns.h"

#include <array>

#include "engine/store/extended_columns.h"

namespace ilot {

std::span<const ColumnInfo* const> all_columns() {
  using namespace columns;
  static constexpr const ColumnInfo* kAll[]{
      &kCodes.info,      &kOrder.info,       &kClass.info,      &kEchoes.info,     &kChunks.info,    &kRole.info,
      &kNormals.info,    &kColour.info,      &kStation.info,    &kSegment.info,    &kContacts.info,  &kExtended1.info,
      &kExtended2.info,  &kExtended3.info,   &kExtended4.info,  &kTally.info,      &kPlane.info,     &kTouches.info,
      &kShapeTally.info, &kShape.info,       &kCoincident.info, &kSeamRuns.info,   &kSeamEdges.info, &kBoundary.info,
      &kFacade.info,     &kClusterPart.info, &kCluster.info,    &kRoof.info,       &kStreet.info,    &kSorted.info,
      &kRowOrder.info,   &kPlaneRows.info,   &kStreetRows.info, &kFacadeRows.info, &kRoofRows.info};
  return kAll;
}

const PassInfo& info_of(Pass pass) {
  static constexpr std::array<PassInfo, kPasses> kInfo{
      {{"index", "runs", "reads the inputs, sorts their points and cuts them into blocks"},
       {"classes", "ground", "decides what each point is to buildings"},
       {"normals", "", "fits a normal to the neighbours of each point"},
       {"colours", "colours", "gathers the colours of the inputs"},
       {"stations", "sources", "gathers the stations of the inputs"},
       {"planes", "cells", "finds planes and curved shapes cell by cell"},
       {"contacts", "", "counts which planes of cells touch each other"},
       {"labels", "extension", "extends planes over the borders of cells and decides the plane of each point"},
       {"adjacency", "", "finds which planes touch each other, where and how"},
       {"shapes", "", "decides the curved shape of each point"},
       {"boundaries", "", "triangulates planes and keeps the edges of their boundaries"},
       {"facades", "", "labels the points of facades"},
       {"clusters", "", "joins the points of buildings that are near each other in plan"},
       {"roofs", "roofs", "labels the points of buildings"},
       {"streets", "streets", "labels the points of streets"},
       {"rows", "", "sorts the labels by input order"}}};
  return kInfo[static_cast<std::size_t>(pass)];
}

}  // namespace ilot
