// SPDX-License-Identifier: Apache-2.0
// What every method of plane extraction returns, as the public interface has it.
#pragma once
#include "ilot/plane_search.h"
#include "kernels/core/types.h"
