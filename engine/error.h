// SPDX-License-Identifier: Apache-2.0
// The only exception type. The public interface defines it.
#pragma once
#include "ilot/error.h"
