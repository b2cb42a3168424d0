// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/e57/packets.h"

#include <algorithm>
#include <bit>

#include "engine/cloud/record.h"

namespace ilot::e57 {
namespace {

constexpr std::size_t kSectionHeader = 32, kDataHeader = 6, kPadding = 16;
constexpr std::uint64_t kMostHeld = 16u << 20;
constexpr std::uint64_t kMostConstant = 1024;  // points without any bits
constexpr std::uint8_t kSectionId = 1, kDataPacket = 1, kEmptyPacket = 2;

bool is_read(const Field& field) {
  return field.use != kUses && field.bits > 0;
}

double value_of(const Field& field, std::uint64_t raw) {
  if (field.coding == Coding::f32) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
  if (field.coding == Coding::f64) return std::bit_cast<double>(raw);
  const auto stored = static_cast<std::int64_t>(static_cast<std::uint64_t>(field.minimum) + raw);
  return static_cast<double>(stored) * field.scale + field.offset;
}

}  // namespace

Packets::Packets(Pages& pages, const Scan& scan) : pages_(&pages), fields_(scan.fields.size()) {
  if (!read_section(scan)) at_ = end_ = begin_;
}

bool Packets::fail(const std::string& why) {
  problem_ = why;
  end_ = at_;
  return false;
}

bool Packets::read_section(const Scan& scan) {
  const auto start = pages_->logical(scan.section);
  if (!start) return fail("its points would lie at byte " + std::to_string(scan.section) + ", where there are none");
  begin_ = at_ = *start;
  std::byte head[kSectionHeader];
  if (!pages_->read(*start, head))
    return fail("the page at byte " + std::to_string(pages_->failed_at()) + " is damaged or missing");
  const auto length = load<std::uint64_t>(head + 8);
  const auto data = pages_->logical(load<std::uint64_t>(head + 16));
  if (load<std::uint8_t>(head) != kSectionId || length < kSectionHeader || !data || *data < *start + kSectionHeader)
    return fail("no section of points begins at byte " + std::to_string(scan.section));
  at_ = *data;
  end_ = *start + std::min(length, pages_->size() - *start);
  return true;
}

bool Packets::next(std::vector<std::span<const std::byte>>& pieces) {
  packet_.resize(std::size_t{1} << 16);
  while (at_ < end_) {
    std::byte head[4];
    if (end_ - at_ < sizeof head) return fail("its section ends inside a packet");
    bool whole = pages_->read(at_, head);
    const auto type = load<std::uint8_t>(head);
    const std::size_t length = load<std::uint16_t>(head + 2) + std::size_t{1};
    if (whole && (type > kEmptyPacket || length % 4 != 0))
      return fail("no packet begins at logical byte " + std::to_string(at_));
    if (whole && length > end_ - at_) return fail("its section ends inside a packet");
    const std::span<std::byte> packet = std::span(packet_).first(length);
    whole = whole && (type != kDataPacket || pages_->read(at_, packet));
    if (!whole) return fail("the page at byte " + std::to_string(pages_->failed_at()) + " is damaged or missing");
    if (type == kDataPacket && !split(pieces))
      return fail("the packet at logical byte " + std::to_string(at_) + " contradicts itself");
    at_ += length;
    if (type == kDataPacket) return true;
  }
  return false;
}

// Divides the packet that was read last into its streams.
bool Packets::split(std::vector<std::span<const std::byte>>& pieces) {
  const std::size_t length = load<std::uint16_t>(&packet_[2]) + std::size_t{1};
  std::size_t at = kDataHeader + 2 * fields_;
  if (length < kDataHeader || load<std::uint16_t>(&packet_[4]) != fields_ || at > length) return false;
  pieces.clear();
  for (std::size_t i = 0; i < fields_; ++i) {
    const std::size_t size = load<std::uint16_t>(&packet_[kDataHeader + 2 * i]);
    if (size > length - at) return false;
    pieces.push_back(std::span(packet_).subspan(at, size));
    at += size;
  }
  return true;
}

Extent measure_scan(Pages& pages, const Scan& scan, std::uint64_t& budget) {
  Extent extent{0, scan.problem};
  if (!scan.problem.empty()) return extent;
  if (scan.declared == 0) return {0, Packets(pages, scan).problem()};
  if (std::none_of(scan.fields.begin(), scan.fields.end(), is_read)) {
    if (scan.declared > kMostConstant)
      extent.problem = "all its points are the same, which is hardly meant";
    else
      extent.points = scan.declared;
    return extent;
  }
  Packets packets(pages, scan);
  std::vector<std::uint64_t> bytes(scan.fields.size());
  std::vector<std::span<const std::byte>> pieces;
  while (extent.points < scan.declared && packets.walked() <= budget && packets.next(pieces)) {
    std::uint64_t points = scan.declared, held = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] += pieces[i].size();
      if (is_read(scan.fields[i])) points = std::min(points, bytes[i] * 8 / scan.fields[i].bits);
    }
    for (std::size_t i = 0; i < bytes.size(); ++i)
      if (is_read(scan.fields[i])) held += bytes[i] - std::min(bytes[i], points * scan.fields[i].bits / 8);
    extent.points = points;
    if (held > kMostHeld && points < scan.declared) {
      extent.problem = "its fields do not stand beside each other but more than 16 MiB apart";
      break;
    }
  }
  if (extent.points < scan.declared && extent.problem.empty()) {
    extent.problem = packets.walked() > budget   ? "its points lie where those of other scans do"
                     : packets.problem().empty() ? "its section ends before its points do"
                                                 : packets.problem();
  }
  budget -= std::min(budget, packets.walked());
  return extent;
}

