// SPDX-License-Identifier: Apache-2.0
// Buildings as solids. The public interface defines them.
#pragma once
#include "ilot/roofs.h"
#include "kernels/core/types.h"
