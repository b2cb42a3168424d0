// SPDX-License-Identifier: Apache-2.0
// The declarations of all columns of blocks. A column has one value for each point, in the order of the points, unless
// its meaning says otherwise. Code that reads a column of records includes the header that defines the record.
#pragma once
#include <span>

#include "engine/store/column.h"

namespace ilot {

struct ChunkBox;
struct Coincident;
struct Contact;
struct FacadeLabel;
struct PackedNormal;
struct PlaneLabel;
struct RoofLabel;
struct SeamEdge;
struct SeamRun;
struct StoredPlaneTally;
struct StoredShapeTally;
struct StreetLabel;
struct Touch;
enum class PointRole : std::uint8_t;

namespace columns {

inline constexpr Column<std::uint64_t> kCodes{
    {"codes", "u64", Pass::index, "all", "Morton code in the tile, ascending: the position"}};
inline constexpr Column<std::uint64_t> kOrder{
    {"order", "u64", Pass::index, "colours, stations, rows", "input file and row (InputOrder)"}};
inline constexpr Column<std::uint8_t> kClass{{"class", "u8", Pass::index, "classes, streets",
                                              "class code of the input; only where roofs or streets are asked for"}};
inline constexpr Column<std::uint8_t> kEchoes{
    {"echoes", "u8", Pass::index, "classes",
     "kMultipleReturns, kNotLastReturn; only where roofs or streets are asked for"}};
inline constexpr Column<ChunkBox> kChunks{
    {"chunks", "ChunkBox", Pass::index, "all", "box of each 1,024 points, one after the other"}};

inline constexpr Column<PointRole> kRole{
    {"role", "PointRole", Pass::classes, "clusters, roofs", "what the point is to buildings"}};

inline constexpr Column<PackedNormal> kNormals{
    {"normals", "PackedNormal", Pass::normals, "planes, labels, classes, rows", "normal and curvature"}};

inline constexpr Column<std::uint32_t> kColour{
    {"colour", "u32", Pass::colours, "planes, labels, facades", "colour of the input (StoredColour)"}};

inline constexpr Column<std::uint16_t> kStation{
    {"station", "u16", Pass::stations, "facades", "station of the run (StationNumber)"}};

inline constexpr Column<std::uint32_t> kSegment{
    {"segment", "u32", Pass::planes, "contacts, labels", "0 = none, else 1 + number of the cell's plane"}};

inline constexpr Column<Contact> kContacts{
    {"contacts", "Contact", Pass::contacts, "contacts", "contacts between planes of cells, ascending by the planes"}};

inline constexpr Column<StoredPlaneTally> kTally{
    {"tally", "StoredPlaneTally", Pass::labels, "labels", "sums over the points of each joined plane, ascending"}};
inline constexpr Column<std::uint32_t> kPlane{{"plane", "u32", Pass::labels,
                                               "adjacency, shapes, boundaries, facades, rows",
                                               "0 = none, else 1 + index of the joined plane"}};

inline constexpr Column<Touch> kTouches{
    {"touches", "Touch", Pass::adjacency, "adjacency", "where planes touch in the cells that begin in the block"}};

inline constexpr Column<StoredShapeTally> kShapeTally{
    {"shape_tally", "StoredShapeTally", Pass::shapes, "shapes", "sums over the points of each shape, ascending"}};
inline constexpr Column<std::uint32_t> kShape{
    {"shape", "u32", Pass::shapes, "rows", "0 = none, else 1 + index of the joined shape"}};

inline constexpr Column<Coincident> kCoincident{
    {"coincident", "Coincident", Pass::boundaries, "boundaries", "points that another point stands for, ascending"}};
inline constexpr Column<SeamRun> kSeamRuns{
    {"seam_runs", "SeamRun", Pass::boundaries, "boundaries", "consecutive edges of one plane"}};
inline constexpr Column<SeamEdge> kSeamEdges{
    {"seam_edges", "SeamEdge", Pass::boundaries, "boundaries", "edges of boundaries, in the order of their runs"}};
inline constexpr Column<std::uint8_t> kBoundary{
    {"boundary", "u8", Pass::boundaries, "rows", "1 = the point is a corner of a boundary"}};

inline constexpr Column<FacadeLabel> kFacade{
    {"facade", "FacadeLabel", Pass::facades, "rows", "facade, element and label of the point"}};

inline constexpr Column<std::uint32_t> kClusterPart{
    {"cluster_part", "u32", Pass::clusters, "clusters", "0 = none, else 1 + cluster among those of the block"}};
inline constexpr Column<std::uint32_t> kCluster{
    {"cluster", "u32", Pass::clusters, "roofs", "0 = none, else 1 + cluster of the whole store"}};

inline constexpr Column<RoofLabel> kRoof{
    {"roof", "RoofLabel", Pass::roofs, "rows", "building, face and label of the point"}};

inline constexpr Column<StreetLabel> kStreet{
    {"street", "StreetLabel", Pass::streets, "rows", "object and label of the point"}};

inline constexpr Column<std::uint32_t> kSorted{{"sorted", "u32", Pass::rows, "colours, stations, rows",
                                                "points by rising input order; written by whoever needs it first"}};
inline constexpr Column<std::uint64_t> kRowOrder{
    {"row_order", "u64", Pass::rows, "rows", "input file and row, ascending: of the columns below"}};
inline constexpr Column<PlaneLabel> kPlaneRows{
    {"rows", "PlaneLabel", Pass::rows, "rows", "final plane, shape, normal and boundary, by rising input order"}};
inline constexpr Column<StreetLabel> kStreetRows{
    {"street_rows", "StreetLabel", Pass::rows, "rows", "street, by rising input order"}};
inline constexpr Column<FacadeLabel> kFacadeRows{
    {"facade_rows", "FacadeLabel", Pass::rows, "rows", "facade, by rising input order"}};
inline constexpr Column<RoofLabel> kRoofRows{
    {"roof_rows", "RoofLabel", Pass::rows, "rows", "roof, by rising input order"}};

}  // namespace columns

// Returns all of the columns above, in their order.
std::span<const ColumnInfo* const> all_columns();

// A pass and the folders beside the blocks in which it keeps its own files.
struct PassInfo {
  const char* name;
  const char* folders;  // separated by blanks; empty = none
  const char* work;
};
const PassInfo& info_of(Pass pass);

}  // namespace ilot
