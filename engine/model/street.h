// SPDX-License-Identifier: Apache-2.0
// The result of the street product, which the deliverables use. The public interface defines it.
#pragma once
#include "engine/model/point_label.h"
#include "ilot/streets.h"
