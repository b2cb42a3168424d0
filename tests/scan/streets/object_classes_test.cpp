// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/object_classes.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "scan/streets/objects/object_kinds.h"

namespace ilot::scan {
namespace {

TEST(ObjectClasses, EachClassHasKinds) {
  std::map<PointLabel, std::set<std::string_view>> kinds;
  for (const ObjectKind& kind : object_kinds()) kinds[object_class_of(kind.name)].insert(kind.name);
  for (const auto& [value, name] : point_label_names()) {
    const auto label = static_cast<PointLabel>(value);
    EXPECT_EQ(kinds.contains(label), is_street_object(label)) << name;
  }
  EXPECT_EQ(kinds[PointLabel::planter], (std::set<std::string_view>{"planter"}));
  EXPECT_EQ(kinds[PointLabel::bench], (std::set<std::string_view>{"bench", "stone_bench"}));
}

// The variants of scene `street` were made for four classes: their groups.
TEST(ObjectClasses, VariantsOfAStreetHaveTheirGroups) {
  for (const auto group :
       {ArtefactClass::car, ArtefactClass::lamppost, ArtefactClass::pedestrian, ArtefactClass::other})
    for (const std::string_view variant : variants_of(group)) EXPECT_EQ(artefact_class_of(variant), group) << variant;
}

TEST(ObjectClasses, WhatIsNotInTheTableIsOther) {
  EXPECT_EQ(object_class_of("shed"), PointLabel::other);
  EXPECT_EQ(object_class_of("lorry"), PointLabel::van);
  EXPECT_EQ(artefact_class_of("lorry"), ArtefactClass::car);
}

}  // namespace
}  // namespace ilot::scan
