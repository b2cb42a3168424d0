// SPDX-License-Identifier: Apache-2.0
// Measurements on the model of a building. The public interface defines them.
#pragma once
#include "ilot/roofs.h"
