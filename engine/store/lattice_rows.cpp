// SPDX-License-Identifier: Apache-2.0
#include "engine/store/lattice_rows.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/formats/row_buffer.h"
#include "engine/store/columns.h"

namespace ilot {
namespace {

std::uint8_t echoes(const PointFields& f) {
  return static_cast<std::uint8_t>((f.return_count > 1 ? kMultipleReturns : 0) |
                                   (f.return_number < f.return_count ? kNotLastReturn : 0));
}

std::optional<Rejection> rejection_of(const PointFields& f, bool valid, const LatticeMap& lattice,
                                      const IndexFilter& filter, Index3& at) {
  if (!valid) return Rejection::invalid;
  if (!lattice.map(f.x, f.y, f.z, at)) return Rejection::invalid;
  if (f.withheld) return Rejection::withheld;
  if (filter.noise[f.classification]) return Rejection::noise;
  if (filter.keep && !filter.keep->contains(at)) return Rejection::outside;
  return std::nullopt;
}

}  // namespace

LatticeRowReader::LatticeRowReader(const RowSource& source, const InputLattice& lattice, const IndexFilter& filter)
    : source_(source),
      filter_(filter),
      multiple_(lattice.multiple),
      map_(source.reader.info().layout, lattice.unit),
      finest_(source.reader.info().layout, lattice.finest()),
      batch_(rows_at_a_time(source.reader.info().layout.record_length, 1u << 14)),
      records_(batch_ * source.reader.info().layout.record_length),
      valid_(batch_) {
  if (source.first + source.count > kMostRowsOfInput)
    throw Error(source.reader.info().path.string() +
                ": contains more than 17 billion points; cut it into several files first");
}

bool LatticeRowReader::next(LatticeRows& rows) {
  rows.points.clear();
  rows.outside.clear();
  rows.rows = 0;
  const std::uint64_t want = std::min(batch_, source_.count - done_);
  if (want == 0) return false;
  const RecordLayout& layout = source_.reader.info().layout;
  const std::size_t length = layout.record_length;
  const std::uint64_t first = source_.first + done_;
  const std::size_t got =
      source_.reader.read(first, std::span(records_).first(want * length), std::span(valid_).first(want));
  if (got < want)
    throw Error(source_.reader.info().path.string() + ": point " + std::to_string(first + got) +
                " can no longer be read; the file changed during the run");
  for (std::size_t i = 0; i < got; ++i) {
    Index3 at;
    const PointFields f = decode_fields(std::span(records_).subspan(i * length, length), layout.point_format);
    const auto rejection = rejection_of(f, valid_[i] != 0, map_, filter_, at);
    if (rejection != Rejection::invalid) check_lattice(f);
    if (!rejection) rows.points.push_back({at, first + i, f.classification, echoes(f)});
    if (rejection) ++rejected_[static_cast<std::size_t>(*rejection)];
    if (rejection == Rejection::outside) rows.outside.push_back(at);
  }
  if (source_.places != nullptr) source_.places->add(std::span(records_).first(got * length), length);
  done_ += got;
  rows.rows = got;
  return true;
}

// Finds the points that are not on a lattice that is coarser than the scale of their file.
void LatticeRowReader::check_lattice(const PointFields& f) {
  Index3 p;
  if (multiple_ == 1 || off_.size() == kMostOffLattice || !finest_.map(f.x, f.y, f.z, p)) return;
  if (p.x % multiple_ != 0 || p.y % multiple_ != 0 || p.z % multiple_ != 0) off_.insert({p.x, p.y, p.z});
}

std::vector<Index3> LatticeRowReader::off_lattice() const {
  std::vector<Index3> all;
  for (const auto& [x, y, z] : off_) all.push_back({x, y, z});
  return all;
}

}  // namespace ilot
