// SPDX-License-Identifier: Apache-2.0
// The settings, which the public interface defines, and the words for choices. To add a setting, add a line to
// include/ilot/settings.h and a line to the table of parameters.cpp; TOML, --set, help, docs and run.json follow from
// these.
#pragma once
#include <array>
#include <span>
#include <string_view>

#include "ilot/settings.h"

namespace ilot {

// The words for choices in settings, in the order of their values.
constexpr std::array<std::string_view, 9> kPlaneMethods{"ransac",      "region_growing", "smooth_growing",
                                                        "split_merge", "hough",          "shape_ransac",
                                                        "roof_ransac", "facade_ransac",  "colour_ransac"};
constexpr std::span<const std::string_view> names_of(PlaneMethod) {
  return kPlaneMethods;
}

constexpr std::array<std::string_view, 4> kCleanings{"none", "density", "distance", "isolation"};
constexpr std::span<const std::string_view> names_of(Cleaning) {
  return kCleanings;
}

constexpr std::array<std::string_view, 2> kEpsilonBy{"noise", "knee"};
constexpr std::span<const std::string_view> names_of(EpsilonBy) {
  return kEpsilonBy;
}

constexpr std::array<std::string_view, 2> kStepSources{"stations", "neighbours"};
constexpr std::span<const std::string_view> names_of(StepSource) {
  return kStepSources;
}

constexpr std::array<std::string_view, 2> kBoundaryRules{"circumradius", "longest_edge"};
constexpr std::span<const std::string_view> names_of(BoundaryRule) {
  return kBoundaryRules;
}

constexpr std::array<std::string_view, 2> kEdgeLengths{"plane", "space"};
constexpr std::span<const std::string_view> names_of(EdgeLength) {
  return kEdgeLengths;
}

constexpr std::array<std::string_view, 2> kErosions{"everywhere", "outside"};
constexpr std::span<const std::string_view> names_of(Erosion) {
  return kErosions;
}

constexpr std::array<std::string_view, 2> kAttributeStyles{"plain", "roofer"};
constexpr std::span<const std::string_view> names_of(AttributeStyle) {
  return kAttributeStyles;
}

constexpr std::array<std::string_view, 2> kStreetViews{"street", "air"};
constexpr std::span<const std::string_view> names_of(StreetView) {
  return kStreetViews;
}

constexpr std::array<std::string_view, 3> kLayerNames{"ilot", "aia", "iso13567"};
constexpr std::span<const std::string_view> names_of(LayerNames) {
  return kLayerNames;
}

constexpr std::array<std::string_view, 4> kSheetLanguageNames{"en", "fr", "de", "nl"};
constexpr std::span<const std::string_view> names_of(SheetLanguage) {
  return kSheetLanguageNames;
}

}  // namespace ilot
