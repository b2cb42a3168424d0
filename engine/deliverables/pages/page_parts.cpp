// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/pages/page_parts.h"

#include "engine/markup.h"

namespace ilot {

std::string page_head(std::string_view title) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width\"><title>" +
         escaped_markup(title) + "</title>\n<style>\n" + std::string(page_style()) + "</style></head><body>\n";
}

std::string page_tail(std::string_view script) {
  return "<script>\n" + std::string(page_script()) + "</script>\n" +
         (script.empty() ? "" : "<script>" + std::string(script) + "</script>\n") + "</body></html>\n";
}

}  // namespace ilot
