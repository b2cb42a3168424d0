// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "engine/deliverables/drawings/drawing_layers.h"
#include "engine/deliverables/drawings/drawing_svg.h"
#include "engine/model/facade.h"

namespace ilot {

struct FacadeSheetsParams {
  DrawingLayers layers = preset_layers("ilot");
  std::string folder;                  // of the facades' files as seen from the page: "" or "facades/"
  std::size_t most_bytes = 64u << 20;  // of HTML: beyond it drawings and tables are left out, then only links are given
};

// The facades as HTML. For each there are counts, the drawing over its orthoimage with layers to switch, the occluded
// or completed parts with the reason, and links to the files. The evidence for each edge is shown at the pointer, in
// colour, and in a table together with that of the faces. The same facades in the same order give the same bytes. Of
// each facade the first 200 entries of the list and the first 1,000 of the table are shown.
class FacadeSheets {
 public:
  explicit FacadeSheets(FacadeSheetsParams params) : params_(std::move(params)) {}

  // The drawing is that of facade_drawing(). The image, if there is one, has a link that the page can follow.
  void add(const Facade& facade, const Drawing& drawing, const std::optional<SvgUnderlay>& image,
           double metres_per_unit = 1);

  // Adds a facade without its drawing: its counts and links.
  void add_link(const Facade& facade);

  bool has_room() const { return body_.size() < params_.most_bytes; }  // for more drawings
  std::size_t facades() const { return facades_; }
  std::string html() const;

 private:
  void count(const Facade& facade);
  std::string summary_of(const Facade& facade) const;

  FacadeSheetsParams params_;
  std::string body_;
  std::uint64_t facades_ = 0, drawn_ = 0, elements_ = 0, edges_ = 0, completed_edges_ = 0, occluded_edges_ = 0;
  std::map<std::string, std::map<DrawnStatus, std::uint64_t>> by_kind_;
};

}  // namespace ilot
