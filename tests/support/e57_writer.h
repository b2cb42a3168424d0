// SPDX-License-Identifier: Apache-2.0
// Makes small E57 files for tests byte by byte from the standard. It uses no code of the reader.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace ilot::test {

// One stream. `xml` is the text after the name, such as type="Float" precision="single".
struct E57Field {
  std::string name, xml;
  unsigned bits = 0;
  std::vector<std::uint64_t> stored;  // raw bits of each record
};

struct E57Scan {
  std::string name, xml;  // xml: pose, limits
  std::vector<E57Field> fields;
  std::size_t piece = 600;     // bytes of each stream in a packet
  bool uneven = false;         // pieces have different lengths, so that some streams are ahead of others
  bool other_packets = false;  // there are index and empty packets in between
  std::uint64_t records = 0;   // 0: as many as are stored
};

inline E57Field single_field(const std::string& name, const std::vector<double>& values) {
  E57Field field{name, "type=\"Float\" precision=\"single\"", 32, {}};
  for (const double v : values) field.stored.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(v)));
  return field;
}

inline E57Field double_field(const std::string& name, const std::vector<double>& values) {
  E57Field field{name, "type=\"Float\"", 64, {}};
  for (const double v : values) field.stored.push_back(std::bit_cast<std::uint64_t>(v));
  return field;
}

inline E57Field integer_field(const std::string& name, std::int64_t low, std::int64_t high,
                              const std::vector<std::int64_t>& values, const std::string& scaled = "") {
  E57Field field{name,
                 (scaled.empty() ? "type=\"Integer\"" : "type=\"ScaledInteger\" " + scaled) + " minimum=\"" +
                     std::to_string(low) + "\" maximum=\"" + std::to_string(high) + "\"",
                 0,
                 {}};
  const auto span = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
  while (field.bits < 64 && span >> field.bits != 0) ++field.bits;
  for (const std::int64_t v : values)
    field.stored.push_back(static_cast<std::uint64_t>(v) - static_cast<std::uint64_t>(low));
  return field;
}

inline std::string e57_pose(const std::string& w, const std::string& x, const std::string& y, const std::string& z,
                            const std::string& tx, const std::string& ty, const std::string& tz) {
  const auto leaf = [](const std::string& name, const std::string& v) {
    return "<" + name + " type=\"Float\">" + v + "</" + name + ">";
  };
  return "<pose type=\"Structure\"><rotation type=\"Structure\">" + leaf("w", w) + leaf("x", x) + leaf("y", y) +
         leaf("z", z) + "</rotation><translation type=\"Structure\">" + leaf("x", tx) + leaf("y", ty) + leaf("z", tz) +
         "</translation></pose>";
}

class E57Writer {
 public:
  explicit E57Writer(std::size_t page = 1024) : page_(page), logical_(48, '\0') {}

  void add(const E57Scan& scan) {
    while (logical_.size() % 4 != 0) logical_ += '\0';
    const std::size_t start = logical_.size();
    logical_ += '\1';
    logical_.resize(start + 32);
    const std::string body = packets(scan);
    put64(start + 8, 32 + body.size());
    put64(start + 16, physical(start + 32));
    logical_ += body;
    const std::uint64_t records = scan.records ? scan.records : scan.fields[0].stored.size();
    child_ = "<vectorChild type=\"Structure\"><name type=\"String\"><![CDATA[" + scan.name + "]]></name>" + scan.xml +
             "<points type=\"CompressedVector\" fileOffset=\"" + std::to_string(physical(start)) + "\" recordCount=\"" +
             std::to_string(records) + "\"><prototype type=\"Structure\">";
    for (const E57Field& field : scan.fields) child_ += "<" + field.name + " " + field.xml + "/>";
    child_ += "</prototype><codecs type=\"Vector\"/></points></vectorChild>";
    xml_ += child_;
  }

  // Adds another scan that refers to the points of the last one.
  void claim_again() { xml_ += child_; }

