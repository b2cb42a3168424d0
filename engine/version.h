// SPDX-License-Identifier: Apache-2.0
// The version of this build. The public interface defines it.
#pragma once
#include "ilot/version.h"
