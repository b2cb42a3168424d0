// SPDX-License-Identifier: Apache-2.0
// The options of one run. The public interface defines them.
#pragma once
#include "ilot/run.h"
