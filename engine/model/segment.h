// SPDX-License-Identifier: Apache-2.0
// Planes and the values known of them. The public interface defines them.
#pragma once
#include "ilot/planes.h"
#include "kernels/core/types.h"
