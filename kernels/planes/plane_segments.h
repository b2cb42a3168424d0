// SPDX-License-Identifier: Apache-2.0
// The result of every method of plane extraction, as in the public interface.
#pragma once
#include "ilot/plane_search.h"
#include "kernels/core/types.h"
