// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/cad/dxf_writer.h"

#include <fmt/format.h>

#include <map>
#include <vector>

#include "engine/deliverables/drawings/cad/dxf_entities.h"
#include "engine/deliverables/drawings/cad/dxf_objects.h"
#include "engine/deliverables/drawings/cad/dxf_tables.h"
#include "engine/deliverables/drawings/cad/dxf_tags.h"
#include "engine/version.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

constexpr unsigned kFirstHandle = 0x100;  // of layers, blocks and entities; lower ones belong to the skeleton
constexpr double kAttributeText = 1.8;    // mm of paper
constexpr std::size_t kLongestKind = 31;  // letters of a kind in the name of a block

struct DxfBlock {
  DxfBlockName name;
  unsigned begin = 0;  // handle; the next one is that of its end
  int flags = 0;
  std::string entities;
};

// Writes the frame of a block around its entities.
void write_block(DxfTags& tags, const DxfBlock& block, bool paper, std::string& text) {
  const auto frame = [&](const char* type, unsigned handle, const char* kind) {
    tags.add(0, type);
    tags.handle(handle);
    tags.handle(block.name.record, 330);
    tags.add(100, "AcDbEntity");
    if (paper) tags.add(67, 1);
    tags.words({{8, "0"}, {100, kind}});
  };
  frame("BLOCK", block.begin, "AcDbBlockBegin");
  tags.add(2, block.name.name);
  tags.add(70, block.flags);
  tags.point3(10, 0, 0);
  tags.add(3, block.name.name);
  tags.add(1, "");
  text += tags.text() + block.entities;
  tags = {};
  frame("ENDBLK", block.begin + 1, "AcDbBlockEnd");
  text += tags.text();
  tags = {};
}

// "WINDOW" for a window; other characters than letters and digits become hyphens.
std::string block_kind(const std::string& kind) {
  std::string name;
  for (const char c : kind.substr(0, kLongestKind)) {
    const bool lower = c >= 'a' && c <= 'z', other = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name += lower ? static_cast<char>(c - 'a' + 'A') : other ? c : '-';
  }
  return name.empty() ? "OPENING" : name;
}

DrawingBlock at_origin(DrawingBlock block) {
  for (DrawingLine& line : block.lines)
    for (DrawingCorner& c : line.corners) c.x -= block.place.x, c.y -= block.place.y;
  for (DrawingArc& arc : block.arcs) arc.x -= block.place.x, arc.y -= block.place.y;
  block.place = {};
  return block;
}

// The same for two blocks whose pieces lie alike, to the last digit that is written.
std::string shape_of(const DrawingBlock& block, const DrawingLayers& layers) {
  unsigned none = 0;
  std::string shape;
  const auto add = [&](const auto& piece) {
    none = 0;
    DxfEntities one(layers, {}, none);
    one.add(piece);
    shape += one.text();
  };
  for (const DrawingLine& line : block.lines) add(line);
  for (const DrawingArc& arc : block.arcs) add(arc);
  for (const DrawingAttribute& attribute : block.attributes) shape += attribute.tag + "\n";
  return block_kind(block.kind) + "\n" + shape;
}

// Makes the blocks of a drawing and the entities that refer to them.
class Blocks {
 public:
  Blocks(const Drawing& drawing, const DrawingLayers& layers, unsigned& handle)
      : layers_(layers), handle_(handle), height_(drawing.paper_mm(kAttributeText)), references_(layers, {}, handle) {
    for (const DrawingBlock& block : drawing.blocks) references_.add_insert(block, name_for(block), height_);
    for (const DrawingDimension& dimension : drawing.dimensions)
      references_.add_dimension(dimension, picture_of(dimension));
  }
  const std::vector<DxfBlock>& all() const { return all_; }
  std::vector<DxfBlockName> names() const {
    std::vector<DxfBlockName> names;
    for (const DxfBlock& block : all_) names.push_back(block.name);
    return names;
  }
  const std::string& references() const { return references_.text(); }

