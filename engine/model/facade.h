// SPDX-License-Identifier: Apache-2.0
// The plan of one facade. The public interface defines it.
#pragma once
#include "ilot/facades.h"
#include "kernels/core/types.h"
