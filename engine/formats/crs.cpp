// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/crs.h"

#include <proj.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>

#include "engine/error.h"

namespace ilot {
namespace {

struct ContextEnd {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct ObjectEnd {
  void operator()(PJ* object) const { proj_destroy(object); }
};
using Context = std::unique_ptr<PJ_CONTEXT, ContextEnd>;
using Object = std::unique_ptr<PJ, ObjectEnd>;

Context quiet_context() {
  Context context(proj_context_create());
  proj_log_level(context.get(), PJ_LOG_NONE);
  return context;
}

// Returns metres per unit of the axes; for a vertical CRS, of its only axis.
std::optional<double> metres_per_axis_unit(PJ_CONTEXT* context, const PJ* crs) {
  const Object system(proj_crs_get_coordinate_system(context, crs));
  if (!system) return std::nullopt;
  double factor = 0;
  if (!proj_cs_get_axis_info(context, system.get(), 0, nullptr, nullptr, nullptr, &factor, nullptr, nullptr, nullptr))
    return std::nullopt;
  if (!std::isfinite(factor) || factor <= 0) return std::nullopt;
  return factor;
}

int epsg_code(const PJ* object) {
  const char* authority = proj_get_id_auth_name(object, 0);
  const char* code = proj_get_id_code(object, 0);
  return authority && code && std::string(authority) == "EPSG" ? std::atoi(code) : 0;
}

// Returns the code of the CRS in the database that is certainly equal to this one; 0 when there is none.
int identified_code(PJ_CONTEXT* context, const PJ* crs) {
  int* confidence = nullptr;
  PJ_OBJ_LIST* list = proj_identify(context, crs, "EPSG", nullptr, &confidence);
  int code = 0;
  if (list && confidence && proj_list_get_count(list) > 0 && confidence[0] >= 90) {
    const Object best(proj_list_get(context, list, 0));
    if (best) code = epsg_code(best.get());
  }
  proj_int_list_destroy(confidence);
  proj_list_destroy(list);
  return code;
}

bool is_geographic(PJ_TYPE type) {
  return type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS || type == PJ_TYPE_GEOCENTRIC_CRS;
}

// Returns a part of a compound CRS, without the transformation that may be bound to it.
Object part_of(PJ_CONTEXT* context, const PJ* compound, int number) {
  Object part(proj_crs_get_sub_crs(context, compound, number));
  if (part && proj_get_type(part.get()) == PJ_TYPE_BOUND_CRS) part.reset(proj_get_source_crs(context, part.get()));
  return part;
}

std::string as_wkt(PJ_CONTEXT* context, const PJ* crs) {
  const char* wkt = proj_as_wkt(context, crs, PJ_WKT1_GDAL, nullptr);
  if (!wkt) wkt = proj_as_wkt(context, crs, PJ_WKT2_2019, nullptr);
  return wkt ? wkt : "";
}

// Returns what PROJ reports for a definition; nullopt when PROJ does not understand it.
std::optional<Crs> understand(const std::string& definition) {
  const Context context = quiet_context();
  Object whole(proj_create(context.get(), definition.c_str()));
  if (whole && proj_get_type(whole.get()) == PJ_TYPE_BOUND_CRS)
    whole.reset(proj_get_source_crs(context.get(), whole.get()));
  if (!whole || !proj_is_crs(whole.get())) return std::nullopt;
  Crs crs;
  crs.name = proj_get_name(whole.get()) ? proj_get_name(whole.get()) : "";
  crs.wkt = as_wkt(context.get(), whole.get());
  crs.epsg = epsg_code(whole.get());
  Object horizontal, vertical;
  if (proj_get_type(whole.get()) == PJ_TYPE_COMPOUND_CRS) {
    horizontal = part_of(context.get(), whole.get(), 0);
    vertical = part_of(context.get(), whole.get(), 1);
  }
  const PJ* plan = horizontal ? horizontal.get() : whole.get();
  if (crs.epsg == 0) crs.epsg = epsg_code(plan);
  if (crs.epsg == 0) crs.epsg = identified_code(context.get(), plan);
  crs.geographic = is_geographic(proj_get_type(plan));
  const std::optional<double> unit = metres_per_axis_unit(context.get(), plan);
  crs.metres_per_unit = crs.geographic ? 1 : unit.value_or(1);
  crs.metres_per_unit_z = crs.metres_per_unit;
  if (vertical) crs.metres_per_unit_z = metres_per_axis_unit(context.get(), vertical.get()).value_or(1);
  crs.unit_assumed = !crs.geographic && !unit;
  return crs;
}

// Takes a code or WKT. PROJ would search any other text among all names that it knows, which takes seconds.
std::optional<Crs> understand_text(const std::string& text) {
  const Context context = quiet_context();
  const bool code = (text.starts_with("EPSG:") || text.starts_with("epsg:")) &&
                    text.find_first_not_of("0123456789+", 5) == std::string::npos;
  const bool wkt = proj_context_guess_wkt_dialect(context.get(), text.c_str()) != PJ_GUESSED_NOT_WKT;
  return code || wkt ? understand(text) : std::nullopt;
}

std::optional<double> metres_of_unit_code(int code) {
  const Context context = quiet_context();
  double factor = 0;
  const char* category = nullptr;
  if (!proj_uom_get_info_from_database(context.get(), "EPSG", std::to_string(code).c_str(), nullptr, &factor,
                                       &category))
    return std::nullopt;
  return category && std::string(category) == "linear" && factor > 0 ? std::optional(factor) : std::nullopt;
}

std::string payload_text(const Vlr& vlr) {
  const char* begin = reinterpret_cast<const char*>(vlr.payload.data());
  return {begin, std::find(begin, begin + vlr.payload.size(), '\0')};
}

bool is_wkt_record(const Vlr& vlr) {
  if (vlr.record_id != 2112 && vlr.record_id != 4224) return false;
  if (vlr.user_id == "LASF_Projection" || vlr.user_id == "liblas") return true;
  const std::string text = payload_text(vlr).substr(0, 20);
  return text.find("CRS[") != std::string::npos || text.find("CS[") != std::string::npos;
}

std::optional<Crs> from_wkt(const std::vector<Vlr>& vlrs, std::vector<std::string>& warnings) {
  for (const Vlr& vlr : vlrs) {
    if (!is_wkt_record(vlr)) continue;
    const std::string text = payload_text(vlr);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) continue;
    std::optional<Crs> crs = understand_text(text);
    if (crs) {
      crs->wkt = text;
      return crs;
    }
    warnings.push_back("the WKT of record " + vlr.user_id + " " + std::to_string(vlr.record_id) +
                       " is not understood by PROJ");
  }
  return std::nullopt;
}

// Returns the keys whose value is in the directory itself; 0 and 32767 (user defined) have no meaning.
std::map<int, int> short_keys(const Vlr& vlr) {
  std::map<int, int> keys;
  if (vlr.payload.size() < 8) return keys;
  const auto word = [&](std::size_t i) { return load<std::uint16_t>(&vlr.payload[2 * i]); };
  const std::size_t count = std::min<std::size_t>(word(3), vlr.payload.size() / 8 - 1);
  for (std::size_t i = 1; i <= count; ++i) {
    const int value = word(4 * i + 3);
    if (word(4 * i + 1) == 0 && value != 0 && value != 32767) keys.emplace(word(4 * i), value);
  }
  return keys;
}

// Writers that name a metric CRS and a unit of feet mean feet. The CRS is then not that of the code.
void override_unit(Crs& crs, double unit, std::vector<std::string>& warnings) {
  if (crs.geographic || std::abs(unit - crs.metres_per_unit) <= 1e-9 * unit) return;
  warnings.push_back("the GeoTIFF keys give a unit of " + std::to_string(unit) + " m to " + crs.name +
                     ", which has another; the unit of the keys is used");
  crs.metres_per_unit = crs.metres_per_unit_z = unit;
  crs.epsg = 0;
  crs.wkt.clear();
}

std::optional<Crs> from_keys(const std::vector<Vlr>& vlrs, std::vector<std::string>& warnings) {
  const auto record = std::find_if(vlrs.begin(), vlrs.end(), [](const Vlr& vlr) {
    return vlr.record_id == 34735 && vlr.user_id == "LASF_Projection";
  });
  if (record == vlrs.end()) return std::nullopt;
  const std::map<int, int> keys = short_keys(*record);
  const auto key = [&](int id) { return keys.count(id) ? keys.at(id) : 0; };
  const int plan = key(3072) ? key(3072) : key(1024) == 1 ? 0 : key(2048);
  std::optional<Crs> crs;
  if (plan && key(4096)) crs = understand("EPSG:" + std::to_string(plan) + "+" + std::to_string(key(4096)));
  if (plan && !crs) crs = understand("EPSG:" + std::to_string(plan));
  if (plan && !crs) warnings.push_back("PROJ does not know EPSG:" + std::to_string(plan) + " of the GeoTIFF keys");
  const std::optional<double> unit = metres_of_unit_code(key(3076)), unit_z = metres_of_unit_code(key(4099));
  if (!crs && !unit && !unit_z && key(1024) != 2) return std::nullopt;
  if (!crs) {
    crs.emplace();
    crs->geographic = key(1024) == 2;
    crs->unit_assumed = !unit && !crs->geographic;
    if (unit) crs->metres_per_unit = crs->metres_per_unit_z = *unit;
  }
  if (unit) override_unit(*crs, *unit, warnings);
  if (unit_z) crs->metres_per_unit_z = *unit_z;
  return crs;
}

void put_key(std::vector<std::byte>& out, int id, int value) {
  for (const int word : {id, 0, 1, value}) {
    std::byte raw[2];
    store(raw, static_cast<std::uint16_t>(word));
    out.insert(out.end(), raw, raw + 2);
  }
}

// The codes by which GeoTIFF keys say a CRS.
struct KeyCodes {
  int plan = 0, heights = 0;  // 0: no heights of their own
};

// nullopt when a part has no code, or none that a key can hold.
std::optional<KeyCodes> key_codes(const Crs& crs) {
  constexpr int kUserDefined = 32767;  // Derived: GeoTIFF 1.0, section 6.3: from here on codes have another meaning
  const Context context = quiet_context();
  const Object whole(crs.wkt.empty() ? nullptr : proj_create(context.get(), crs.wkt.c_str()));
  const bool compound = whole && proj_get_type(whole.get()) == PJ_TYPE_COMPOUND_CRS;
  const auto code_of = [&](int number) {
    const Object part = part_of(context.get(), whole.get(), number);
    if (!part) return 0;
    const int code = epsg_code(part.get());
    return code != 0 ? code : identified_code(context.get(), part.get());
  };
  const auto fits = [](int code) { return code > 0 && code < kUserDefined; };
  const KeyCodes codes = compound ? KeyCodes{code_of(0), code_of(1)} : KeyCodes{crs.epsg, 0};
  if (!fits(codes.plan) || (compound && !fits(codes.heights))) return std::nullopt;
  return codes;
}

Vlr projection_record(std::uint16_t id, const char* description) {
  Vlr vlr;
  vlr.user_id = "LASF_Projection";
  vlr.record_id = id;
  vlr.description = description;
  return vlr;
}

// Heights above the ellipsoid, nearly: along the line to the centre, which differs from them by less than a metre.
bool is_near_the_surface(Vec3 place) {
  constexpr double kEquator = 6378137, kPole = 6356752.3;  // Derived: half axes of WGS 84, metres
  constexpr double kDeepest = -2000, kHighest = 12000;     // Choice: land and aircraft, and a datum beside WGS 84
  const double far = norm(place);
  if (!(far > 0)) return false;
  const double across = std::hypot(place.x, place.y) / far, up = place.z / far;
  const double height = far - kEquator * kPole / std::hypot(kPole * across, kEquator * up);
  return height >= kDeepest && height <= kHighest;
}

}  // namespace

Crs horizontal_crs(const Crs& crs) {
  const Context context = quiet_context();
  const std::string definition = crs.wkt.empty() ? "EPSG:" + std::to_string(crs.epsg) : crs.wkt;
  const Object whole(proj_create(context.get(), definition.c_str()));
  Crs plan = crs;
  if (whole && proj_get_type(whole.get()) == PJ_TYPE_COMPOUND_CRS) {
    const Object part(proj_crs_get_sub_crs(context.get(), whole.get(), 0));
    if (const auto understood = part ? understand(as_wkt(context.get(), part.get())) : std::nullopt) plan = *understood;
    plan.metres_per_unit = crs.metres_per_unit;
  }
  plan.metres_per_unit_z = plan.metres_per_unit;
  return plan;
}

bool is_geocentric(const Crs& crs) {
  if (!crs.geographic) return false;
  const Context context = quiet_context();
  const std::string definition = crs.wkt.empty() ? "EPSG:" + std::to_string(crs.epsg) : crs.wkt;
  Object whole(proj_create(context.get(), definition.c_str()));
  if (whole && proj_get_type(whole.get()) == PJ_TYPE_BOUND_CRS)
    whole.reset(proj_get_source_crs(context.get(), whole.get()));
  return whole && proj_get_type(whole.get()) == PJ_TYPE_GEOCENTRIC_CRS;
}

bool can_be_at(const Crs& crs, Vec3 place) {
  if (!crs.geographic) return true;
  if (is_geocentric(crs)) return is_near_the_surface(place);
  constexpr double kTurn = 360, kPole = 90;  // Derived: degrees of longitude (from 0 or from -180 on) and latitude
  return std::abs(place.x) <= kTurn && std::abs(place.y) <= kPole;
}

bool is_crs_record(const Vlr& vlr) {
  if (is_wkt_record(vlr)) return true;
  return vlr.user_id == "LASF_Projection" &&
         (vlr.record_id == 2111 || (vlr.record_id >= 34735 && vlr.record_id <= 34737));
}

Crs crs_from_vlrs(const std::vector<Vlr>& vlrs, bool wkt_flag, std::vector<std::string>& warnings) {
  const std::optional<Crs> keys = from_keys(vlrs, warnings);
  if (!wkt_flag && keys && keys->epsg != 0) return *keys;
  const std::optional<Crs> wkt = from_wkt(vlrs, warnings);
  if (wkt && !wkt_flag && !keys) warnings.push_back("the CRS was found as WKT although the header does not say so");
  if (wkt) return *wkt;
  if (wkt_flag && keys) warnings.push_back("the header says that the CRS is WKT, but only GeoTIFF keys give one");
  return keys.value_or(Crs{});
}

Crs crs_from_epsg(int code) {
  return crs_from_text("EPSG:" + std::to_string(code));
}

Crs crs_from_text(const std::string& text) {
  const bool number = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  const std::optional<Crs> crs = number ? understand("EPSG:" + text) : understand_text(text);
  if (!crs) throw Error("CRS " + text + " is not known to PROJ; give it as EPSG:n", ExitCode::usage);
  return *crs;
}

std::vector<Vlr> crs_records(const Crs& crs, bool as_wkt) {
  if (as_wkt && !crs.wkt.empty()) {
    Vlr vlr = projection_record(2112, "OGC WKT coordinate system");
    const auto* text = reinterpret_cast<const std::byte*>(crs.wkt.c_str());
    vlr.payload.assign(text, text + crs.wkt.size() + 1);
    return {vlr};
  }
  const std::optional<KeyCodes> codes = key_codes(crs);
  if (!codes) return {};
  Vlr vlr = projection_record(34735, "GeoTIFF GeoKeyDirectoryTag");
  for (const int word : {1, 1, 0, codes->heights != 0 ? 3 : 2}) {
    std::byte raw[2];
    store(raw, static_cast<std::uint16_t>(word));
    vlr.payload.insert(vlr.payload.end(), raw, raw + 2);
  }
  put_key(vlr.payload, 1024, crs.geographic ? 2 : 1);
  put_key(vlr.payload, crs.geographic ? 2048 : 3072, codes->plan);
  if (codes->heights != 0) put_key(vlr.payload, 4096, codes->heights);
  return {vlr};
}

void replace_crs(CloudInfo& info, const Crs& crs) {
  std::erase_if(info.vlrs, is_crs_record);
  info.crs = crs;
}

}  // namespace ilot
