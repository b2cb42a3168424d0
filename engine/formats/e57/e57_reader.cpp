// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include "engine/error.h"
#include "engine/formats/crs.h"
#include "engine/formats/e57/e57.h"
#include "engine/formats/e57/rows.h"
#include "engine/formats/scan_steps.h"

namespace ilot {
namespace {

using namespace e57;

constexpr std::size_t kFileHeader = 48;
constexpr std::uint64_t kMostXml = 16u << 20;
constexpr std::size_t kSample = 1000;
constexpr std::size_t kStepPoints = std::size_t{1} << 17;  // of a scan, from which its angular steps are found
constexpr char kSignature[] = "ASTM-E57";

struct FileHeader {
  std::uint32_t major = 0;
  std::uint64_t length = 0, xml_offset = 0, xml_length = 0, page_size = 0;
};

FileHeader read_header(const InputFile& file) {
  std::byte raw[kFileHeader];
  if (file.read_at(0, raw) < kFileHeader || !looks_like_e57(raw))
    throw Error(file.path().string() + ": is not an E57 file (no ASTM-E57 at byte 0); fetch it again");
  FileHeader header{load<std::uint32_t>(raw + 8), load<std::uint64_t>(raw + 16), load<std::uint64_t>(raw + 24),
                    load<std::uint64_t>(raw + 32), load<std::uint64_t>(raw + 40)};
  if (!std::has_single_bit(header.page_size) || header.page_size < 256 || header.page_size > 65536)
    throw Error(file.path().string() + ": the page size at byte 40 is " + std::to_string(header.page_size) +
                "; fetch the file again");
  return header;
}

std::string read_xml(const InputFile& file, const FileHeader& header, Pages& pages) {
  const std::string place = file.path().string() + ": its XML section at byte " + std::to_string(header.xml_offset);
  const auto begin = pages.logical(header.xml_offset);
  if (!begin || header.xml_length > pages.size() - *begin)
    throw Error(place + " lies behind the end of the file, which was cut off; fetch it again");
  if (header.xml_length > kMostXml) throw Error(place + " is larger than 16 MiB; split the file into fewer scans");
  std::string xml(static_cast<std::size_t>(header.xml_length), '\0');
  if (!pages.read(*begin, std::as_writable_bytes(std::span(xml))))
    throw Error(place + " is damaged (checksum of the page at byte " + std::to_string(pages.failed_at()) +
                "); fetch the file again");
  return xml;
}

void find_crs(const std::string& text, CloudInfo& info) {
  if (text.empty()) return;
  try {
    info.crs = crs_from_text(text);
  } catch (const Error&) {
    info.warnings.push_back("its coordinateMetadata is not understood; give --crs");
  }
}

// Returns the directions from the scanner of the first points of a scan, and their places in its grid if it has one.
std::vector<GridPoint> first_rays(Pages& pages, const Scan& scan, Batch& batch) {
  std::vector<GridPoint> rays;
  ScanReader reader(pages, scan);
  for (std::size_t done = 0; done < kStepPoints;) {
    const std::size_t got = reader.next(kBatch, batch);
    if (got == 0) break;
    done += got;
    for (std::size_t i = 0; i < got; ++i) {
      const auto ray = local_position(scan, batch, i);
      if (!ray || !(dot(*ray, *ray) > 0)) continue;
      const auto place = [&](Use use) { return scan.has(use) ? std::llround(batch[use][i]) : 0; };
      rays.push_back({place(kRow), place(kColumn), *ray});
    }
  }
  return rays;
}

// Uses rows and columns when the points have them, else the order of the points.
AngularSteps steps_of(Pages& pages, const Scan& scan, Batch& batch) {
  if (scan.points == 0) return {};
  const std::vector<GridPoint> rays = first_rays(pages, scan, batch);
  if (scan.has(kRow) && scan.has(kColumn)) return steps_of_grid(rays);
  std::vector<Vec3> in_order;
  for (const GridPoint& p : rays) in_order.push_back(p.ray);
  return steps_of_sequence(in_order);
}

// Finds the place of the scanner (the pose or the origin of spherical coordinates) and how it rotated.
void find_stations(Pages& pages, const std::vector<Scan>& scans, Batch& batch, CloudInfo& info) {
  for (std::size_t s = 0; s < scans.size(); ++s) {
    const Scan& scan = scans[s];
    if (!scan.pose && (scan.cartesian() || !scan.spherical())) continue;
    const AngularSteps steps = steps_of(pages, scan, batch);
    Station station{scan.name, {}, steps.azimuth, steps.elevation};
    if (scan.pose) {
      const auto& r = scan.pose->rotation;
      station.position = scan.pose->translation;
      station.axis = {r[0].z, r[1].z, r[2].z};
    }
    if (s < UINT16_MAX) station.source_id = static_cast<std::uint16_t>(s + 1);  // as in the rows
    info.stations.push_back(station);
  }
}

class E57Reader final : public PointReader {
 public:
  E57Reader(std::unique_ptr<InputFile> file, const FileHeader& header, Pages pages, Description description)
      : file_(std::move(file)),
        pages_(std::move(pages)),
        description_(std::move(description)),
        rows_(description_.scans),
        values_(rows_.columns().size()),
        batch_(std::make_unique<Batch>()) {
    info_.path = file_->path();
    info_.format = "e57";
    info_.warnings = description_.warnings;
    if (header.major != 1) info_.warnings.push_back("its version is " + std::to_string(header.major) + ", not 1");
    measure();
    find_crs(description_.coordinates, info_);
    find_stations(pages_, description_.scans, *batch_, info_);
    plan_.emplace(info_.path, rows_.columns(), sample());
    info_.layout = plan_->layout();
    note_lattice(info_, plan_->lattice());
    rewind();
    release();
  }

