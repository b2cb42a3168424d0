// SPDX-License-Identifier: Apache-2.0
#include "engine/run/products.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/products/facades/product.h"
#include "engine/products/planes/product.h"
#include "engine/products/roofs/product.h"
#include "engine/products/streets/product.h"

namespace ilot {

std::span<const Product* const> all_products() {
  static const Product* const list[] = {&planes_product(), &roofs_product(), &facades_product(), &streets_product()};
  return list;
}

std::vector<const Product*> products_to_make(const std::vector<std::string>& asked) {
  std::vector<const Product*> among_planes, others, all;
  bool planes = false;
  for (const Product* product : all_products()) {
    if (std::find(asked.begin(), asked.end(), product->name) == asked.end()) continue;
    if (product == &planes_product())
      planes = true;
    else
      (product->found_among_planes ? among_planes : others).push_back(product);
  }
  if (planes || !among_planes.empty()) all.push_back(&planes_product());
  all.insert(all.end(), among_planes.begin(), among_planes.end());
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

void make_all(std::span<const Product* const> products, ProductRun& run,
              const std::function<void(const Product&)>& make) {
  run.outlines_wanted = std::ranges::any_of(products, &Product::found_among_planes);
  for (const Product* product : products) make ? make(*product) : product->make(run);
}

std::vector<ProductLabels> labels_of(std::span<const Product* const> made, ProductRun& run) {
  std::vector<ProductLabels> labels;
  for (const Product* product : all_products())
    if (std::ranges::find(made, product) != made.end()) labels.push_back(product->labels(run));
  run.planes.reset();
  return labels;
}

std::string product_lines(const std::vector<std::string>& asked, const RunRecord& record,
                          const std::filesystem::path& folder) {
  std::string text;
  for (const Product* product : all_products()) {
    const std::string made = product->summary(record);
    if (made.empty() || std::ranges::find(asked, product->name) == asked.end()) continue;
    const std::filesystem::path file = folder / product->main_file;
    text += fmt::format("{:<9}{}{}\n", product->name, made, std::filesystem::exists(file) ? ": " + file.string() : "");
  }
  return text;
}

}  // namespace ilot
