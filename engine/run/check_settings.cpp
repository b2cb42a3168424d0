// SPDX-License-Identifier: Apache-2.0
#include "engine/run/check_settings.h"

#include "engine/deliverables/drawings/named_sections.h"
#include "engine/error.h"
#include "engine/products/planes/make_boundaries.h"

namespace ilot {

void check_settings(const Settings& settings, const RunInputs& inputs) {
  check_section_lines(settings.facades.section_lines);
  const bool known = !scanners_of(inputs.stations, 1).empty();
  if (settings.boundaries.step == StepSource::stations && !known)
    throw Error("boundaries.step = stations: no station with its angular steps is known; give --stations",
                ExitCode::usage);
}

}  // namespace ilot
