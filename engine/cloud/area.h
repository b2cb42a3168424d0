// SPDX-License-Identifier: Apache-2.0
// The part of the ground that a run is asked for, as the public interface has it.
#pragma once
#include "ilot/geometry.h"
