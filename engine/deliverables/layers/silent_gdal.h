// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cpl_error.h>

namespace ilot {

// A handler of GDAL's errors that prints nothing. The caller asks CPLGetLastErrorMsg() for the message.
inline void keep_silent(CPLErr, CPLErrorNum, const char*) {}

}  // namespace ilot
