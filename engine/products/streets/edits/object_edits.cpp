// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/edits/object_edits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/model/point_label.h"
#include "engine/products/product_edits.h"
#include "engine/products/streets/objects/moment_rectangle.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr const char* kNothingThere = "nothing that stands on the ground was found within half a metre of its place";

double feature(const ObjectCandidate& c, CandidateFeature f) {
  return c.features[static_cast<std::size_t>(f)];
}
double feature(const ObjectCandidate& c, ComponentFeature f) {
  return c.features[static_cast<std::size_t>(f)];
}

// Weight, mean and covariance of the pixels of a candidate, in pixels. The inverse of moment_rectangle().
struct PixelMoments {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

  PixelMoments(const ObjectCandidate& c, double pixel) : n(c.pixels), x(c.middle_x), y(c.middle_y) {
    const auto variance = [&](double side) { return std::max(0.0, (side * side / (pixel * pixel) - 1) / 12); };
    const double along = variance(c.length), across = variance(c.width);
    const double cosine = cos_degrees(c.heading_deg), sine = cos_degrees(c.heading_deg - 90);
    xx = along * cosine * cosine + across * sine * sine;
    yy = along * sine * sine + across * cosine * cosine;
    xy = (along - across) * sine * cosine;
  }

  void add(const PixelMoments& o) {
    const double all = n + o.n, share = n * o.n / (all * all), dx = o.x - x, dy = o.y - y;
    const auto pooled = [&](double a, double b, double between) { return (n * a + o.n * b) / all + share * between; };
    xx = pooled(xx, o.xx, dx * dx), xy = pooled(xy, o.xy, dx * dy), yy = pooled(yy, o.yy, dy * dy);
    x += dx * o.n / all, y += dy * o.n / all;
    n = all;
  }
};

// Describes the join of two candidates as far as objects need it: place, size, height and points.
ObjectCandidate joined(const ObjectCandidate& a, const ObjectCandidate& b, double pixel) {
  ObjectCandidate out = a;
  PixelMoments both(a, pixel);
  both.add(PixelMoments(b, pixel));
  const MomentRectangle rectangle = moment_rectangle(both.xx, both.xy, both.yy, pixel);
  out.length = rectangle.length, out.width = rectangle.width, out.heading_deg = rectangle.heading_deg;
  out.middle_x = both.x, out.middle_y = both.y;
  const auto low = [](const ObjectCandidate& c) {
    return feature(c, CandidateFeature::low_share) * static_cast<double>(c.points);
  };
  const double low_a = low(a), low_b = low(b), all = low_a + low_b;
  if (all > 0) out.x = (low_a * a.x + low_b * b.x) / all, out.y = (low_a * a.y + low_b * b.y) / all;
  out.ground = std::min(a.ground, b.ground);
  out.own_top = std::max(a.own_top, b.own_top);
  out.points = a.points + b.points;
  out.pixels = a.pixels + b.pixels;
  const auto set = [&](ComponentFeature f, double v) { out.features[static_cast<std::size_t>(f)] = v; };
  set(ComponentFeature::area, feature(a, ComponentFeature::area) + feature(b, ComponentFeature::area));
  set(ComponentFeature::max_height,
      std::max(feature(a, ComponentFeature::max_height), feature(b, ComponentFeature::max_height)));
  return out;
}

class ObjectEditor {
 public:
  ObjectEditor(const PartAt& part_at, double pixel, SelectedObjects& objects)
      : part_at_(part_at), pixel_(pixel), o_(objects) {
    joined_by_.assign(o_.candidates.size(), 0);
    edit_of_.assign(o_.candidates.size(), nullptr);
    for (std::uint32_t i = 0; i < o_.candidates.size(); ++i)
      for (const std::uint32_t part : o_.candidates[i].parts)
        if (part != 0) joined_by_[part - 1] = i + 1;
  }

  EditResult make(const Edit& edit) {
    std::vector<std::uint32_t> at;
    for (const Vec3& place : edit.at) {
      const std::uint32_t part = part_at_(place);
      if (part == 0) return {EditOutcome::without_partner, kNothingThere};
      at.push_back(part);
    }
    switch (edit.action) {
      case EditAction::added:
        return is_object(whole(at[0])) && edit_of_[whole(at[0]) - 1] == nullptr ? again(edit, whole(at[0]))
                                                                                : name(edit, whole(at[0]), edit.kind);
      case EditAction::kind:
        return name(edit, whole(at[0]), edit.to_kind);
      case EditAction::deleted:
        return remove(edit, whole(at[0]));
      case EditAction::merged:
        return merge(edit, whole(at[0]), whole(at[1]));
      default:
        return split(edit, at[0], at[1]);
    }
  }

 private:
  // The number of the taken candidate that contains the one with this number.
  std::uint32_t whole(std::uint32_t number) const {
    while (o_.taken[number - 1] == 0 && joined_by_[number - 1] != 0) number = joined_by_[number - 1];
    return number;
  }

  bool is_object(std::uint32_t number) const { return is_street_object(o_.classes[number - 1].label); }

