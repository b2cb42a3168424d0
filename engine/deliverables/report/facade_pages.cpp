// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/facade_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "engine/deliverables/drawings/facade_drawing.h"
#include "engine/deliverables/layers/small_image.h"
#include "engine/deliverables/pages/facade_files.h"
#include "engine/deliverables/pages/facade_sheets.h"
#include "engine/deliverables/report/charts.h"
#include "engine/deliverables/report/html.h"
#include "engine/deliverables/report/packed.h"
#include "engine/deliverables/report/scene_facades.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/model/stated_errors.h"
#include "engine/report/counted.h"
#include "engine/report/progress.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFacadesListed = 400, kAtOnce = 16;
constexpr int kImagePixels = 900;

// The numbers of the facades whose JSON is among the files.
std::vector<std::uint32_t> facade_numbers(const ResultFolder& result) {
  constexpr std::string_view kBegin = "facades/facade-", kEnd = ".json";
  std::vector<std::uint32_t> numbers;
  for (const ResultRecord& file : result.files) {
    std::string_view name = file.path;
    if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) continue;
    name = name.substr(kBegin.size(), name.size() - kBegin.size() - kEnd.size());
    std::uint32_t number = 0;
    const auto [end, code] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (code == std::errc() && end == name.data() + name.size()) numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

struct ReadFacade {
  Facade facade;
  std::optional<Drawing> drawing;
  std::optional<SmallImage> image;
};

ReadFacade read_one(const ResultFolder& result, std::uint32_t number, const FacadeDrawingParams& params, bool drawn) {
  const std::filesystem::path base = result.path / "facades" / facade_name(number);
  ReadFacade read{read_facade_json(base.string() + ".json"), {}, {}};
  if (drawn) read.drawing = facade_drawing(read.facade, params);
  return read;
}

// The rows of the list of all facades, with what they state of themselves.
class FacadeList {
 public:
  void add(const Facade& facade) {
    const double error = seen_error_95(facade);
    std::size_t openings = 0, completed = 0;
    for (const FacadeElement& e : facade.elements) {
      openings += e.opening;
      completed += e.status != DrawnStatus::seen && e.status != DrawnStatus::by_hand;
      by_hand_ += e.status == DrawnStatus::by_hand;
      for (const FacadeEdge& edge : e.edges)
        if (edge.error_m > 0) {
          errors_.push_back(edge.error_m);
          statuses_.push_back(static_cast<int>(edge.status));
        }
    }
    if (++listed_ > kMostFacadesListed) return;
    table_.add({fmt::format("<a href=\"#facade/{0}\">{0}</a>", facade.id), number_text(facade.width_m, 2),
                number_text(facade.height_m, 2), grouped(facade.elements.size()), grouped(openings), grouped(completed),
                error > 0 ? number_text(1000 * error, 1) : "not stated"});
  }
  std::string html() const {
    constexpr std::array<double, 7> kEdges{0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2};
    std::string html;
    if (!errors_.empty())
      html += "<div class=\"charts\">" +
              chart_svg({"Edges by their stated error",
                         "mm",
                         {"seen", "completed", "occluded"},
                         histogram(errors_, statuses_, 3, kEdges, 1000, 0)}) +
              "</div>\n";
    if (by_hand_ > 0)
      html +=
          html_note(fmt::format("Corrected by hand (--edits): {}. The errors of what was drawn by hand are not stated.",
                                counted(by_hand_, "element")));
    if (listed_ > kMostFacadesListed)
      html += html_note(fmt::format("The {} largest of {} facades are listed.", kMostFacadesListed, grouped(listed_)));
    return html + table_.html();
  }

 private:
  HtmlTable table_{{{"facade"},
                    {"width, m", true},
                    {"height, m", true},
                    {"elements", true},
                    {"openings", true},
                    {"not wholly seen", true},
                    {"95 % of seen edges within, mm", true}},
                   true};
  std::vector<double> errors_;
  std::vector<int> statuses_;
  std::size_t listed_ = 0, by_hand_ = 0;
};

std::string data_link(const SmallImage& image) {
  return "data:image/jpeg;base64," + base64(image.jpeg);
}

}  // namespace

FacadePages facade_pages(const ResultFolder& result, const SceneFrame& frame, const ReportLimits& limits) {
  const std::vector<std::uint32_t> numbers = facade_numbers(result);
  FacadePages pages;
  pages.scene = Json::array();
  FacadeDrawingParams drawing;
  drawing.scale = result.run.value("parameters", Json::object()).value("facades.scale", drawing.scale);
  drawing.metres_per_unit = frame.metres_per_unit;
  FacadeSheets sheets({preset_layers("ilot"), "facades/", limits.sheet_bytes});
  FacadeList list;
  std::size_t image_bytes = 0;
  for (std::size_t from = 0; from < numbers.size(); from += kAtOnce) {
    std::vector<ReadFacade> read(std::min(kAtOnce, numbers.size() - from));
    const bool drawn = sheets.has_room();
    parallel_for(read.size(), [&](std::size_t i) { read[i] = read_one(result, numbers[from + i], drawing, drawn); });
    for (ReadFacade& one : read) {
      list.add(one.facade);
      pages.scene.push_back(scene_facade(one.facade, frame));
      const std::filesystem::path png = result.path / "facades" / (facade_name(one.facade.id) + ".png");
      if (drawn && image_bytes < limits.image_bytes) one.image = small_image(png, kImagePixels);
      std::optional<SvgUnderlay> underlay;
      if (one.image) {
        image_bytes += one.image->jpeg.size();
        underlay = SvgUnderlay{data_link(*one.image), one.image->place};
        const FlatBox& place = one.image->place;
        pages.scene.back()["image"] = {place.min.x, place.min.y, place.max.x, place.max.y};
      }
      if (one.drawing)
        sheets.add(one.facade, *one.drawing, underlay, frame.metres_per_unit);
      else
        sheets.add_link(one.facade);
    }
  }
  pages.html = html_section("facades", "Facades: " + grouped(numbers.size()), list.html() + sheets.html());
  return pages;
}

}  // namespace ilot
