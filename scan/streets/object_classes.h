// SPDX-License-Identifier: Apache-2.0
// The class of each object that stands on a scanned street, by its variant. The table stands here alone.
#pragma once
#include <string_view>

#include "engine/model/point_label.h"
#include "scan/streets/artefact.h"

namespace ilot::scan {

// The class of a variant of scene `street` or of a kind of scene `street-wild`. A variant that is not in the table is
// of class `other`.
PointLabel object_class_of(std::string_view variant);

// Its group, one of the four classes of an artefact (group_of in engine/model/point_label.h).
ArtefactClass artefact_class_of(std::string_view variant);

}  // namespace ilot::scan
