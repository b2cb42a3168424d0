// SPDX-License-Identifier: Apache-2.0
// Outlines of planes. The public interface defines them.
#pragma once
#include "ilot/planes.h"
#include "kernels/core/types.h"
