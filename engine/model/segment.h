// SPDX-License-Identifier: Apache-2.0
// Planes and what is known of them, as the public interface has it.
#pragma once
#include "ilot/planes.h"
#include "kernels/core/types.h"
