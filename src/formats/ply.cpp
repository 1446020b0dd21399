// SPDX-License-Identifier: MIT
#include "formats/ply_file.h"
#include "formats/point_formats.h"

namespace freshet {
namespace {

/// Reads a comment: "comment time 0.5" is a note, other comments are ignored.
void read_comment(std::string_view words, PointSink& sink) {
  const std::string_view name = take_word(words);
  if (const auto value = number_in(trimmed(words))) sink.note(name, *value);
}

}  // namespace

void read_ply(std::string_view bytes, PointSink& sink) {
  int vertices = 0;  // elements of that name
  PlyEvents events;
  events.comment = [&](std::string_view words) { read_comment(words, sink); };
  events.element = [&](const PlyElement& element) {
    vertices += element.name == "vertex";
    if (vertices == 0) sink.fail("the first element must be vertex; put the vertices first");
    if (vertices > 1) sink.fail("the element vertex occurs twice; save the file again");
  };
  events.property = [&](const PlyElement& element, const PlyProperty& property) {
    if (element.name != "vertex") return;
    if (property.is_list || property.type.bytes == 0)
      sink.fail("the vertices have a list or a property of unknown type; save them without it");
    sink.name(property.name, element.properties.size() - 1);
  };
  const PlyHeader h = read_ply_header(bytes, sink, events);
  if (vertices == 0) sink.fail("the header has no vertices; save the file again");
  sink.check();
  PlyRows(bytes, h.format, sink).read(h.elements[0], [&](const PlyRow& row, std::uint64_t) {
    sink.add(row.values);
  });
}

}  // namespace freshet
