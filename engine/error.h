// SPDX-License-Identifier: Apache-2.0
// The one exception, as the public interface has it.
#pragma once
#include "ilot/error.h"
