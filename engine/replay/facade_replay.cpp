// SPDX-License-Identifier: Apache-2.0
#include "engine/replay/facade_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "engine/deliverables/pages/facade_files.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/error.h"
#include "engine/products/facades/facade_labels.h"
#include "engine/products/facades/make_facades.h"
#include "engine/replay/kept_planes.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostPoints = 1u << 19;  // that are shown

fs::path json_of(const fs::path& out, std::uint32_t id) {
  return out / "facades" / (facade_name(id) + ".json");
}

std::uint32_t count_facades(const fs::path& out) {
  std::uint32_t count = 0;
  while (fs::exists(json_of(out, count + 1))) ++count;
  return count;
}

std::uint32_t number_of(const std::string& id, const fs::path& out) {
  std::uint32_t number = 0;
  const auto [end, fault] = std::from_chars(id.data(), id.data() + id.size(), number);
  const std::uint32_t count = count_facades(out);
  if (fault == std::errc() && end == id.data() + id.size() && number >= 1 && number <= count) return number;
  throw Error("facade:" + id + ": the run had no such facade; " +
                  (count == 0 ? std::string("it had none") : "they are facade:1 to facade:" + std::to_string(count)),
              ExitCode::usage);
}

std::vector<WallPoint> points_of(const RaySamples& samples) {
  std::vector<WallPoint> points;
  Rays all = samples.all();
  const std::uint64_t every = 1 + all.size() / kMostPoints;
  std::uint64_t number = 0;
  for (const Ray& ray : all) {
    if (number++ % every != 0) continue;
    points.push_back({{ray.at.u, ray.at.v, ray.at.w},
                      samples.crossing(ray, 0),
                      ray.at.plane,
                      samples.on_wall(ray),
                      samples.met(ray, 0, samples.site().epsilon)});
  }
  return points;
}

// The labels of the run are read before the new ones replace them in the scratch store.
std::uint64_t changed_labels(const KeptRun& run, const FacadesOfRun& facades, std::uint32_t id) {
  const Store& store = run.store();
  const auto blocks = static_cast<std::uint32_t>(store.blocks().size());
  std::vector<std::vector<FacadeLabel>> before;
  for (std::uint32_t b = 0; b < blocks; ++b) before.push_back(store.read(b, columns::kFacade));
  write_facade_labels(facades.work, facades.walls, facades.found, run.context());
  std::uint64_t changed = 0;
  for (std::uint32_t b = 0; b < blocks; ++b) {
    const auto now = store.read(b, columns::kFacade);
    for (std::size_t i = 0; i < now.size(); ++i) {
      const FacadeLabel &p = before[b][i], &q = now[i];
      if (p.facade != id && q.facade != id) continue;
      changed += p.facade != q.facade || p.element != q.element || p.label != q.label;
    }
  }
  return changed;
}

}  // namespace

FacadeReplay replay_facade(const KeptRun& run, const std::string& id, Progress& progress) {
  if (!run.made("facades"))
    throw Error("facade:" + id + ": the run made no facades (--products facades)", ExitCode::usage);
  FacadeReplay replay;
  const std::uint32_t number = number_of(id, run.options().output);
  const auto planes = kept_planes(run, progress);
  RunRecord record;
  const FacadeObserver observer{number, replay.steps, [&](const RaySamples& samples) {
                                  replay.site = samples.site();
                                  replay.points = points_of(samples);
                                }};
  const auto facades = find_facades(run.store(), *planes, run.options().settings, run.inputs(), run.context(), progress,
                                    record, &observer);
  progress.end_stage();
  if (number > facades->found.size())
    throw Error("facade:" + id + ": is not found any more; " + std::to_string(facades->found.size()) + " are");
  replay.facade = facades->found[number - 1].facade;
  replay.changed_labels = changed_labels(run, *facades, number);
  return replay;
}

std::vector<std::string> differences_of(const FacadeReplay& facade, const KeptRun& run) {
  std::vector<std::string> differences;
  if (facade_json(facade.facade) != text_of(json_of(run.options().output, facade.facade.id)))
    differences.push_back("it is not as in facades/" + facade_name(facade.facade.id) + ".json");
  if (facade.changed_labels > 0)
    differences.push_back(grouped(facade.changed_labels) + " points have another label than in the store");
  return differences;
}

std::vector<std::string> facades_to_replay(const fs::path& out) {
  std::vector<std::string> lines;
  const std::uint32_t count = count_facades(out);
  for (std::uint32_t id = 1; id <= count; ++id) {
    const Facade f = read_facade_json(json_of(out, id));
    lines.push_back(fmt::format("facade:{}  at {:.1f} {:.1f} {:.1f}  {:.1f} x {:.1f} m, {} elements", id, f.origin.x,
                                f.origin.y, f.origin.z, f.width_m, f.height_m, f.elements.size()));
  }
  return lines;
}

}  // namespace ilot