  void decide(const Edit& edit, std::uint32_t number, PointLabel label) {
    o_.classes[number - 1].label = label;
    o_.classes[number - 1].probability = 1;
    o_.by_hand[number - 1] = 1;
    edit_of_[number - 1] = &edit;
  }

  // The run found by itself what the edit adds: only its class may be another one.
  EditResult again(const Edit& edit, std::uint32_t number) {
    if (o_.classes[number - 1].label != *label_named(edit.kind)) return name(edit, number, edit.kind);
    decide(edit, number, *label_named(edit.kind));  // it stays, however long it is
    return {EditOutcome::repeated, {}};
  }

  EditResult name(const Edit& edit, std::uint32_t number, const std::string& kind) {
    const PointLabel label = *label_named(kind);
    const Edit* earlier = edit_of_[number - 1];
    if (earlier != nullptr && o_.classes[number - 1].label == label) return {EditOutcome::repeated, {}};
    if (earlier != nullptr && decides_class(*earlier)) refuse_contradiction(*earlier, edit);
    decide(edit, number, label);
    return {};
  }

  EditResult remove(const Edit& edit, std::uint32_t number) {
    const Edit* earlier = edit_of_[number - 1];
    if (earlier != nullptr && earlier->action == EditAction::deleted) return {EditOutcome::repeated, {}};
    if (earlier != nullptr && decides_class(*earlier)) refuse_contradiction(*earlier, edit);
    if (!is_object(number)) return {EditOutcome::without_partner, "no object stands at its place"};
    decide(edit, number, PointLabel::none);
    return {};
  }

  static bool decides_class(const Edit& edit) {
    return edit.action == EditAction::added || edit.action == EditAction::kind || edit.action == EditAction::deleted ||
           !edit.to_kind.empty();
  }

  EditResult merge(const Edit& edit, std::uint32_t a, std::uint32_t b) {
    if (a == b && !edit.to_kind.empty()) return name(edit, a, edit.to_kind);
    if (a == b) return {EditOutcome::repeated, {}};
    if (!is_object(a) && edit.to_kind.empty())
      return {EditOutcome::without_partner, "no object stands at its first place; to_kind says what both are"};
    const PointLabel label = edit.to_kind.empty() ? o_.classes[a - 1].label : *label_named(edit.to_kind);
    o_.taken[a - 1] = o_.taken[b - 1] = 0;
    const std::uint32_t join = joined_by_[a - 1];
    if (join == 0 || join != joined_by_[b - 1]) {
      append_join(a, b);
    } else {
      o_.taken[join - 1] = 1;
    }
    decide(edit, whole(a), label);
    return {};
  }

  void append_join(std::uint32_t a, std::uint32_t b) {
    ObjectCandidate join = joined(o_.candidates[a - 1], o_.candidates[b - 1], pixel_);
    join.parts[0] = a, join.parts[1] = b;
    o_.candidates.push_back(join);
    o_.classes.push_back(o_.classes[a - 1]);
    o_.taken.push_back(1);
    o_.by_hand.push_back(0);
    edit_of_.push_back(nullptr);
    joined_by_.push_back(0);
    joined_by_[a - 1] = joined_by_[b - 1] = static_cast<std::uint32_t>(o_.candidates.size());
  }

  EditResult split(const Edit& edit, std::uint32_t a, std::uint32_t b) {
    if (a == b)
      return {EditOutcome::without_partner, "what stands at both places is one part, which has no border inside"};
    if (whole(a) != whole(b)) return {EditOutcome::repeated, {}};
    const CandidateClass of_both = o_.classes[whole(a) - 1];
    if (!is_object(whole(a))) return {EditOutcome::without_partner, "no object stands at its places"};
    const Edit* earlier = edit_of_[whole(a) - 1];
    const bool named = earlier != nullptr && decides_class(*earlier);  // the parts are what a person called the whole
    while (whole(a) == whole(b)) {
      const std::uint32_t number = whole(a);
      o_.taken[number - 1] = 0;
      for (const std::uint32_t part : o_.candidates[number - 1].parts) {
        o_.taken[part - 1] = 1;
        joined_by_[part - 1] = number;
        if (named || !is_object(part)) o_.classes[part - 1] = of_both;
        o_.by_hand[part - 1] = 1;
        edit_of_[part - 1] = &edit;
      }
    }
    return {};
  }

  const PartAt& part_at_;
  double pixel_;
  SelectedObjects& o_;
  std::vector<std::uint32_t> joined_by_;  // per candidate: the number of the join that contains it
  std::vector<const Edit*> edit_of_;      // per candidate: the last edit that decided it
};

}  // namespace

std::vector<EditResult> edit_objects(std::span<const Edit* const> edits, const PartAt& part_at, double pixel,
                                     SelectedObjects& objects) {
  ObjectEditor editor(part_at, pixel, objects);
  std::vector<EditResult> results;
  for (const Edit* edit : edits) results.push_back(editor.make(*edit));
  return results;
}

}  // namespace ilot
