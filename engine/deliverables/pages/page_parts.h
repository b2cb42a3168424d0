// SPDX-License-Identifier: Apache-2.0
// What all pages share: the look, the scripts, and the viewer. Their sources are in viewer/; the build puts them here.
#pragma once
#include <string>
#include <string_view>

namespace ilot {

std::string_view page_style();     // CSS: light and dark, screen and paper
std::string_view page_script();    // links, tables, the plan; needs no library
std::string_view viewer_script();  // the viewer with three.js; empty where ilot was built without npm

// The beginning of a page up to <body>, and its end with the scripts of pages and, after them, another script.
std::string page_head(std::string_view title);
std::string page_tail(std::string_view script = {});

}  // namespace ilot
