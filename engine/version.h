// SPDX-License-Identifier: Apache-2.0
// What this build is, as the public interface has it.
#pragma once
#include "ilot/version.h"
