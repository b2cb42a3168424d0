// SPDX-License-Identifier: Apache-2.0
// The part of the ground that a run is limited to. The public interface defines it.
#pragma once
#include "ilot/geometry.h"
