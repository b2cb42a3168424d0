// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/pages/page_parts.h"

#include "engine/markup.h"

namespace ilot {
namespace {

// A house as the sign of the page. Without one, browsers ask the server of `ilot view` for a file that does not exist.
const std::string kIcon =
    "<link rel=\"icon\" href=\"data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 8 "
    "8'%3E%3Cpath "
    "d='M1 7V3l3-2 3 2v4z' fill='%232b83c6'/%3E%3C/svg%3E\">";

}  // namespace

std::string page_head(std::string_view title) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width\">" +
         kIcon + "<title>" + escaped_markup(title) + "</title>\n<style>\n" + std::string(page_style()) +
         "</style></head><body>\n";
}

std::string page_tail(std::string_view script) {
  return "<script>\n" + std::string(page_script()) + "</script>\n" +
         (script.empty() ? "" : "<script>" + std::string(script) + "</script>\n") + "</body></html>\n";
}

}  // namespace ilot