  const CloudInfo& info() const override { return info_; }
  bool random_access() const override { return false; }
  std::vector<std::uint64_t> boundaries() const override {
    return info_.points == 0 ? std::vector<std::uint64_t>{0} : std::vector<std::uint64_t>{0, info_.points};
  }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    if (first >= info_.points) return 0;
    if (first < row_) rewind();
    if (!batch_) batch_ = std::make_unique<Batch>();
    while (row_ < first) {
      const std::size_t skipped = next_batch(first - row_);
      if (skipped == 0) return 0;
      row_ += skipped;
    }
    const std::size_t length = info_.layout.record_length;
    const std::size_t rows = std::min(records.size() / length, valid.size());
    std::size_t done = 0;
    while (done < rows) {
      const std::size_t got = next_batch(rows - done);
      if (got == 0) break;
      for (std::size_t i = 0; i < got; ++i) valid[done + i] = encode(i, records.subspan((done + i) * length, length));
      done += got;
    }
    row_ += done;
    if (row_ == info_.points) release();
    return done;
  }

 private:
  // Frees memory, so that with thousands of inputs each read input keeps only its description.
  void release() {
    reader_.reset();
    batch_.reset();
    pages_.release();
  }

  void measure() {
    std::uint64_t budget = pages_.size(), number = 0;
    std::string first_problem;
    for (Scan& scan : description_.scans) {
      ++number;
      const Extent extent = measure_scan(pages_, scan, budget);
      scan.points = extent.points;
      info_.declared_points += scan.declared;
      info_.points += scan.points;
      info_.scans.push_back({scan.name, scan.points});
      if (extent.problem.empty()) continue;
      if (first_problem.empty()) first_problem = extent.problem;
      if (scan.declared == 0) continue;  // some writers give an empty scan no section; nothing is lost
      info_.warnings.push_back("scan " + std::to_string(number) + " (" + scan.name +
                               "): " + std::to_string(scan.points) + " of " + std::to_string(scan.declared) +
                               " points can be read: " + extent.problem);
    }
    if (description_.scans.empty())
      throw Error(info_.path.string() + ": contains no scans; export the points, not only the images");
    if (info_.declared_points == 0 && !first_problem.empty())
      throw Error(info_.path.string() + ": contains no points, and where they would be " + first_problem +
                  "; export the file again");
    if (info_.points == 0 && !first_problem.empty())
      throw Error(info_.path.string() + ": none of its " + std::to_string(info_.declared_points) +
                  " points can be read (" + first_problem + "); fetch or export the file again");
  }

