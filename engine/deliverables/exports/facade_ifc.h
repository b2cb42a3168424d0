// SPDX-License-Identifier: Apache-2.0
// facade-NNN.ifc: the plan of a facade in IFC 4.3.
#pragma once
#include <filesystem>

#include "engine/deliverables/exports/export_frame.h"
#include "engine/model/facade.h"

namespace ilot {

// An IfcWall extruded from the facade's outline into the building, with an IfcOpeningElement for each opening, filled
// by an IfcWindow or an IfcDoor where its kind is known, and IfcBuildingElementProxy for other elements with a depth.
// Sizes with their errors and the support by points are property sets. The wall's thickness is nominal: no scan from
// outside shows it. Openings in front of or behind the wall (of dormers) void nothing. The file is whole or not there.
void write_facade_ifc(const std::filesystem::path& path, const Facade& facade, const ExportFrame& frame);

}  // namespace ilot
