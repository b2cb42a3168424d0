// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a column of a table of points means, in both directions: tables/table.h reads them, export.h writes them.
namespace ilot::field_roles {

enum FieldRole : int {
  kExtra,
  kX,
  kY,
  kZ,
  kIntensity,
  kReturnNumber,
  kReturnCount,
  kClassification,
  kSynthetic,
  kKeyPoint,
  kWithheld,
  kOverlap,
  kChannel,
  kDirection,
  kEdge,
  kUserData,
  kAngle,
  kSourceId,
  kGpsTime,
  kRed,
  kGreen,
  kBlue,
  kNir,
  kPackedRgb  // only read
};

}  // namespace ilot::field_roles
