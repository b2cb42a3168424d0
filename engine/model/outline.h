// SPDX-License-Identifier: Apache-2.0
// Outlines of planes, as the public interface has them.
#pragma once
#include "ilot/planes.h"
#include "kernels/core/types.h"
