// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// Returns the day on which a LAS file says that it was created, "2024-03-01". Empty when the file gives no day or an
// impossible one, and for other formats. Writers store the day of the file here, which may differ from the day of the
// scan.
std::string file_date(const CloudInfo& info);

}  // namespace ilot
