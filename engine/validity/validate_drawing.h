// SPDX-License-Identifier: Apache-2.0
// Is a drawing for CAD what a surveyor can deliver?
#pragma once
#include <filesystem>
#include <vector>

#include "engine/deliverables/drawings/dxf_reader.h"
#include "engine/validity/validate_las.h"

namespace ilot {

// Rules, in the order in which findings come: unreadable, structure, units, layer, handle, number, empty, zero-length,
// open-ring, duplicate. One finding a rule (of layers one each), with how many break it and where the first one stands.
// Units other than metres are worth knowing, everything else is severe. Duplicates: the same kind on the same layer
// with the same corners to a hundredth of a millimetre, wherever a closed one begins and whichever way it runs. O(n log
// n).
std::vector<Finding> validate_drawing(const DxfDrawing& drawing);

// The same of a file; one that cannot be read is a finding.
std::vector<Finding> validate_drawing_file(const std::filesystem::path& path);

}  // namespace ilot
