// SPDX-License-Identifier: Apache-2.0
// Buildings as solids, as the public interface has them.
#pragma once
#include "ilot/roofs.h"
#include "kernels/core/types.h"