ScanReader::ScanReader(Pages& pages, const Scan& scan)
    : scan_(&scan), packets_(pages, scan), streams_(scan.fields.size()), left_(scan.points) {
  for (Stream& stream : streams_) stream.bytes.resize(kPadding);
}

std::size_t ScanReader::next(std::size_t most, Batch& batch) {
  std::uint64_t count = std::min<std::uint64_t>({left_, most, kBatch});
  while (count > 0 && available() == 0) {
    if (!packets_.next(pieces_)) return 0;
    for (std::size_t i = 0; i < streams_.size(); ++i)
      if (is_read(scan_->fields[i])) append(i, pieces_[i]);
  }
  count = std::min(count, available());
  for (std::size_t i = 0; i < streams_.size(); ++i)
    if (scan_->fields[i].use != kUses) decode(i, static_cast<std::size_t>(count), batch[scan_->fields[i].use]);
  left_ -= count;
  return static_cast<std::size_t>(count);
}

// Returns the number of points whose fields have all arrived.
std::uint64_t ScanReader::available() const {
  std::uint64_t points = UINT64_MAX;
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    if (!is_read(scan_->fields[i])) continue;
    const std::uint64_t bits = (streams_[i].bytes.size() - kPadding) * 8 - streams_[i].bit;
    points = std::min(points, bits / scan_->fields[i].bits);
  }
  return points;
}

void ScanReader::append(std::size_t field, std::span<const std::byte> piece) {
  Stream& stream = streams_[field];
  const auto used = static_cast<std::ptrdiff_t>(stream.bit / 8);
  stream.bytes.erase(stream.bytes.begin(), stream.bytes.begin() + used);
  stream.bit %= 8;
  stream.bytes.resize(stream.bytes.size() - kPadding);
  stream.bytes.insert(stream.bytes.end(), piece.begin(), piece.end());
  stream.bytes.resize(stream.bytes.size() + kPadding);
}

void ScanReader::decode(std::size_t field, std::size_t count, std::array<double, kBatch>& values) {
  const Field& f = scan_->fields[field];
  Stream& stream = streams_[field];
  const std::uint64_t mask = f.bits == 64 ? UINT64_MAX : (std::uint64_t{1} << f.bits) - 1;
  for (std::size_t i = 0; i < count; ++i, stream.bit += f.bits) {
    const std::byte* at = stream.bytes.data() + stream.bit / 8;
    const auto shift = static_cast<unsigned>(stream.bit % 8);
    std::uint64_t raw = load<std::uint64_t>(at) >> shift;
    if (shift + f.bits > 64) raw |= std::to_integer<std::uint64_t>(at[8]) << (64 - shift);
    values[i] = value_of(f, raw & mask);
  }
}

}  // namespace ilot::e57