  std::string finish(const std::string& root = "") {
    const std::string xml = "<?xml version=\"1.0\"?>\n<e57Root type=\"Structure\">" + root +
                            "<data3D type=\"Vector\">" + xml_ + "</data3D></e57Root>\n";
    std::memcpy(logical_.data(), "ASTM-E57\1\0\0\0\0\0\0\0", 16);
    put64(24, physical(logical_.size()));
    put64(32, xml.size());
    put64(40, page_);
    logical_ += xml;
    logical_.resize((logical_.size() + page_ - 5) / (page_ - 4) * (page_ - 4));
    put64(16, logical_.size() / (page_ - 4) * page_);
    std::string file;
    for (std::size_t at = 0; at < logical_.size(); at += page_ - 4) file += sealed(logical_.substr(at, page_ - 4));
    return file;
  }

  // Returns a page with its checksum.
  static std::string sealed(const std::string& payload) {
    std::uint32_t c = ~0u;
    for (const char byte : payload) {
      c ^= static_cast<unsigned char>(byte);
      for (int k = 0; k < 8; ++k) c = c >> 1 ^ (c & 1 ? 0x82F63B78u : 0u);
    }
    c = ~c;
    std::string page = payload;
    for (int shift = 24; shift >= 0; shift -= 8) page += static_cast<char>(c >> shift & 255);
    return page;
  }

  // Returns a changed file with the right checksums on all its pages.
  static std::string resealed(const std::string& file, std::size_t page = 1024) {
    std::string out;
    for (std::size_t at = 0; at + page <= file.size(); at += page) out += sealed(file.substr(at, page - 4));
    return out;
  }

 private:
  std::uint64_t physical(std::uint64_t at) const { return at / (page_ - 4) * page_ + at % (page_ - 4); }
  void put64(std::size_t at, std::uint64_t v) { std::memcpy(&logical_[at], &v, 8); }
  static void append16(std::string& out, std::size_t v) {
    out += static_cast<char>(v & 255);
    out += static_cast<char>(v >> 8 & 255);
  }

  static std::string stream_of(const E57Field& field) {
    std::string out((field.stored.size() * field.bits + 7) / 8, '\0');
    std::size_t at = 0;
    for (const std::uint64_t v : field.stored)
      for (unsigned b = 0; b < field.bits; ++b, ++at)
        if (v >> b & 1) out[at / 8] = static_cast<char>(out[at / 8] | 1 << at % 8);
    return out;
  }

  static std::string packets(const E57Scan& scan) {
    std::vector<std::string> streams;
    for (const E57Field& field : scan.fields) streams.push_back(stream_of(field));
    std::vector<std::size_t> at(streams.size());
    std::string out;
    for (std::size_t k = 0;; ++k) {
      std::string head, body;
      for (std::size_t f = 0; f < streams.size(); ++f) {
        const std::size_t wanted = scan.uneven ? 1 + (scan.piece * (1 + (f * 7 + k * 13) % 5)) / 3 : scan.piece;
        const std::size_t size = std::min(wanted, streams[f].size() - at[f]);
        append16(head, size);
        body += streams[f].substr(at[f], size);
        at[f] += size;
      }
      if (body.empty()) return out;
      out += packet(std::string("\1\0", 2), scan.fields.size(), head + body);
      if (!scan.other_packets) continue;
      out += packet(std::string("\0\0", 2), 0, std::string(10 + 16 * k % 64, 'i'));
      out += std::string("\2\0\7\0abcd", 8);
    }
  }

  // Returns a packet: `count` and what follows it, after type, flags and length.
  static std::string packet(const std::string& kind, std::size_t count, const std::string& rest) {
    const std::size_t length = (6 + rest.size() + 3) / 4 * 4;
    std::string out = kind;
    append16(out, length - 1);
    append16(out, count);
    out += rest;
    out.resize(length);
    return out;
  }

  std::size_t page_;
  std::string logical_, xml_, child_;
};

}  // namespace ilot::test
