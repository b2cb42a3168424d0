// SPDX-License-Identifier: Apache-2.0
// What the street product returns and deliverables take, as the public interface has it.
#pragma once
#include "engine/model/point_label.h"
#include "ilot/streets.h"
