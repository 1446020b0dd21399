// SPDX-License-Identifier: MIT
/// The formats of point files. A new one is a reader and an entry in the table of
/// point_formats.cpp.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "formats/point_sink.h"

namespace freshet {

/// Calls `sink.fail` if the bytes are not a valid file.
using PointReader = void(std::string_view bytes, PointSink& sink);

/// A format of point files.
struct PointFormat {
  const char* extension;  ///< such as ".ply"
  PointReader* read;
};

/// All formats, in the order of messages.
std::span<const PointFormat> point_formats();

/// The format of a file by its extension, capital or not; null if it is unknown.
const PointFormat* point_format_of(const std::filesystem::path& file);

/// The extensions of all formats: "*.csv, *.ply or *.vtk".
std::string point_extensions();

/// What to do with a file of another format: how the programs that write it export one that is
/// read.
std::string other_format_remedy(const std::filesystem::path& file);

/// CSV: columns between commas, semicolons, tabs or spaces, after a line with their names (see
/// TableText and point_column).
PointReader read_csv;
/// PLY [Turk 1994]: the vertices, ascii, or binary of either byte order. Comments of a word and a
/// number are notes.
PointReader read_ply;
/// Legacy VTK: the points of POLYDATA and UNSTRUCTURED_GRID, ASCII or BINARY (see ArrayColumns).
PointReader read_vtk;
/// VTK XML: the points of PolyData and UnstructuredGrid; ascii, base64 or raw, inline or appended,
/// plain or compressed by zlib (see ArrayColumns). Field data are notes. Needs pugixml and zlib.
PointReader read_vtk_xml;
/// XYZ: a count, a comment and a line per point; or columns only. In the comment, Properties= of
/// extended XYZ names the columns.
PointReader read_xyz;
/// Houdini's classic bgeo, version 5, as Partio writes it; compression by gzip needs zlib (see
/// ArrayColumns).
PointReader read_bgeo;

}  // namespace freshet
