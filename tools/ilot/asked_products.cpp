// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/asked_products.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/run/products.h"
#include "engine/settings/nearest_name.h"

namespace ilot {
namespace {

std::vector<std::string> product_names() {
  std::vector<std::string> names;
  for (const Product* product : all_products()) names.push_back(product->name);
  return names;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

std::vector<std::string> asked_products(std::vector<std::string> given) {
  const std::vector<std::string> known = product_names();
  if (given.empty()) throw Error("--products: names no product; there are: " + listed(known), ExitCode::usage);
  for (const std::string& product : given) {
    if (std::ranges::find(known, product) == known.end())
      throw Error("--products " + product + ": there is no such product" + did_you_mean(product, known) +
                      "; there are: " + listed(known),
                  ExitCode::usage);
  }
  std::ranges::sort(given);
  const auto repeated = std::ranges::unique(given);
  given.erase(repeated.begin(), repeated.end());
  return given;
}

}  // namespace ilot
