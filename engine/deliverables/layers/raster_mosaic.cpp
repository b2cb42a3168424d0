// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/raster_mosaic.h"

#include <cpl_conv.h>
#include <fmt/format.h>

#include "engine/deliverables/layers/spatial_reference.h"
#include "engine/markup.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

std::string wkt_of(const Crs& crs) {
  const auto reference = spatial_reference(crs);
  char* text = nullptr;
  if (!reference || reference->exportToWkt(&text) != OGRERR_NONE) return {};
  std::string wkt = text;
  CPLFree(text);
  return wkt;
}

}  // namespace

void write_raster_mosaic(const std::filesystem::path& path, const RasterPlace& place, RasterValue value, double nodata,
                         const Crs& crs, const std::vector<MosaicPart>& parts) {
  std::string text = fmt::format("<VRTDataset rasterXSize=\"{}\" rasterYSize=\"{}\">\n", place.width, place.height);
  if (const std::string wkt = wkt_of(crs); !wkt.empty())
    text += fmt::format("  <SRS dataAxisToSRSAxisMapping=\"1,2\">{}</SRS>\n", escaped_markup(wkt));
  text += fmt::format("  <GeoTransform>{:.17g}, {:.17g}, 0, {:.17g}, 0, {:.17g}</GeoTransform>\n", place.min_x,
                      place.pixel, place.max_y, -place.pixel);
  text += fmt::format("  <VRTRasterBand dataType=\"{}\" band=\"1\">\n    <NoDataValue>{}</NoDataValue>\n",
                      value == RasterValue::real ? "Float32" : "UInt32", nodata);
  for (const MosaicPart& part : parts) {
    text += fmt::format("    <SimpleSource>\n      <SourceFilename relativeToVRT=\"1\">{}</SourceFilename>\n",
                        escaped_markup(part.file));
    text += fmt::format(
        "      <SourceBand>1</SourceBand>\n      <SrcRect xOff=\"0\" yOff=\"0\" xSize=\"{0}\" "
        "ySize=\"{1}\"/>\n      <DstRect xOff=\"{2}\" yOff=\"{3}\" xSize=\"{0}\" ySize=\"{1}\"/>\n",
        part.width, part.height, part.x, part.y);
    text += "    </SimpleSource>\n";
  }
  write_whole_file(path, text + "  </VRTRasterBand>\n</VRTDataset>\n");
}

}  // namespace ilot
