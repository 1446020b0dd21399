// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "formats/point_arrays.h"
#include "formats/point_formats.h"
#include "formats/vtk_array.h"

namespace freshet {
namespace {

/// A VTK XML file: its elements, and the appended data, which may not be valid XML.
struct VtkFile {
  pugi::xml_document elements;
  VtkStorage storage;
  pugi::xml_node root() const { return elements.child("VTKFile"); }
  /// The PolyData or UnstructuredGrid.
  pugi::xml_node data() const { return root().child(root().attribute("type").as_string()); }
};

/// The offset at which the elements end and the appended data begins [bytes].
std::size_t end_of_elements(std::string_view bytes, const PointSink& sink) {
  const std::size_t appended = bytes.find("<AppendedData");
  if (appended == std::string_view::npos) return bytes.size();
  const std::size_t end = bytes.find('>', appended);
  if (end == std::string_view::npos) sink.fail("the file ends inside a tag; it is cut off");
  return end + 1;
}

/// Collects the offsets of the appended arrays.
struct Offsets final : pugi::xml_tree_walker {
  std::vector<std::uint64_t> found;
  bool for_each(pugi::xml_node& node) override {
    if (const auto offset = count_in(node.attribute("offset").as_string()))
      found.push_back(*offset);
    return true;
  }
};

void read_elements(std::string_view bytes, VtkFile& file, PointSink& sink) {
  const std::size_t end = end_of_elements(bytes, sink);
  std::string text(bytes.substr(0, end));
  if (end < bytes.size()) text += "</AppendedData></VTKFile>";
  if (text.find("<VTKFile") == std::string::npos)
    sink.fail("not VTK XML: the element VTKFile is missing; check the file");
  const auto result = file.elements.load_buffer(text.data(), text.size());
  if (!result) {
    const auto at = std::clamp<std::ptrdiff_t>(result.offset, 0, std::ptrdiff_t(text.size()));
    sink.line = line_at(text, std::size_t(at));
    sink.fail("invalid XML; the file is damaged or cut off");
  }
  if (end < bytes.size() &&
      !bytes.substr(0, bytes.find_last_not_of(" \t\r\n") + 1).ends_with("</VTKFile>"))
    sink.fail("the file ends before </VTKFile>; it is cut off");
  std::string_view rest = bytes.substr(end);
  rest.remove_prefix(std::min(rest.find('_'), rest.size()));
  if (!rest.empty()) rest.remove_prefix(1);
  // base64 ends before the next tag; raw bytes may contain "<" and end by their sizes
  file.storage.raw = file.root().child("AppendedData").attribute("encoding").as_string() ==
                     std::string_view("raw");
  file.storage.text = bytes.substr(0, end);
  file.storage.appended = file.storage.raw ? rest : rest.substr(0, rest.find('<'));
}

void check_file(VtkFile& file, const PointSink& sink) {
  const pugi::xml_node root = file.root();
  const std::string_view type = root.attribute("type").as_string(),
                         compressor = root.attribute("compressor").as_string(),
                         header = root.attribute("header_type").as_string("UInt32"),
                         order = root.attribute("byte_order").as_string("LittleEndian");
  if (type != "PolyData" && type != "UnstructuredGrid")
    sink.fail(
        fmt::format("its type is \"{}\" and must be PolyData or UnstructuredGrid; save the points "
                    "as *.vtp or *.vtu, in one file",
                    shown(type)));
  if (order != "LittleEndian" && order != "BigEndian")
    sink.fail("its byte_order must be LittleEndian or BigEndian; save it again");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    sink.fail("its compressor is LZ4 or LZMA; save it with ZLib, or without compression");
  if (header != "UInt32" && header != "UInt64")
    sink.fail("its header_type must be UInt32 or UInt64; save it again");
  file.storage.big = order == "BigEndian";
  file.storage.compressed = !compressor.empty();
  file.storage.header_bytes = header == "UInt64" ? 8 : 4;
  Offsets offsets;
  file.elements.traverse(offsets);
  std::sort(offsets.found.begin(), offsets.found.end());
  file.storage.offsets = std::move(offsets.found);
}

/// The positions and the arrays of a piece, still without values, and their elements.
struct Piece {
  std::vector<PointArray> arrays;
  std::vector<pugi::xml_node> elements;

  void add(const char* name, const pugi::xml_node& element) {
    arrays.push_back({name, components_of(element)});
    elements.push_back(element);
  }
};

Piece read_piece(const pugi::xml_node& element, const PointSink& sink) {
  Piece piece;
  const pugi::xml_node points = element.child("Points").child("DataArray");
  if (!points) sink.fail("a piece has no points; save the file again");
  if (components_of(points) != 3)
    sink.fail("its points must have 3 components; save the file again");
  piece.add("points", points);
  for (const pugi::xml_node& array : element.child("PointData"))
    if (array.attribute("Name")) piece.add(array.attribute("Name").as_string(), array);
  return piece;
}

void read_notes(const VtkFile& file, PointSink& sink) {
  static constexpr const char* notes[][2] = {
      {"TimeValue", "time"}, {"Step", "step"}, {"Dimension", "dimension"}};
  for (const auto& array : file.data().child("FieldData").children("DataArray"))
    for (const auto& [name, note] : notes)
      if (array.attribute("Name").as_string() == std::string_view(name) &&
          array.attribute("NumberOfTuples").as_int() == 1 && components_of(array) == 1)
        sink.note(note, read_vtk_array({array, name}, 1, file.storage, sink)[0]);
}

void read_values(Piece& piece, const ArrayColumns& columns, std::uint64_t points,
                 const VtkFile& file, PointSink& sink) {
  for (std::size_t k = 0; k < piece.arrays.size(); ++k)
    if (PointArray& array = piece.arrays[k]; columns.reads(k))
      array.values = read_vtk_array({piece.elements[k], array.name}, points * array.components,
                                    file.storage, sink);
}

/// Arrays of cells are never read.
void skip_cell_arrays(const pugi::xml_node& piece, PointSink& sink) {
  for (const pugi::xml_node& array : piece.child("CellData"))
    if (array.attribute("Name")) sink.skip(array.attribute("Name").as_string());
}

}  // namespace

void read_vtk_xml(std::string_view bytes, PointSink& sink) {
  constexpr std::uint64_t most_deflated = 1032;
  VtkFile file;
  read_elements(bytes, file, sink);
  check_file(file, sink);
  read_notes(file, sink);
  std::optional<ArrayColumns> columns;
  std::vector<PointArray> first;
  std::uint64_t all = 0;
  for (const pugi::xml_node& element : file.data().children("Piece")) {
    const auto points = count_in(element.attribute("NumberOfPoints").as_string());
    if (!points)
      sink.fail("the attribute NumberOfPoints of a piece is missing; save the file again");
    if (*points == 0) continue;  // VTK writes an empty piece for empty data
    all += std::min(*points, bytes.size() * most_deflated + 1);
    if (all > bytes.size() * most_deflated)
      sink.fail(
          fmt::format("NumberOfPoints is {}, and the file is too short; it is cut off", *points));
    Piece piece = read_piece(element, sink);
    if (!columns) {
      columns.emplace(piece.arrays, sink);
      skip_cell_arrays(element, sink);
      first = piece.arrays;
    } else if (!std::equal(first.begin(), first.end(), piece.arrays.begin(), piece.arrays.end(),
                           [](const auto& a, const auto& b) { return a.has_form_of(b); }))
      sink.fail("its pieces have different arrays; merge them into one piece");
    read_values(piece, *columns, *points, file, sink);
    columns->add(piece.arrays, *points);
  }
}

}  // namespace freshet
