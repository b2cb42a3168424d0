// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/crs_transform.h"

#include <proj.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "engine/error.h"
#include "engine/formats/crs.h"

namespace ilot {
namespace {

std::string definition_of(const Crs& crs) {
  return crs.wkt.empty() ? "EPSG:" + std::to_string(crs.epsg) : crs.wkt;
}

// A transformation with its context; for one thread at a time.
class Way {
 public:
  Way(const std::string& from, const std::string& to) : context_(proj_context_create()) {
    proj_log_level(context_, PJ_LOG_NONE);
    PJ* as_defined = proj_create_crs_to_crs(context_, from.c_str(), to.c_str(), nullptr);
    way_ = as_defined ? proj_normalize_for_visualization(context_, as_defined) : nullptr;
    proj_destroy(as_defined);
  }
  ~Way() {
    proj_destroy(way_);
    proj_context_destroy(context_);
  }
  Way(const Way&) = delete;
  Way& operator=(const Way&) = delete;

  bool exists() const { return way_ != nullptr; }
  void apply(std::span<Vec3> places) {
    const std::size_t step = sizeof(Vec3), n = places.size();
    proj_trans_generic(way_, PJ_FWD, &places[0].x, step, n, &places[0].y, step, n, &places[0].z, step, n, nullptr, 0,
                       0);
  }

 private:
  PJ_CONTEXT* context_;
  PJ* way_ = nullptr;
};

}  // namespace

// Transformations that no thread uses at the moment.
struct CrsTransform::Pool {
  std::string from, to;
  std::mutex mutex;
  std::vector<std::unique_ptr<Way>> free;
};

CrsTransform::CrsTransform(const Crs& from, const Crs& to) : pool_(std::make_unique<Pool>()) {
  pool_->from = definition_of(from);
  pool_->to = definition_of(to);
  pool_->free.push_back(std::make_unique<Way>(pool_->from, pool_->to));
  if (!pool_->free[0]->exists())
    throw Error("PROJ knows no way from " + from.name + " to " + to.name + "; give another --to-crs", ExitCode::usage);
}

CrsTransform::~CrsTransform() = default;

void CrsTransform::apply(std::span<Vec3> places) const {
  if (places.empty()) return;
  std::unique_ptr<Way> way;
  {
    const std::lock_guard lock(pool_->mutex);
    if (!pool_->free.empty()) {
      way = std::move(pool_->free.back());
      pool_->free.pop_back();
    }
  }
  if (!way) way = std::make_unique<Way>(pool_->from, pool_->to);
  way->apply(places);
  const std::lock_guard lock(pool_->mutex);
  pool_->free.push_back(std::move(way));
}

Crs utm_at(const Crs& crs, Vec3 place) {
  constexpr int kNorth = 32600, kSouth = 32700;  // EPSG codes before those of zone 1
  CrsTransform(crs, crs_from_epsg(4326)).apply(std::span(&place, 1));
  if (!std::isfinite(place.x) || !std::isfinite(place.y) || place.y < -80 || place.y > 84)
    throw Error("--to-crs utm: the cloud is not between 80 degrees south and 84 north, where UTM ends; give EPSG:n",
                ExitCode::usage);
  const int zone = std::clamp(static_cast<int>(std::floor((place.x + 180) / 6)) + 1, 1, 60);
  return crs_from_epsg((place.y < 0 ? kSouth : kNorth) + zone);
}

}  // namespace ilot
