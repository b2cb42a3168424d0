// SPDX-License-Identifier: Apache-2.0
// Checks whether a CAD drawing is fit for delivery by a surveyor.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/deliverables/drawings/cad/dxf_reader.h"
#include "engine/validity/validate_las.h"

namespace ilot {

// The rules, in the order of the findings: unreadable, structure, units, layer, handle, number, empty, zero-length,
// open-ring, duplicate. There is one finding per rule (for layers, one per layer), with the number of entities that
// break it and the place of the first one. Units other than metres are information; all other findings are severe.
// Duplicates are entities of the same kind on the same layer with the same corners to a hundredth of a millimetre,
// whatever the start and the direction of a closed one. O(n log n).
std::vector<Finding> validate_drawing(const DxfDrawing& drawing);

// The same for a file; a file that cannot be read is a finding.
std::vector<Finding> validate_drawing_file(const std::filesystem::path& path);

}  // namespace ilot
