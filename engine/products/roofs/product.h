// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/product.h"

namespace ilot {

const Product& roofs_product();

}  // namespace ilot
