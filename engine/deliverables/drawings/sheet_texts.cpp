// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/sheet_texts.h"

#include <algorithm>
#include <array>

namespace ilot {
namespace {

// English, French, German, Dutch.
using Texts = std::array<const char*, kSheetLanguages>;

constexpr std::array<Texts, kSheetPhrases> kPhrases{{
    {"Elevation", "Élévation", "Ansicht", "Gevelaanzicht"},
    {"Row of facades", "Front de rue", "Abwicklung der Fassaden", "Gevelwand"},
    {"Section", "Coupe", "Schnitt", "Doorsnede"},
    {"Facade {}", "Façade {}", "Fassade {}", "Gevel {}"},
    {"{} facades", "{} façades", "{} Fassaden", "{} gevels"},
    {"Scale 1:{}", "Échelle 1:{}", "Maßstab 1:{}", "Schaal 1:{}"},
    {"{} m before", "{} m en saillie", "{} m vorspringend", "{} m naar voren"},
    {"{} m behind", "{} m en retrait", "{} m zurückspringend", "{} m terugliggend"},
    {"CRS: {}", "Système de coordonnées : {}", "Koordinatensystem: {}", "Coördinatenstelsel: {}"},
    {"Heights: {}", "Altitudes : {}", "Höhen: {}", "Hoogten: {}"},
    {"those of the points", "celles des points", "die der Punkte", "die van de punten"},
    {"Facade runs towards {} deg from grid north", "Direction de la façade : {} deg du nord de la carte",
     "Richtung der Fassade: {} Grad von Gitternord", "Richting van de gevel: {} graden vanaf kaartnoorden"},
    {"Metres, drawn 1:1 in model space", "Mètres, dessin 1:1 dans l'espace objet", "Meter, im Modellbereich 1:1",
     "Meter, 1:1 in de modelruimte"},
    {"Date of data: {}", "Date du relevé : {}", "Datum der Aufnahme: {}", "Datum van de opname: {}"},
    {"Accuracy: {}", "Précision : {}", "Genauigkeit: {}", "Nauwkeurigheid: {}"},
    {"95 % of seen edges within {} mm", "95 % des arêtes vues à {} mm près",
     "95 % der gesehenen Kanten innerhalb von {} mm", "95 % van de geziene randen binnen {} mm"},
    {"Source: {}", "Source : {}", "Quelle: {}", "Bron: {}"},
    {"Made with ilot {}", "Établi avec ilot {}", "Erstellt mit ilot {}", "Gemaakt met ilot {}"},
    {"not known", "non connu", "nicht bekannt", "niet bekend"},
    {"not stated", "non indiquée", "nicht angegeben", "niet vermeld"},
    {"x = 0 at E {} N {}, y is the height", "x = 0 à E {} N {}, y est l'altitude",
     "x = 0 bei E {} N {}, y ist die Höhe", "x = 0 bij E {} N {}, y is de hoogte"},
    {"x = 0, y = 0 at E {} N {}, seen from above", "x = 0, y = 0 à E {} N {}, vu d'en haut",
     "x = 0, y = 0 bei E {} N {}, von oben gesehen", "x = 0, y = 0 bij E {} N {}, van boven gezien"},
    {"Section at {}", "Coupe à {}", "Schnitt in Höhe {}", "Doorsnede op {}"},
    {"Section at x = {}", "Coupe à x = {}", "Schnitt bei x = {}", "Doorsnede bij x = {}"},
    {"Section from E {} N {} to E {} N {}", "Coupe de E {} N {} à E {} N {}", "Schnitt von E {} N {} bis E {} N {}",
     "Doorsnede van E {} N {} tot E {} N {}"},
    {"Cut", "Coupé", "Geschnitten", "Doorgesneden"},
    {"Points near it", "Points proches", "Punkte nahebei", "Punten in de buurt"},
}};

struct LegendText {
  DrawingRole role;
  Texts texts;
};
using R = DrawingRole;
constexpr std::array<LegendText, 17> kLegend{{
    {R::outline, {"Outline", "Contour", "Umriss", "Omtrek"}},
    {R::opening, {"Opening", "Baie", "Öffnung", "Opening"}},
    {R::sill, {"Sill", "Appui", "Fensterbank", "Vensterbank"}},
    {R::lintel, {"Lintel, surround", "Linteau, encadrement", "Sturz, Einfassung", "Latei, omlijsting"}},
    {R::balcony, {"Balcony", "Balcon", "Balkon", "Balkon"}},
    {R::band, {"Band, cornice", "Bandeau, corniche", "Gurt, Gesims", "Band, kroonlijst"}},
    {R::stone, {"Stone", "Pierre", "Stein", "Steen"}},
    {R::joint, {"Joint", "Joint", "Fuge", "Voeg"}},
    {R::bulge, {"Bulge", "Saillie", "Vorsprung", "Uitstulping"}},
    {R::irregularity,
     {"Irregularity (layer frozen)", "Irrégularité (calque gelé)", "Unebenheit (Layer gefroren)",
      "Oneffenheid (laag bevroren)"}},
    {R::detail, {"Detail", "Détail", "Detail", "Detail"}},
    {R::hidden, {"Hidden", "Caché", "Verdeckt", "Verborgen"}},
    {R::completed, {"Completed", "Complété", "Ergänzt", "Aangevuld"}},
    {R::occluded, {"Not seen", "Non vu", "Nicht gesehen", "Niet gezien"}},
    {R::possible, {"Possible opening", "Baie possible", "Mögliche Öffnung", "Mogelijke opening"}},
    {R::error, {"Error (layer frozen)", "Erreur (calque gelé)", "Fehler (Layer gefroren)", "Fout (laag bevroren)"}},
    {R::ground, {"Foot of the wall", "Pied du mur", "Mauerfuß", "Voet van de muur"}},
}};

}  // namespace

const char* text_of(SheetPhrase phrase, SheetLanguage language) {
  return kPhrases.at(static_cast<std::size_t>(phrase)).at(static_cast<std::size_t>(language));
}

const char* legend_text(DrawingRole role, SheetLanguage language) {
  const auto found = std::find_if(kLegend.begin(), kLegend.end(), [&](const LegendText& t) { return t.role == role; });
  return found == kLegend.end() ? nullptr : found->texts.at(static_cast<std::size_t>(language));
}

bool has_decimal_comma(SheetLanguage language) {
  return language != SheetLanguage::english;
}

std::string number_text(double value, int decimals, bool comma) {
  std::string text = decimal(value, decimals);
  if (comma) std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

}  // namespace ilot
