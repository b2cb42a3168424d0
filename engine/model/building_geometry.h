// SPDX-License-Identifier: Apache-2.0
// What can be measured on a building's model, as the public interface has it.
#pragma once
#include "ilot/roofs.h"
