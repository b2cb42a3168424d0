// SPDX-License-Identifier: Apache-2.0
// The values that a wild scene draws. Each is a pure function of the seed, the name of the parameter and the index of
// the element. The order of the calls does not matter, and a new parameter leaves the values of all others as they
// were.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/core/rng.h"
#include "scan/scene_options.h"
#include "scan/truth_writer.h"
#include "scan/wild/distributions.h"

namespace ilot::scan {

// Returns the index of an element by its numbers in the things that hold it: house, row, column...
std::uint64_t element_index(std::uint64_t first, std::uint64_t second = 0, std::uint64_t third = 0,
                            std::uint64_t fourth = 0);

class Draws {
 public:
  // Draws from the rows of these groups. `values` holds what the caller has fixed and the families that are left out:
  // a row of such a family has the value 0 and the first choice. Draws all rows that are drawn once for the scene, so
  // that they are recorded whether the scene needs them or not.
  Draws(const SceneValues& values, std::span<const std::string_view> groups, std::uint64_t seed);

  // Returns a value. Rows of the scene have the element 0. Throws Error when no row of the groups has this name.
  double number(std::string_view name, std::uint64_t element = 0);

  // Returns a value rounded to a whole number; of a choice, the index of its name.
  int whole(std::string_view name, std::uint64_t element = 0);

  // Returns the name that a choice has.
  std::string_view choice(std::string_view name, std::uint64_t element = 0);
  bool is(std::string_view name, std::string_view chosen, std::uint64_t element = 0) {
    return choice(name, element) == chosen;
  }

  // Decides for an element with the probability that the row gives, which is drawn once for `of`. The share of
  // elements for which it was true is recorded.
  bool happens(std::string_view share, std::uint64_t element, std::uint64_t of = 0);

  // Returns random numbers for a use that no row describes (leaves, the sides of things). They are keyed by its name.
  Rng random(std::string_view use, std::uint64_t element = 0) const;

  // Returns what was drawn so far: the values of the scene in the order of the file, and summaries of what was drawn
  // for elements. Elements count once however often they are asked for.
  TrueDraws drawn() const;

 private:
  struct Record {
    const Distribution* row = nullptr;
    std::map<std::uint64_t, double> values;  // by element
    std::map<std::uint64_t, bool> happened;  // by element, for shares
  };
  Record& record_of(std::string_view name);
  double draw(const Distribution& row, std::uint64_t element) const;

  const SceneValues values_;
  std::uint64_t seed_;
  std::vector<Record> records_;
  std::map<std::string_view, std::size_t> index_;
};

}  // namespace ilot::scan
