// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/table_text.h"
#include "formats/vtk_array.h"

namespace freshet {
namespace {

/// A VTK XML file: its elements, and the appended data, which may not be valid XML.
struct VtkFile {
  pugi::xml_document elements;
  VtkStorage storage;
  pugi::xml_node root() const { return elements.child("VTKFile"); }
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
    sink.fail("not VTK XML: there is no VTKFile; check the file");
  const auto result = file.elements.load_buffer(text.data(), text.size());
  if (!result) {
    const auto at = std::clamp<std::ptrdiff_t>(result.offset, 0, std::ptrdiff_t(text.size()));
    sink.line = 1 + std::size_t(std::count(text.begin(), text.begin() + at, '\n'));
    sink.fail("this is not whole XML; the file is damaged or cut off");
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
  file.storage.appended = file.storage.raw ? rest : rest.substr(0, rest.find('<'));
}

void check_file(VtkFile& file, const PointSink& sink) {
  const pugi::xml_node root = file.root();
  const std::string_view type = root.attribute("type").as_string(),
                         compressor = root.attribute("compressor").as_string(),
                         header = root.attribute("header_type").as_string("UInt32");
  if (type != "PolyData")
    sink.fail("its type is not PolyData; save the points as *.vtp, in one piece");
  if (root.attribute("byte_order").as_string("LittleEndian") != std::string_view("LittleEndian"))
    sink.fail("its bytes are in big-endian order; save it on a little-endian machine, or as ascii");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    sink.fail("it is compressed by LZ4 or LZMA; save it with ZLib, or without compression");
  if (header != "UInt32" && header != "UInt64")
    sink.fail("its header_type is neither UInt32 nor UInt64; save it again");
  file.storage.compressed = !compressor.empty();
  file.storage.header_bytes = header == "UInt64" ? 8 : 4;
  Offsets offsets;
  file.elements.traverse(offsets);
  std::sort(offsets.found.begin(), offsets.found.end());
  file.storage.offsets = std::move(offsets.found);
}

/// The first array of a name in small letters, which may have capitals.
pugi::xml_node array_named(const pugi::xml_node& piece, std::string_view name) {
  for (const pugi::xml_node& array : piece.child("PointData").children("DataArray"))
    if (plain_name(array.attribute("Name").as_string()) == name) return array;
  return {};
}

int components(const pugi::xml_node& array) {
  return array.attribute("NumberOfComponents").as_int(1);
}

/// An array, and the index of its first column.
struct Source {
  VtkArray array;
  std::size_t column = 0, components = 1;
};

/// The arrays of a piece that fill known columns.
std::vector<Source> sources_of(const pugi::xml_node& piece, const PointSink& sink) {
  std::vector<Source> sources;
  const pugi::xml_node points = piece.child("Points").child("DataArray");
  if (!points) sink.fail("a piece has no points; save the file again");
  if (components(points) != 3) sink.fail("its points are not of 3 numbers; save the file again");
  sources.push_back({{points, "points"}, 0, 3});
  for (const char* name : {"velocity", "v", "velocities", "vel", "u"}) {
    const pugi::xml_node array = array_named(piece, name);
    const bool vague = name == std::string_view("vel") || name == std::string_view("u");
    if (!array || sources.size() > 1 || (vague && components(array) != 3)) continue;
    const char* own_name = array.attribute("Name").as_string();
    if (components(array) != 3)
      sink.fail(fmt::format("array \"{}\": not of 3 numbers a point; save it so, or rename it",
                            own_name));
    sources.push_back({{array, own_name}, 3, 3});
  }
  static constexpr const char* scalars[] = {"density", "pressure", "id"};
  for (std::size_t k = 0; k < 3; ++k)
    if (const pugi::xml_node array = array_named(piece, scalars[k]);
        array && components(array) == 1)
      sources.push_back({{array, scalars[k]}, 6 + k, 1});
  return sources;
}

/// Names the arrays of a piece that are not read.
void skip_arrays(const pugi::xml_node& piece, const std::vector<Source>& sources, PointSink& sink) {
  for (const pugi::xml_node& array : piece.child("PointData").children("DataArray"))
    if (std::none_of(sources.begin(), sources.end(),
                     [&](const Source& source) { return source.array.node == array; }))
      sink.skip(array.attribute("Name").as_string());
}

constexpr const char* columns[] = {"x", "y", "z", "vx", "vy", "vz", "density", "pressure", "id"};

void name_columns(const std::vector<Source>& sources, PointSink& sink) {
  for (const Source& source : sources)
    for (std::size_t c = source.column; c < source.column + source.components; ++c)
      sink.name(columns[c], c);
  sink.check();
}

void read_notes(const VtkFile& file, PointSink& sink) {
  static constexpr const char* notes[][2] = {
      {"TimeValue", "time"}, {"Step", "step"}, {"Dimension", "dimension"}};
  for (const auto& array : file.root().child("PolyData").child("FieldData").children("DataArray"))
    for (const auto& [name, note] : notes)
      if (array.attribute("Name").as_string() == std::string_view(name) &&
          array.attribute("NumberOfTuples").as_int() == 1 && components(array) == 1)
        sink.note(note, read_vtk_array({array, name}, 1, file.storage, sink)[0]);
}

void read_piece(const std::vector<Source>& sources, std::uint64_t points, const VtkFile& file,
                PointSink& sink) {
  std::vector<std::vector<double>> arrays;
  for (const Source& source : sources)
    arrays.push_back(
        sink.reads(source.column)
            ? read_vtk_array(source.array, points * source.components, file.storage, sink)
            : std::vector<double>());
  std::vector<double> row(std::size(columns));
  for (std::uint64_t i = 0; i < points; ++i) {
    for (std::size_t s = 0; s < sources.size(); ++s)
      for (std::size_t c = 0; c < sources[s].components && !arrays[s].empty(); ++c)
        row[sources[s].column + c] = arrays[s][i * sources[s].components + c];
    sink.add(row);
  }
}

}  // namespace

bool reads_vtp() { return true; }

void read_vtp(std::string_view bytes, PointSink& sink) {
  constexpr std::uint64_t most_deflated = 1032;
  VtkFile file;
  read_elements(bytes, file, sink);
  check_file(file, sink);
  read_notes(file, sink);
  std::vector<std::string> first;
  std::uint64_t all = 0;
  for (const pugi::xml_node& piece : file.root().child("PolyData").children("Piece")) {
    const auto points = count_in(piece.attribute("NumberOfPoints").as_string());
    if (!points) sink.fail("a piece has no NumberOfPoints; save the file again");
    if (*points == 0) continue;  // VTK writes an empty piece for empty data
    all += std::min(*points, bytes.size() * most_deflated + 1);
    if (all > bytes.size() * most_deflated)
      sink.fail(
          fmt::format("it tells of {} points, and the file ends before; it is cut off", *points));
    const auto sources = sources_of(piece, sink);
    std::vector<std::string> names;
    for (const Source& source : sources) names.push_back(source.array.name);
    if (first.empty()) {
      name_columns(sources, sink);
      skip_arrays(piece, sources, sink);
    } else if (names != first)
      sink.fail("its pieces have different arrays; merge them into one piece");
    first = names;
    read_piece(sources, *points, file, sink);
  }
}

}  // namespace freshet
