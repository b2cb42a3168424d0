// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/sheet_texts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/deliverables/drawings/facade_drawing.h"
#include "tests/support/facades.h"

namespace ilot {
namespace {

std::size_t places_in(const std::string& text) {
  std::size_t places = 0;
  for (std::size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}", at + 2)) ++places;
  return places;
}

// Every text is there in every language, as valid UTF-8, with room for as many values as in English.
TEST(SheetTexts, NoneIsMissing) {
  for (std::size_t language = 0; language < kSheetLanguages; ++language) {
    const auto in = static_cast<SheetLanguage>(language);
    for (std::size_t i = 0; i < kSheetPhrases; ++i) {
      const char* text = text_of(static_cast<SheetPhrase>(i), in);
      const char* english = text_of(static_cast<SheetPhrase>(i), SheetLanguage::english);
      ASSERT_NE(text, nullptr) << i;
      EXPECT_GT(std::string(text).size(), 0u) << i;
      EXPECT_EQ(clean_text(text), text);
      EXPECT_EQ(places_in(text), places_in(english)) << text;
    }
    for (std::size_t i = 0; i < kDrawingRoles; ++i) {
      const auto role = static_cast<DrawingRole>(i);
      const char *text = legend_text(role, in), *english = legend_text(role, SheetLanguage::english);
      ASSERT_EQ(text == nullptr, english == nullptr) << name_of(role);
      if (text != nullptr) {
        EXPECT_EQ(clean_text(text), text);
        EXPECT_FALSE(std::string(text).empty());
      }
    }
  }
  EXPECT_EQ(static_cast<std::size_t>(SheetPhrase::points_near) + 1, kSheetPhrases);
}

bool drawing_says(const Drawing& drawing, const std::string& words) {
  const Drawing flat = flattened(drawing);
  return std::any_of(flat.texts.begin(), flat.texts.end(),
                     [&](const DrawingText& text) { return text.text.find(words) != std::string::npos; });
}

TEST(SheetTexts, ADrawingIsInItsLanguage) {
  const Facade facade =
      facade_of({drawn("window", wall_rectangle(1, 1, 2.25, 3)), drawn("outline", wall_rectangle(0, 0, 9, 6))});
  FacadeDrawingParams params;
  params.language = SheetLanguage::german;
  params.sections.levels = {1.5};
  const Drawing german = facade_drawing(facade, params);
  for (const char* words : {"Ansicht", "Fassade 1", "Maßstab 1:50", "Quelle: nicht angegeben", "1,25", "Öffnung",
                            "Mauerfuß", "Schnitt in Höhe 1,50"})
    EXPECT_TRUE(drawing_says(german, words)) << words;
  for (const char* words : {"Elevation", "Facade", "Scale", "Source", "1.25", "Opening", "Section"})
    EXPECT_FALSE(drawing_says(german, words)) << words;
  params.language = SheetLanguage::french;
  EXPECT_TRUE(drawing_says(facade_drawing(facade, params), "Façade 1"));
  params.language = SheetLanguage::dutch;
  EXPECT_TRUE(drawing_says(facade_drawing(facade, params), "Schaal 1:50"));
  params.language = SheetLanguage::english;
  EXPECT_TRUE(drawing_says(facade_drawing(facade, params), "1.25"));
}

}  // namespace
}  // namespace ilot
