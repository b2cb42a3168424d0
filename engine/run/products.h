// SPDX-License-Identifier: Apache-2.0
// The list of products: the one place that knows them all.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/products/product.h"

namespace ilot {

// In the order in which people are told of them.
std::span<const Product* const> all_products();

// Those asked for and the planes that these need, in the order in which they are made.
std::vector<const Product*> products_to_make(const std::vector<std::string>& asked);

}  // namespace ilot