 private:
  DxfBlock& begin(const std::string& name, int flags) {
    DxfBlock& block = all_.emplace_back();
    block.name = {name, handle_};
    block.begin = handle_ + 1;
    block.flags = flags;
    handle_ += 3;
    return block;
  }
  // Openings of one shape share a block.
  std::string name_for(const DrawingBlock& block) {
    const DrawingBlock own = at_origin(block);
    const auto [known, fresh] = by_shape_.try_emplace(shape_of(own, layers_));
    if (!fresh) return known->second;
    const std::string kind = block_kind(block.kind);
    known->second = fmt::format("{}-{}", kind, ++of_kind_[kind]);
    constexpr int kHasAttributes = 2;
    DxfBlock& made = begin(known->second, own.attributes.empty() ? 0 : kHasAttributes);
    DxfEntities inside(layers_, {made.name.record}, handle_);
    for (const DrawingLine& line : own.lines) inside.add(line);
    for (const DrawingArc& arc : own.arcs) inside.add(arc);
    inside.add_definitions(own, height_);
    made.entities = inside.text();
    return known->second;
  }
  std::string picture_of(const DrawingDimension& dimension) {
    constexpr int kAnonymous = 1;
    std::string name = fmt::format("*D{}", ++dimensions_);
    DxfBlock& made = begin(name, kAnonymous);
    DxfEntities inside(layers_, {made.name.record}, handle_);
    for (const DrawingLine& line : dimension.lines) inside.add(line);
    inside.add(dimension.text);
    made.entities = inside.text();
    return name;
  }

  const DrawingLayers& layers_;
  unsigned& handle_;
  double height_;
  DxfEntities references_;
  std::vector<DxfBlock> all_;
  std::map<std::string, std::string> by_shape_;
  std::map<std::string, int> of_kind_;
  int dimensions_ = 0;
};

std::string blocks_section(const Blocks& blocks) {
  std::string text;
  DxfTags tags;
  tags.words({{0, "SECTION"}, {2, "BLOCKS"}});
  write_block(tags, {{"*Model_Space", kDxfModelSpace}, 0x20, 0, ""}, false, text);
  write_block(tags, {{"*Paper_Space", kDxfPaperSpace}, 0x1C, 0, ""}, true, text);
  for (const DxfBlock& block : blocks.all()) write_block(tags, block, false, text);
  tags.words({{0, "ENDSEC"}});
  return text + tags.text();
}

std::string model_entities(const Drawing& drawing, const DrawingLayers& layers, const Blocks& blocks,
                           unsigned& handle) {
  DxfEntities entities(layers, {}, handle);
  if (drawing.image) entities.add_image(*drawing.image);  // the first is painted first, below all others
  for (const DrawingLine& line : drawing.lines) entities.add(line);
  for (const DrawingArc& arc : drawing.arcs) entities.add(arc);
  for (const DrawingPoint& point : drawing.points) entities.add(point);
  for (const DrawingText& text : drawing.texts) entities.add(text);
  entities.add_paper(drawing.sheet);
  return entities.text() + blocks.references();
}

// The sheet in the paper space: a viewport alone, through which the frame and the title block of the model are seen at
// their scale. LibreCAD knows no paper space and draws all lines and texts that are in one into the model.
std::string paper_entities(const Drawing& drawing, const DrawingLayers& layers, unsigned& handle) {
  DxfEntities entities(layers, {kDxfPaperSpace, true}, handle);
  if (drawing.sheet.width() > 0 && drawing.sheet.height() > 0) entities.add_viewports(drawing);
  return entities.text();
}

}  // namespace

std::string drawing_dxf(const Drawing& drawing, const DrawingLayers& layers) {
  unsigned handle = kFirstHandle;
  const Blocks blocks(drawing, layers, handle);
  DxfTags tables, head, begin, tail;
  write_dxf_tables(tables, drawing, layers, blocks.names(), handle);
  begin.words({{0, "SECTION"}, {2, "ENTITIES"}});
  const std::string entities =
      model_entities(drawing, layers, blocks, handle) + paper_entities(drawing, layers, handle);
  head.add(999, "ilot " + version());
  write_dxf_header(head, drawing, handle);
  tail.words({{0, "ENDSEC"}});
  write_dxf_objects(tail, drawing);
  return head.text() + tables.text() + blocks_section(blocks) + begin.text() + entities + tail.text();
}

void write_drawing_dxf(const std::filesystem::path& path, const Drawing& drawing, const DrawingLayers& layers) {
  write_whole_file(path, drawing_dxf(drawing, layers));
}

}  // namespace ilot
