// SPDX-License-Identifier: Apache-2.0
// What one run is asked to do, as the public interface has it.
#pragma once
#include "ilot/run.h"