  // Returns some points of every scan, so that the lattice fits all of them.
  std::vector<double> sample() {
    const std::vector<Scan>& scans = description_.scans;
    const std::size_t each = std::max<std::size_t>(1, kSample / scans.size());
    std::vector<double> values;
    for (std::size_t s = 0; s < scans.size() && values.size() < kSample * values_.size(); ++s)
      if (scans[s].points > 0) sample_scan(s, each, values);
    return values;
  }

  // Samples the first points of the scan. When all of these are at one place (rays without an echo are written like
  // this), it searches farther for another place.
  void sample_scan(std::size_t s, std::size_t each, std::vector<double>& values) {
    constexpr std::size_t kLookFarther = 1000;
    const Scan& scan = description_.scans[s];
    ScanReader reader(pages_, scan);
    std::optional<std::array<double, 3>> place;
    bool others = false;
    for (std::size_t looks = 0; looks < kLookFarther && !others; ++looks) {
      const std::size_t got = reader.next(each, *batch_);
      if (got == 0) return;
      for (std::size_t i = 0; i < got; ++i) {
        if (!rows_.fill(scan, s + 1, *batch_, i, values_)) continue;
        const std::array<double, 3> at{values_[0], values_[1], values_[2]};
        others = others || (place && at != *place);
        place = at;
        if (looks == 0 || others) values.insert(values.end(), values_.begin(), values_.end());
      }
    }
  }

  void rewind() {
    row_ = 0;
    scan_ = 0;
    reader_.reset();
  }

  // Decodes points of one scan into the batch.
  std::size_t next_batch(std::uint64_t most) {
    const std::vector<Scan>& scans = description_.scans;
    for (; scan_ < scans.size(); ++scan_, reader_.reset()) {
      if (scans[scan_].points == 0) continue;
      if (!reader_) reader_.emplace(pages_, scans[scan_]);
      const std::size_t got = reader_->next(static_cast<std::size_t>(std::min<std::uint64_t>(most, kBatch)), *batch_);
      if (got > 0) return got;
      if (!reader_->finished()) return 0;
    }
    return 0;
  }

  bool encode(std::size_t i, std::span<std::byte> record) {
    if (rows_.fill(description_.scans[scan_], scan_ + 1, *batch_, i, values_)) return plan_->encode(values_, record);
    std::fill(record.begin(), record.end(), std::byte{0});
    return false;
  }

  std::unique_ptr<InputFile> file_;
  Pages pages_;
  Description description_;
  Rows rows_;
  std::vector<double> values_;
  std::unique_ptr<Batch> batch_;
  CloudInfo info_;
  std::optional<TablePlan> plan_;
  std::uint64_t row_ = 0;
  std::size_t scan_ = 0;
  std::optional<ScanReader> reader_;
};

}  // namespace

bool looks_like_e57(std::span<const std::byte> beginning) {
  constexpr std::size_t kLength = sizeof kSignature - 1;
  return beginning.size() >= kLength && std::memcmp(beginning.data(), kSignature, kLength) == 0;
}

std::unique_ptr<PointReader> open_e57(std::unique_ptr<InputFile> file) {
  const FileHeader header = read_header(*file);
  Pages pages(*file, static_cast<std::size_t>(header.page_size));
  Description description = parse_description(file->path(), read_xml(*file, header, pages));
  return std::make_unique<E57Reader>(std::move(file), header, std::move(pages), std::move(description));
}

}  // namespace ilot
