// SPDX-License-Identifier: Apache-2.0
// What wild scenes draw: the file is sound, values depend on nothing but seed, name and element, and callers can fix
// them and leave out families.
#include "scan/wild/draws.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "engine/error.h"
#include "kernels/core/portable_math.h"
#include "scan/scenes.h"

namespace ilot::scan {
namespace {

constexpr std::array<std::string_view, 1> kScannerGroup{"scanner"};
const std::string kHead = "name,unit,kind,from,to,weights,per,group,family,meaning,source\n";

SceneValues scanner_values() {
  return SceneValues(drawn_options(kScannerGroup));
}

double value_of(const TrueDraws& drawn, const std::string& name) {
  for (const TrueDraw& d : drawn.scene)
    if (d.name == name) return d.value;
  ADD_FAILURE() << name;
  return 0;
}

TEST(Distributions, EachRowIsSoundAndItsDrawsFillItsRange) {
  std::set<std::string_view> groups;
  for (const Distribution& row : distributions()) groups.insert(row.group);
  for (std::string_view group : groups) {
    const std::array<std::string_view, 1> one{group};
    const SceneValues values(drawn_options(one));
    Draws draws(values, one, 5);
    for (const Distribution& row : distributions()) {
      if (row.group != group || row.per == "scene") continue;
      double least = row.to, most = row.from;
      for (std::uint64_t i = 0; i < 400; ++i) {
        const double v = draws.number(row.name, i);
        least = std::min(least, v);
        most = std::max(most, v);
      }
      EXPECT_GE(least, std::min(row.from, 0.0)) << row.name;
      EXPECT_LE(most, row.to) << row.name;
      const double width = row.to - row.from;
      EXPECT_GE(most - least, row.kind == DistributionKind::choice ? 1 : 0.5 * width) << row.name;
    }
  }
}

TEST(Distributions, FaultsAreNamedWithTheirLine) {
  const auto fault = [](const std::string& text) {
    try {
      parse_distributions(text);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(fault(kHead + "a,m,uniform,1,2,,scene,g,,what,why\n"), "none");
  EXPECT_NE(fault("name\n").find("line 1: the header"), std::string::npos);
  EXPECT_NE(fault(kHead + "a,m,uniform,1,2,,scene,g,,what\n").find("line 2: has 10 fields"), std::string::npos);
  EXPECT_NE(fault(kHead + "a,m,uniform,3,2,,scene,g,,what,why\n").find("larger"), std::string::npos);
  EXPECT_NE(fault(kHead + "a,m,log_uniform,0,2,,scene,g,,what,why\n").find("logarithm"), std::string::npos);
  EXPECT_NE(fault(kHead + "a,m,triangle,0,2,,scene,g,,what,why\n").find("no kind"), std::string::npos);
  EXPECT_NE(fault(kHead + "a,-,choice,,,x:1,scene,g,,what,why\n").find("two names"), std::string::npos);
  EXPECT_NE(fault(kHead + "a,m,uniform,1,2,,scene,g,arches,what,why\n").find("needs 0"), std::string::npos);
  const std::string twice = "a,m,uniform,1,2,,scene,g,,what,why\n";
  EXPECT_NE(fault(kHead + twice + twice).find("line 3: 'a' comes twice"), std::string::npos);
}

TEST(Distributions, LogUniformHasItsMedianAtTheGeometricMean) {
  std::vector<double> densities;
  for (std::uint64_t seed = 0; seed < 500; ++seed)
    densities.push_back(Draws(scanner_values(), kScannerGroup, seed).number("density"));
  std::sort(densities.begin(), densities.end());
  EXPECT_NEAR(natural_log(densities[250]), natural_log(1000), 0.6);
  EXPECT_GE(densities.front(), 50);
  EXPECT_LE(densities.back(), 20000);
}

TEST(Draws, DependOnSeedNameAndElementOnly) {
  const SceneValues values = scanner_values();
  Draws first(values, kScannerGroup, 7), second(values, kScannerGroup, 7), other(values, kScannerGroup, 8);
  const double a = first.number("station_height", 1), b = first.number("station_height", 2);
  EXPECT_EQ(second.number("station_height", 2), b);  // another order
  EXPECT_EQ(second.number("station_height", 1), a);
  EXPECT_NE(a, b);
  EXPECT_NE(other.number("station_height", 1), a);
  EXPECT_NE(first.number("station_height", 1) - 1.4, first.number("station_along", 1) + 0.25);
  EXPECT_THROW(first.number("no_such_row"), Error);
}

// A row added to the file, in front of all others, changes no value: with the groups of other scenes the list is
// longer as well.
TEST(Draws, ANewParameterLeavesTheOthersAsTheyWere) {
  std::vector<std::string_view> all;
  for (const Distribution& row : distributions())
    if (std::find(all.begin(), all.end(), row.group) == all.end()) all.insert(all.begin(), row.group);
  all.insert(all.begin(), "a group without rows");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const TrueDraws few = Draws(scanner_values(), kScannerGroup, seed).drawn();
    const TrueDraws many = Draws(SceneValues(drawn_options(all)), all, seed).drawn();
    for (const TrueDraw& d : few.scene) EXPECT_EQ(value_of(many, d.name), d.value) << d.name;
  }
  // These values were written down when the rows were made. They change only with their own rows.
  Draws draws(scanner_values(), kScannerGroup, 0);
  EXPECT_EQ(draws.whole("stations"), 4);
  EXPECT_NEAR(draws.number("density"), 122.78410754976154, 1e-9);
}

TEST(Draws, ACallerFixesValuesAndChoices) {
  SceneValues values = scanner_values();
  values.set("scene.density=123");
  values.set("scene.platform=vehicle");
  const TrueDraws drawn = Draws(values, kScannerGroup, 3).drawn();
  EXPECT_EQ(value_of(drawn, "density"), 123);
  for (const TrueDraw& d : drawn.scene) {
    EXPECT_EQ(d.fixed, d.name == "density" || d.name == "platform");
    EXPECT_TRUE(d.name != "platform" || d.choice == "vehicle");
  }
  const TrueDraws free = Draws(scanner_values(), kScannerGroup, 3).drawn();
  EXPECT_EQ(value_of(free, "range_noise"), value_of(drawn, "range_noise"));
  EXPECT_THROW(values.set("scene.platform=boat"), Error);
  EXPECT_THROW(values.set("scene.density=1"), Error);
  EXPECT_EQ(values.json().find("range_noise"), std::string::npos);
  EXPECT_NE(values.json().find("\"density\":123"), std::string::npos);
}

TEST(Draws, AFamilyThatIsLeftOutIsNowhere) {
  SceneValues values = scanner_values();
  const std::vector<std::string_view> families = families_of(kScannerGroup);
  EXPECT_THROW(values.leave_out("vehicles,arcs", families), Error);
  values.leave_out("vehicles", families);
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    EXPECT_EQ(Draws(values, kScannerGroup, seed).choice("platform"), "stations");
  EXPECT_NE(values.json().find("\"without\":[\"vehicles\"]"), std::string::npos);
}

TEST(Draws, SummariesCountEachElementOnce) {
  const SceneValues values = scanner_values();
  Draws draws(values, kScannerGroup, 1);
  for (int again = 0; again < 3; ++again)
    for (std::uint64_t i = 0; i < 10; ++i) {
      draws.number("station_height", i);
      draws.happens("dropouts", i);
    }
  const TrueDraws drawn = draws.drawn();
  ASSERT_EQ(drawn.elements.size(), 1u);
  EXPECT_EQ(drawn.elements[0].name, "station_height");
  EXPECT_EQ(drawn.elements[0].elements, 10u);
  EXPECT_LE(drawn.elements[0].least, drawn.elements[0].mean);
  ASSERT_EQ(drawn.shares.size(), 1u);
  EXPECT_EQ(drawn.shares[0].elements, 10u);
  EXPECT_EQ(drawn.distributions, distributions_hash());
}

}  // namespace
}  // namespace ilot::scan
