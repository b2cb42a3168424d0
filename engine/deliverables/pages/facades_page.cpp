// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/pages/facades_page.h"

#include <fmt/format.h>

#include "engine/deliverables/pages/page_parts.h"
#include "engine/whole_file.h"

namespace ilot {

void FacadesPage::finish() {
  write_whole_file(path_, page_head("Facades") +
                              fmt::format("<main><section id=\"facades\"><h1>Facades: {}</h1>\n", sheets_.facades()) +
                              sheets_.html() + "</section></main>\n" + page_tail());
}

}  // namespace ilot
