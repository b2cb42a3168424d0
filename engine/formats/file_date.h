// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// The day that a LAS file says it was made, "2024-03-01"; empty where it says none or one that there is not, and for
// other formats. Writers put there the day of the file, which need not be that of the scan.
std::string file_date(const CloudInfo& info);

}  // namespace ilot
