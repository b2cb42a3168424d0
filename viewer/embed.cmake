# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT, a C++ source with the files STYLE, PAGE (a list, joined) and VIEWER as strings. A script, run by
cmake_minimum_required(VERSION 3.25)
# cmake -P. Lists of CMake are avoided: texts hold semicolons and brackets, which these would change.
file(READ "${STYLE}" style)
file(READ "${VIEWER}" viewer)
set(page "")
foreach(file IN LISTS PAGE)
  file(READ "${file}" part)
  string(APPEND page "${part}")
endforeach()
set(text [[// Made by viewer/embed.cmake.
#include "engine/deliverables/pages/page_parts.h"

namespace ilot {

std::string_view page_style() {
  static constexpr char kText[] = R"ilot-part(@style@)ilot-part";
  return {kText, sizeof kText - 1};
}

std::string_view page_script() {
  static constexpr char kText[] = R"ilot-part(@page@)ilot-part";
  return {kText, sizeof kText - 1};
}

std::string_view viewer_script() {
  static constexpr char kText[] = R"ilot-part(@viewer@)ilot-part";
  return {kText, sizeof kText - 1};
}

}  // namespace ilot
]])
string(REPLACE "@style@" "${style}" text "${text}")
string(REPLACE "@page@" "${page}" text "${text}")
string(REPLACE "@viewer@" "${viewer}" text "${text}")
file(WRITE "${OUTPUT}" "${text}")
